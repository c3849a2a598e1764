// Replaces messages that are not finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: `guarded` := the last `signal` if all its elements are finite, else the last one
/// that was for up to `hold` ticks in a row, else `safe`.
template <class Io>
class NanGuard {
 public:
  void reset(const typename Io::States& /*states*/) {
    held_ = Count(kHold);
    for (std::size_t i = 0; i < kSize; ++i) element(last_, i) = safe(i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    using Result = std::remove_cvref_t<decltype(out.guarded)>;
    static_assert(size_of<Result> == kSize,
                  "NanGuard: `guarded` must have as many elements as `signal`");
    const Message signal = in.signal.back_or(filled<Message>(kNan));
    const Truth right = is_finite(signal);
    const Truth holds = !right && held_ < Count(kHold);
    const Truth becomes_safe = !right && !holds && !in.signal.empty();
    for (std::size_t i = 0; i < kSize; ++i) {
      element(last_, i) =
          select(right, element(signal, i), select(holds, element(last_, i), safe(i)));
    }
    held_ = select(right, Count(0U), held_ + one_if<Scalar>(holds));
    replaced_ += one_if<Scalar>(holds || becomes_safe);
    safe_ += one_if<Scalar>(becomes_safe);
    for (std::size_t i = 0; i < kSize; ++i) {
      element(out.guarded, i) = static_cast<ScalarOf<Result>>(element(last_, i));
    }
  }

  /// Calls f(name, count) for each count; counts continue over episodes.
  template <class F>
  void for_each_count(F&& f) const {
    f("replaced", replaced_);
    f("safe", safe_);
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  using Scalar = ScalarOf<Message>;
  using Truth = TruthOf<Scalar>;
  using Count = CountOf<Scalar>;
  static constexpr std::size_t kSize = size_of<Message>;
  static constexpr auto kHold = static_cast<std::uint32_t>(Io::Config::hold);
  static constexpr auto kNan = FloatFormat<LaneOf<Scalar>>::nan;
  static_assert(is_one_or_each(Io::Config::safe, kSize),
                "NanGuard: `safe` has one value, or one for each element");

  static Scalar safe(std::size_t i) { return value_for<Scalar>(Io::Config::safe, i); }
  static Truth is_finite(const Message& message) {
    Truth finite = true;
    for (std::size_t i = 0; i < kSize; ++i)
      finite = finite && eagerx::isfinite(element(message, i));
    return finite;
  }

  Message last_{};
  Count held_{};
  Count replaced_{};
  Count safe_{};
};

}  // namespace eagerx::models
