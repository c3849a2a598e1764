// Faults of what a controller measures, at random times: whether what leaves is what was declared,
// when it was declared. For Linux and for boards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/safety.hpp>
#include <limits>
#include <type_traits>

namespace own_loop {

/// Counts what the nodes send, and makes a hash of what leaves.
struct CountingHooks {
  std::uint64_t messages = 0;

  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t /*channel*/, eagerx::Seq /*seq*/, const Message& /*message*/) {
    ++messages;
  }
};

enum class Fault : std::uint8_t { none, not_finite, infinite, missing, late, frozen };

struct Report {
  std::uint32_t faults = 0;
  std::uint32_t steps = 0;
  std::uint32_t violations = 0;
  std::uint32_t first_violation = 0;  // which rule, from 1
  std::uint64_t hash = 0;
};

/// `Limits` and `Program` of a graph whose first output is judged. `frozen_after`: steps.
template <class Limits, class Program>
class Trial {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;

  Trial(Program& program, std::uint32_t frozen_after)
      : program_(program), frozen_after_(frozen_after) {}

  Report run(std::uint32_t faults) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      measure();
      check(1, is_safe_value(program_.step(action_)));
      check(1, program_.hooks.messages == 0);
    }
    check(2, program_.steps_before_reset() == 5);
    check(3, is_safe_value(program_.reset({})));
    while (report_.faults < faults) {
      for (std::uint32_t i = 1 + random() % 30; i > 0; --i) step(Fault::none);
      ++report_.faults;
      const auto fault = static_cast<Fault>(1 + random() % 5);
      for (std::uint32_t i = 1 + random() % 40; i > 0; --i) step(fault);
      faulty_ = 0;
    }
    return report_;
  }

 private:
  static constexpr eagerx::Safety kSafety = Limits::kSafety;

  std::uint32_t random() {
    word_ = word_ * 1664525U + 1013904223U;
    return word_ >> 8U;
  }

  void measure() {
    Limits::for_each_action(action_, [&](const char*, auto& message, const auto& space) {
      for (std::size_t i = 0; i < eagerx::size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
        const float share = static_cast<float>(random() & 0xffffU) / 65536.0F;
        const auto low = eagerx::element(space.low, i), high = eagerx::element(space.high, i);
        eagerx::element(message, i) = low + share * (high - low);
      }
    });
  }
  void spoil(float value) {
    bool done = false;  // one channel is enough
    Limits::for_each_action(action_, [&](const char*, auto& message, const auto&) {
      if (!done) eagerx::element(message, 0) = value;
      done = true;
    });
  }

  /// The step of a fault in a row from which on what leaves must be safe.
  std::uint32_t deadline(Fault fault) const {
    switch (fault) {
      case Fault::late:
        return kSafety.late;
      case Fault::frozen:
        return frozen_after_ > 0 ? frozen_after_ - 1
                                 : ~0U;  // the one before the fault is the first
      default:
        return kSafety.holds ? kSafety.missed : 1;
    }
  }

  void step(Fault fault) {
    ++report_.steps;
    faulty_ = fault == Fault::none ? 0 : faulty_ + 1;
    if (fault != Fault::frozen) measure();
    if (fault == Fault::not_finite) spoil(std::numeric_limits<float>::quiet_NaN());
    if (fault == Fault::infinite) spoil(-std::numeric_limits<float>::infinity());
    const std::uint64_t before = program_.hooks.messages;
    const Observation seen = fault == Fault::missing ? program_.step_without()
                             : fault == Fault::late  ? program_.step(action_, faulty_)
                                                     : program_.step(action_);
    const bool ran = program_.hooks.messages != before;
    right_ = fault == Fault::none ? right_ + 1 : 0;
    const bool must_be_safe = faulty_ > 0 && faulty_ >= deadline(fault);
    safe_ = must_be_safe ? safe_ + 1 : 0;
    if (must_be_safe) check(4, !ran);
    if (right_ >= kSafety.recover + 1) check(5, ran);
    judge(seen);
  }

  void judge(const Observation& observed) {
    Observation seen = observed;
    bool first = true;
    Limits::for_each_output(seen, unused_, [&](const auto& window, auto&, const auto& safe) {
      if (!first) return;
      first = false;
      const auto& message = window.back();
      using Message = std::remove_cvref_t<decltype(message)>;
      check(6, safe.space.contains(message));
      for (std::size_t i = 0; i < eagerx::size_of<Message>; ++i) {
        const float x = eagerx::element(message, i);
        const float value = eagerx::element(safe.value, i);
        std::uint32_t bits = 0;
        __builtin_memcpy(&bits, &x, sizeof bits);
        report_.hash = (report_.hash ^ bits) * 0x9e3779b97f4a7c15U;
        report_.hash ^= report_.hash >> 32U;
        if (safe_ > 0) {
          const float moved = x > last_[i] ? x - last_[i] : last_[i] - x;
          const float range =
              eagerx::element(safe.space.high, i) - eagerx::element(safe.space.low, i);
          const auto steps = safe.most_change > 0.0F
                                 ? static_cast<std::uint64_t>(range / safe.most_change) + 1
                                 : 1;
          if (safe.most_change > 0.0F) check(7, moved <= 1.001F * safe.most_change);
          if (safe_ >= safe.hold_steps + steps) check(8, x == value);
        }
        last_[i] = x;
      }
    });
  }

  bool is_safe_value(const Observation& observed) {
    Observation seen = observed;
    bool result = false, first = true;
    Limits::for_each_output(seen, unused_, [&](const auto& window, auto&, const auto& safe) {
      if (first) {
        result = true;
        for (std::size_t i = 0; i < eagerx::size_of<std::remove_cvref_t<decltype(safe.value)>>; ++i)
          result = result && eagerx::element(window.back(), i) == eagerx::element(safe.value, i);
      }
      first = false;
    });
    return result;
  }

  void check(std::uint32_t rule, bool holds) {
    if (holds) return;
    if (report_.violations++ == 0) report_.first_violation = rule;
  }

  Program& program_;
  std::uint32_t frozen_after_;
  typename Limits::Outputs unused_{};
  Action action_{};
  float last_[8]{};
  std::uint32_t word_ = 1;
  std::uint32_t faulty_ = 0;  // steps in a row
  std::uint32_t right_ = 0;
  std::uint32_t safe_ = 0;  // steps in a row in which it must be
  Report report_;
};

}  // namespace own_loop
