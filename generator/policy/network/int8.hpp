// Weights of eight bits: rounding, the layer's answer, and the rounding error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/policy/network/golden.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The network with weights of eight bits in dense layers, convolutions, GRU and LSTM: for each row
/// of weights whole numbers in -127…127 times the largest magnitude over 127.
Network with_int8_weights(Network network);

/// Rows of weights of eight bits.
struct Int8Rows {
  const std::int8_t* rounded;  // [rows][inputs]
  const float* scales;         // [rows]
  const float* bias;           // [rows]
  std::size_t rows;
};

/// W x + b with the bits of the generated program.
std::vector<float> int8_product(const Int8Rows& rows, const std::vector<float>& x);

/// Rounded weights of a dense layer in the order of eagerx::Int8Weights.
std::vector<int> int8_stored(const Layer& layer);

/// Bytes that a layer takes in flash if its weights have eight bits.
std::size_t int8_bytes(const Layer& layer);

/// The answers with rounded weights against those with the weights of the file.
struct RoundingError {
  std::size_t rows = 0;
  bool golden = false;      // on golden rows, else on numbers in -1…1
  double mean = 0.0;        // over rows, of the largest difference of an output
  double largest = 0.0;     // of an output
  double range = 0.0;       // largest minus smallest output that the weights of the file give
  std::size_t choices = 0;  // rows with another choice, of a policy that chooses
};

/// Compares two networks that differ in their weights on golden rows, or on sampled numbers.
RoundingError rounding_error(const Network& given, const Network& rounded, const GoldenRows* rows);

/// "mean 0.012, largest 0.14 of 2.0 on 1000 golden rows"
std::string to_string(const RoundingError& error);

}  // namespace eagerx::gen
