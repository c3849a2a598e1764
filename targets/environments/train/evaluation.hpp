// Evaluates a policy on episodes that are not used for learning.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/policy.hpp"
#include "targets/environments/train/ranks/together.hpp"

namespace eagerx::train {

/// Observations beyond this number of deviations from the mean are clipped while networks learn.
inline constexpr float kFar = 8.0F;

/// Episode of an evaluation: the first one of an environment of that number and seed, so a program
/// of the graph repeats it with `--seed` and `--environment`.
struct Outcome {
  std::uint64_t seed = 0;
  std::uint32_t environment = 0, steps = 0;
  double sum = 0.0;  // of its rewards
  bool success = false;
};

struct Evaluation {
  std::size_t episodes = 0;
  std::size_t successes = 0;  // `success:` of the task holds at the end of the episode
  double mean_return = 0.0, lowest_return = 0.0, highest_return = 0.0;
  double mean_steps = 0.0;
  std::vector<double> terms;      // [terms] of the return, mean over the episodes
  double saturated = 0.0;         // share of the actions' numbers that are at a bound
  std::vector<double> far;        // [inputs] share of the steps beyond kFar deviations
  std::vector<Outcome> outcomes;  // [episodes]

  /// Whether this fraction of the episodes, 0…1, has succeeded.
  bool passed(double share) const {
    constexpr double kRounding = 1e-9;  // 0.99 of 100 are 99
    return static_cast<double>(successes) + kRounding >= share * static_cast<double>(episodes);
  }
  double success() const {
    return episodes == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(episodes);
  }
  /// As one evaluation of all the episodes.
  void add(const Evaluation& more);
};

class Evaluator {
 public:
  /// `longest`: steps of an episode that the task does not end.
  Evaluator(const Library& library, const Kernels& kernels, ThreadPool& pool, std::uint32_t longest,
            std::size_t episodes, Ranks& ranks = environments::alone());
  ~Evaluator();

  /// Sixteen environments or fewer each.
  std::size_t parts() const;
  environments::Share all() const { return {0, parts()}; }

  /// One episode in each environment of the parts `some`, the first of `seed`. Nothing is sampled.
  /// `observations`: observations far from these statistics are counted. `stage`: of the task;
  /// empty: the graph as written.
  Evaluation run(const Policy& policy, std::uint64_t seed, const Statistics& observations,
                 const std::string& stage, environments::Share some);

  /// Processor time of all runs of this process.
  double spent_s() const;

 private:
  struct Episode;
  struct Result;  // of a part
  class Part;

  environments::Share share_of(std::uint32_t rank, environments::Share some) const;
  std::string bytes_of(environments::Share parts);
  void take(environments::Share parts, const std::string& bytes);
  Evaluation sum(std::size_t inputs, std::uint64_t seed, environments::Share some) const;

  const Kernels& kernels_;
  ThreadPool& pool_;
  Ranks& ranks_;
  const bool has_threads_;
  environments::Share own_;                   // parts of this rank
  std::vector<std::unique_ptr<Part>> parts_;  // [own_]
  std::vector<Result> results_;               // of all parts
  std::vector<double> spent_s_;               // [own_]
};

}  // namespace eagerx::train
