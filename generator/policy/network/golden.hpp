// Golden rows: observations with known answers, and how closely a network reproduces them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The format of files of golden rows, as help of an error.
inline constexpr const char* kGoldenHelp =
    "columns are obs0, obs1 …, network_out, action; arrays obs, network_out, action";

/// Rows that a policy is known to answer. Outputs and actions are empty where the file has none.
struct GoldenRows {
  std::vector<std::vector<double>> starts;  // one number: whether an episode starts with this row
  std::vector<std::vector<double>> observations;
  std::vector<std::vector<double>> normalized;
  std::vector<std::vector<double>> outputs;         // of the network, as trained: float32
  std::vector<std::vector<double>> outputs_double;  // in float64
  std::vector<std::vector<double>> actions;
  double printed = 0.0;  // half of the last digit that a text has of outputs and actions
};

/// Whether there are `count` rows of `width` numbers, or none at all.
bool all_of_width(const std::vector<std::vector<double>>& rows, std::size_t count,
                  std::size_t width);

/// Whether an episode starts with row `i`.
bool starts_episode(const GoldenRows& rows, std::size_t i);

/// The network's input for row `i`: without statistics, the observation normalized elsewhere.
std::vector<float> input_of_row(const Network& network, const GoldenRows& rows, std::size_t i);

/// `count` rows of `width` numbers in -1…1, the same on every machine.
std::vector<std::vector<float>> sampled_rows(std::size_t count, std::size_t width,
                                             std::uint32_t seed = 1);

/// A few observations for programs to check their answers on: golden rows, or numbers in -1…1. They
/// take at most half a kilobyte of flash, including answers, unless one row is larger. For a
/// network with memory, they are the beginning of one episode.
std::vector<std::vector<float>> self_test_rows(const Network& network, const GoldenRows* rows);

/// Errors of answers, compared with float64 and with the answers in the file.
struct GoldenErrors {
  double ours = 0.0;      // largest error of the generated program, against float64
  double theirs = 0.0;    // largest error of the file's answers, against float64
  double off = 0.0;       // largest difference between the two
  double limit = 0.0;     // what an answer may be off where it is nearest to failing
  std::size_t worst = 0;  // row of it, from 0
  double excess = 0.0;    // how many times its limit an answer is off at most
};

/// Result of comparing a network with golden rows. The tolerance of an answer is the largest of
/// twice the file's own error, 5e-5 of the answer's range in the rows, 1e-5 of its value, and the
/// printed digits. An answer that is at least as close to float64 as the file's never fails.
struct GoldenResult {
  std::size_t rows = 0;
  GoldenErrors outputs;
  std::optional<GoldenErrors> actions;  // nothing: the file has none, or no bounds
  bool has_outputs = false;             // else only our own rounding is known of them
  [[nodiscard]] bool passed() const {
    return !(outputs.excess > 1.0) && !(actions && actions->excess > 1.0);
  }
};

/// For a program, which does not normalise its observations: false, and E0633, if the rows were
/// normalised and the network has no statistics.
bool check_normalized(const Network& network, const GoldenRows& rows, const std::string& name,
                      Span mention, Diagnostics& diagnostics);

/// E0632 if the rows do not fit the network, E0633 if they belong to another function.
std::optional<GoldenResult> compare(const Network& network, const GoldenRows& rows,
                                    const std::string& name, Span mention,
                                    Diagnostics& diagnostics);

}  // namespace eagerx::gen
