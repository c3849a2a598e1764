// A policy as deployed: raw observations, actions within their bounds or chosen.
#pragma once

#include <cstdint>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/network.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

/// How a network's outputs become actions: each a number within its bounds, or scores, for each
/// whole number as many as it has values, side by side.
struct Head {
  explicit Head(const Description& description);
  bool chooses = false;
  std::size_t outputs = 0;          // of the network
  std::size_t numbers = 0;          // of an action
  std::vector<float> low, high;     // [numbers] bounds
  std::vector<std::size_t> counts;  // [numbers] scores of each, if it chooses

  /// From -1…1 to the bounds of number `j`; beyond, the bound. As generated programs do it.
  float scaled(std::size_t j, float x) const;
  /// The actions [numbers] of the answers [outputs] in a lane. Of each choice the largest score,
  /// the first of equal ones, as generated programs do it.
  void act(const Simd* answers, std::size_t lane, float* action) const;
};

/// (x - mean) / deviation, at most eight deviations: what the networks see while they learn.
class Normaliser {
 public:
  explicit Normaliser(const Statistics& statistics);
  /// Rows [16][width] to SIMD vectors [width].
  void load(const float* rows, Simd* x) const;

 private:
  std::vector<float> mean_, scale_;
};

/// The actor's network with the normalisation inside of its first layer. Without the limit of eight
/// deviations: on its own data it hardly matters, and a board does less.
std::vector<float> folded(const Network& actor, std::vector<float> parameters,
                          const Statistics& statistics);

/// Changes the first layer so that the network answers as before once its inputs are normalised by
/// `after` instead of `before`: what is learnt must not move with a running mean (as van Hasselt
/// and others 2016 do for outputs). Inputs behind those of the statistics stay as they are.
void keep_answers(const Network& network, std::vector<float>& parameters, const Statistics& before,
                  const Statistics& after);

struct Policy {
  Network network;
  std::vector<float> parameters;  // folded
  Head head;

  /// Outputs, in -1…1 unless they choose, for sixteen observations: rows [16][inputs]. `row`
  /// [network.row()] is scratch, and has the answers at network.output(). What the network
  /// remembers is in it, too: it is 0 when episodes begin, and left as it is between their steps.
  void answer(const Kernels& kernels, const float* rows, Simd* row) const;
};

}  // namespace eagerx::train
