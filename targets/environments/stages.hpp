// Stages of a graph's task: episodes with other states and weights, for trainings.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <eagerx/random.hpp>
#include <iterator>
#include <string>
#include <string_view>
#include <targets/environments/base/description.hpp>
#include <targets/environments/task.hpp>
#include <vector>

namespace eagerx::environments {

/// The stages of a library of a graph with stages; here: none.
template <class Graph>
struct Stages {};

template <class Graph>
constexpr std::size_t count_stages() {
  if constexpr (requires { Stages<Graph>::kNames; }) {
    return std::size(Stages<Graph>::kNames);
  } else {
    return 0;
  }
}

/// The stage of each environment. Allocates nothing without stages.
template <class Graph>
class Staging {
 public:
  static constexpr std::size_t kStages = count_stages<Graph>();

  explicit Staging(std::uint32_t environments)
      : now_(kStages > 0 ? environments : 0, kAsWritten), next_(now_) {}

  /// Sets the stage from the next episode on. Throws Problem, and changes nothing, if the name is
  /// unknown.
  void set(const std::uint8_t* mask, std::string_view name) {
    const std::uint32_t stage = number_of(name);
    for (std::size_t k = 0; k < next_.size(); ++k) {
      if (mask == nullptr || mask[k] != 0) next_[k] = stage;
    }
  }
  /// An episode of environment `k` begins.
  void begin([[maybe_unused]] std::uint32_t k) {
    if constexpr (kStages > 0) now_[k] = next_[k];
  }
  /// The states that the stage samples differently from the graph.
  void sample([[maybe_unused]] std::uint32_t k, [[maybe_unused]] EpisodeKey key,
              [[maybe_unused]] typename Graph::States& states) const {
    if constexpr (kStages > 0) {
      if (now_[k] != kAsWritten) Stages<Graph>::sample(now_[k], key, states);
    }
  }
  /// Writes reward and terms of a step with the stage's weights; term(i): as the graph weighs it.
  template <class Term>
  void weigh([[maybe_unused]] std::uint32_t k, [[maybe_unused]] const eagerx_rows& rows,
             [[maybe_unused]] Term&& term) const {
    if constexpr (kStages > 0) {
      if (now_[k] == kAsWritten) return;
      float reward = 0.0F;
      for (std::size_t i = 0; i < terms_of<Graph>; ++i) {
        const float x = Stages<Graph>::kScales[now_[k]][i] * term(i);
        if (rows.terms != nullptr) rows.terms[k * terms_of<Graph> + i] = x;
        reward += x;
      }
      if (rows.reward != nullptr) rows.reward[k] = reward;
    }
  }

 private:
  static constexpr std::uint32_t kAsWritten = ~std::uint32_t{0};

  static std::uint32_t number_of(std::string_view name) {
    if (name.empty()) return kAsWritten;
    if constexpr (kStages > 0) {
      for (std::uint32_t i = 0; i < kStages; ++i)
        if (name == Stages<Graph>::kNames[i]) return i;
      refuse_stage(std::string(name), Stages<Graph>::kNames);
    }
    refuse_stage(std::string(name), {});
  }

  std::vector<std::uint32_t> now_, next_;  // [environments], or empty
};

template <class Graph>
std::string describe_stages() {
  if constexpr (count_stages<Graph>() > 0)
    return describe_stages(Stages<Graph>::kNames, Stages<Graph>::kUntil);
  return "[]";
}

}  // namespace eagerx::environments
