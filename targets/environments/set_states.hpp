// States that a caller has set, in place of drawn ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <targets/environments/layout.hpp>
#include <targets/environments/problem.hpp>
#include <vector>

namespace eagerx::environments {

/// Allocates with the first set().
template <class Graph>
class SetStates {
 public:
  /// Rows of states for the next episodes of `environments`. Throws Problem, with nothing changed.
  void set(std::uint32_t environments, const std::uint8_t* mask, const float* states) {
    const std::size_t numbers = layout_.states.numbers();
    const auto is_meant = [&](std::uint32_t k) { return mask == nullptr || mask[k] != 0; };
    for (std::uint32_t k = 0; k < environments; ++k) {
      const std::string problem = is_meant(k) ? layout_.problem_of(states + k * numbers) : "";
      if (!problem.empty()) throw Problem(problem + " (environment " + std::to_string(k) + ")");
    }
    if (next_.empty()) {
      now_.resize(environments * numbers, std::numeric_limits<float>::quiet_NaN());
      next_ = now_;
    }
    for (std::uint32_t k = 0; k < environments; ++k) {
      if (is_meant(k)) std::copy_n(states + k * numbers, numbers, next_.data() + k * numbers);
    }
  }

  /// An episode of environment `k` begins.
  void begin(std::uint32_t k) {
    if (next_.empty()) return;
    const std::size_t numbers = layout_.states.numbers();
    std::copy_n(next_.data() + k * numbers, numbers, now_.data() + k * numbers);
    std::fill_n(next_.data() + k * numbers, numbers, std::numeric_limits<float>::quiet_NaN());
  }

  /// What is set for its current episode.
  void read(std::uint32_t k, typename Graph::States& states) const {
    if (!now_.empty()) layout_.read(now_.data() + k * layout_.states.numbers(), states);
  }

 private:
  const Layout<Graph>& layout_ = Layout<Graph>::get();
  std::vector<float> now_, next_;  // [environments][state numbers] or empty; NaN: drawn
};

}  // namespace eagerx::environments
