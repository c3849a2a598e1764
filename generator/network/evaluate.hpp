// What a policy answers, as the generated program computes it and as it would be without rounding.
#pragma once

#include <string>
#include <vector>

#include "generator/network/network.hpp"

namespace eagerx::gen {

/// The observation as the first layer takes it: through VecNormalize's statistics, if there are
/// any.
std::vector<float> normalized(const Network& network, std::vector<float> observation);

/// What a network remembers from one observation to the next, layer by layer; empty: nothing yet.
template <class Real>
using Memory = std::vector<std::vector<Real>>;

/// The network's outputs for a (normalised) input, with the bits of the generated program. Without
/// `memory` the input is the first one of its episode.
std::vector<float> evaluate(const Network& network, std::vector<float> input,
                            Memory<float>* memory = nullptr);

/// The same in float64, with the weights as they are in the file.
std::vector<double> evaluate_in_double(const Network& network, const std::vector<float>& input,
                                       Memory<double>* memory = nullptr);

/// Outputs as an action, as predict(deterministic=True) has it: squashed outputs are mapped to the
/// bounds of the contract, others clipped to them; argmax: one number. Without bounds nothing, but
/// for argmax.
std::optional<std::vector<double>> action_of(const Network& network,
                                             const std::vector<float>& outputs);

/// Rows that a policy is known to answer. Outputs and actions are empty where the file has none.
struct GoldenRows {
  std::vector<std::vector<double>> starts;  // one number: whether an episode starts with this row
  std::vector<std::vector<double>> observations;
  std::vector<std::vector<double>> normalized;
  std::vector<std::vector<double>> outputs;         // of the network, as trained: float32
  std::vector<std::vector<double>> outputs_double;  // in float64
  std::vector<std::vector<double>> actions;
};

/// Reads golden rows: a CSV file with a header (obs0, obs1 …, nobs0 …, network_out, action) or an
/// npz file (obs, obs_normalized, network_out, network_out_f64, action). With a column
/// `episode_start` the rows are sequences: a network's memory goes from row to row up to the
/// next 1. Without it every row starts an episode. E0632.
std::optional<GoldenRows> read_golden(const std::string& path, const std::string& name,
                                      Span mention, Diagnostics& diagnostics);

/// A few observations for programs to check their answers on: golden rows, or numbers in -1…1. They
/// take no more than half a kilobyte of flash, answers included, unless one row is larger. Those of
/// a network with a memory are a sequence, the start of one episode.
std::vector<std::vector<float>> self_test_rows(const Network& network, const GoldenRows* rows);

/// How well a network answers golden rows. Errors are against float64.
struct GoldenResult {
  std::size_t rows = 0;
  double ours = 0.0;             // largest error of the generated program
  double theirs = 0.0;           // largest error of the file's float32 outputs
  double limit = 0.0;            // twice theirs, but not below what rounding alone may cost
  std::size_t worst = 0;         // row of the largest error, from 0
  std::optional<double> action;  // largest difference of actions
  double action_limit = 0.0;
  [[nodiscard]] bool passed() const {
    return ours <= limit && (!action || *action <= action_limit);
  }
};

/// For a program, which gets observations as they are: false, and E0633, if the rows were
/// normalised and the network has no statistics.
bool check_normalized(const Network& network, const GoldenRows& rows, const std::string& name,
                      Span mention, Diagnostics& diagnostics);

/// E0632 if the rows do not fit the network, E0633 if they belong to another function.
std::optional<GoldenResult> compare(const Network& network, const GoldenRows& rows,
                                    const std::string& name, Span mention,
                                    Diagnostics& diagnostics);

}  // namespace eagerx::gen
