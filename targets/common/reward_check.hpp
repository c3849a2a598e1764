// Counts rewards that are not finite, on every target, and finds the term that causes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <type_traits>

namespace eagerx::target {

/// Counts a reward that is not finite, with its terms [n], in counts [1 + n]. Returns 1 + the first
/// such term, or 0 for the reward itself, if only the sum is too large.
template <class Real>
std::size_t count_not_finite(const Real* terms, std::size_t n, std::uint32_t* counts) {
  std::size_t first = 0;
  for (std::size_t i = n; i > 0; --i) {
    if (eagerx::isfinite(terms[i - 1])) continue;
    first = i;
    ++counts[i];
  }
  if (first == 0) ++counts[0];
  return first;
}

/// A graph without a task has no reward.
template <class Outcome>
class RewardCheck {
 public:
  void step(const Outcome& /*outcome*/) {}
  template <class F>
  void for_each_count(F&& /*f*/) const {}
};

/// Looks at the reward of each step, which is one comparison: no sum is finite if a term is not.
template <class Outcome>
requires requires {
  Outcome::kTerms;
}
class RewardCheck<Outcome> {
 public:
  void step(const Outcome& outcome) {
    if (!is_finite(outcome)) [[unlikely]]
      add(outcome);
  }
  static bool is_finite(const Outcome& outcome) { return eagerx::isfinite(outcome.reward); }

  /// The cause, as count_not_finite() says.
  [[gnu::noinline]] std::size_t add(const Outcome& outcome) {
    return count_not_finite(&outcome.terms[0], Outcome::kTerms, counts_);
  }

  /// f(name, steps) for each that was not finite: "not finite: task.angle". A name is valid during
  /// its call.
  template <class F>
  void for_each_count(F&& f) const {
    const char* names[Outcome::kTerms + 1];
    for_each_number(Outcome{}, [&](std::size_t place, const char* name, auto /*value*/) {
      names[place] = name;
    });
    for (std::size_t i = 0; i <= Outcome::kTerms; ++i) {
      if (counts_[i] == 0) continue;
      constexpr std::size_t kLongest = 127;
      char text[kLongest + 1];
      std::size_t n = 0;
      for (const char* part : {"not finite: task.", names[i]}) {
        while (*part != '\0' && n < kLongest) text[n++] = *part++;
      }
      text[n] = '\0';
      f(static_cast<const char*>(text), counts_[i]);
    }
  }

  /// f(place, name, value) for the reward and each term.
  template <class F>
  static void for_each_number(const Outcome& outcome, F&& f) {
    std::size_t place = 0;
    outcome.for_each([&](const char* name, auto value) {
      if constexpr (!std::is_same_v<decltype(value), bool>) f(place++, name, value);
    });
  }

 private:
  std::uint32_t counts_[Outcome::kTerms + 1] = {};  // steps: of the reward itself, of each term
};

}  // namespace eagerx::target
