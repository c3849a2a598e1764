// The events of a main loop in the test, and the output.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <eagerx/message.hpp>
#include <type_traits>

namespace script {

inline constexpr std::uint64_t kSteps = 200;
inline constexpr std::uint64_t kFails = 30;  // this measurement, and four after it
inline constexpr std::uint64_t kSlow = 90;   // this one takes 2.2 periods
inline constexpr std::uint64_t kHangs = 150;

// With OPTIONAL.
inline constexpr std::uint64_t kReset = 130;
inline bool is_armed(std::uint64_t step) {
  return step < 110 || step >= 117;
}
/// Between steps; all counts of the guard in one number.
template <class Guard>
void print_counts(std::uint64_t step, const Guard& guard, std::uint64_t late_steps) {
  if (step % 20 != 19) return;
  unsigned long long all = 0;
  guard.for_each_count([&](const char* name, std::uint64_t count) {
    for (; *name != '\0'; ++name) all = all * 31 + static_cast<unsigned char>(*name);
    all = all * 31 + count;
  });
  std::printf("guard %016llx, steps too late %llu\n", all,
              static_cast<unsigned long long>(late_steps));
}
template <class StepTimes>
std::uint64_t late_steps(const StepTimes& times) {
  std::uint64_t result = 0;
  bool first = true;
  times.for_each_count([&](const char* /*name*/, std::uint64_t count) {
    if (first) result = count;
    first = false;
  });
  return result;
}

/// Microseconds that reading takes.
template <class Rate>
std::uint64_t reading_us(std::uint64_t step) {
  constexpr double kUsPerSecond = 1e6;
  if (std::getenv("HANG") != nullptr && step == kHangs) return 3'600'000'000;
  return step == kSlow ? static_cast<std::uint64_t>(2.2 * kUsPerSecond * Rate::period_s) : 3;
}

template <class Graph>
typename Graph::Action measured(std::uint64_t step) {
  typename Graph::Action action{};
  unsigned field = 0;
  Graph::for_each_action(action, [&](const char* /*name*/, auto& message, const auto& space) {
    ++field;
    using Message = std::remove_cvref_t<decltype(message)>;
    for (std::size_t i = 0; i < eagerx::size_of<Message>; ++i) {
      const float wave = __builtin_sinf(0.05F * static_cast<float>(step * field + i));
      const bool fails = step >= kFails && step < kFails + 5;
      eagerx::element(message, i) =
          fails ? __builtin_nanf("") : wave * eagerx::element(space.high, i) / 4;
    }
  });
  return action;
}

template <class Observation>
void print(std::uint64_t step, const Observation& outputs) {
  std::printf("%llu", static_cast<unsigned long long>(step));
  outputs.for_each([](const char* name, const auto& window) {
    const auto& message = window.back();
    using Message = std::remove_cvref_t<decltype(message)>;
    for (std::size_t i = 0; i < eagerx::size_of<Message>; ++i) {
      const auto bits = std::bit_cast<std::uint32_t>(eagerx::element(message, i));
      std::printf(" %s %08x", name, static_cast<unsigned>(bits));
    }
  });
  std::printf("\n");
}

}  // namespace script
