// Episodes that begin during a step of a batch.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <array>
#include <cstdint>
#include <eagerx/random.hpp>
#include <targets/environments/simd_kernel.hpp>

namespace eagerx::environments {

/// The rows of a step, and the environments that begin an episode at its end. These are collected,
/// because initial states are sampled for several at once.
struct Step {
  static constexpr std::uint32_t kMost = 16;

  explicit Step(const eagerx_rows& of_caller) : rows(of_caller) {}

  const eagerx_rows& rows;
  std::uint32_t waiting = 0;
  std::array<std::uint32_t, kMost> environments;  // the first `waiting`; not zeroed
};

/// sample() of the graph for several episodes at once, if environments run vectorized.
template <class Graph>
class Sampler {
 public:
  using States = typename Graph::States;

  explicit Sampler(const SimdKernel<Graph>& kernel) : sample_(kernel.sample) {
    if (sample_ != nullptr && kernel.most_samples < most_) most_ = kernel.most_samples;
  }

  /// The largest number of them.
  std::uint32_t most() const { return most_; }
  void sample(const EpisodeKey* keys, std::uint32_t count, States* states) const {
    if (sample_ != nullptr && count > 1) {
      sample_(keys, count, states);
    } else {
      for (std::uint32_t i = 0; i < count; ++i) states[i] = Graph::sample(keys[i]);
    }
  }

 private:
  void (*sample_)(const EpisodeKey* keys, std::size_t count, States* states) = nullptr;
  std::uint32_t most_ = Step::kMost;
};

}  // namespace eagerx::environments
