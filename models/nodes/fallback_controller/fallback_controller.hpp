// Passes on a primary controller's output, or a fallback's while something is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: `chosen` := `primary`, or `fallback` after `bad` consecutive wrong ticks until
/// `good` consecutive right ones; `safe` if the fallback is not finite. The manifest defines wrong
/// ticks.
template <class Io>
class FallbackController {
 public:
  void reset(const typename Io::States& /*states*/) {
    active_ = false;
    wrong_ = 0;
    right_ = 0;
    primary_age_ = {};
    watched_age_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    choose(is_right(in));
    if constexpr (requires { out.active; }) out.active = active_;
    fallback_ticks_ += active_;
    if (!active_ && is_finite(in.primary)) {
      pass(in.primary, out);
    } else if (is_finite(in.fallback)) {
      pass(in.fallback, out);
    } else {
      ++safe_;
      for (std::size_t i = 0; i < kSize; ++i) {
        element(out.chosen, i) = value_for<Scalar>(Io::Config::safe, i);
      }
    }
  }

  /// Calls f(name, count) for each count; counts continue over episodes.
  template <class F>
  void for_each_count(F&& f) const {
    f("fallback ticks", fallback_ticks_);
    f("fallbacks", fallbacks_);
    f("not finite", not_finite_);
    f("out of range", out_of_range_);
    f("stale", stale_);
    f("safe", safe_);
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::primary)::value_type;
  using Scalar = ScalarOf<Message>;
  static constexpr std::size_t kSize = size_of<Message>;
  static constexpr auto kStale = static_cast<std::uint32_t>(Io::Config::stale);
  static constexpr auto kBad = static_cast<std::uint32_t>(Io::Config::bad);
  static constexpr auto kGood = static_cast<std::uint32_t>(Io::Config::good);

  /// Ticks since an input brought something new.
  struct Age {
    Seq end;  // messages so far
    std::uint32_t ticks;

    template <class Window>
    bool is_stale(const Window& window) {
      const Seq now = window.empty() ? 0 : window.seq(window.size() - 1) + 1;
      ticks = now != end ? 0 : ticks < kStale + 1 ? ticks + 1 : ticks;
      end = now;
      return kStale > 0 && ticks > kStale;
    }
  };

  template <class Window>
  static bool is_finite(const Window& window) {
    if (window.empty()) return false;
    bool finite = true;
    using Each = typename Window::value_type;
    for (std::size_t i = 0; i < size_of<Each>; ++i) {
      finite = finite && eagerx::isfinite(static_cast<Real>(element(window.back(), i)));
    }
    return finite;
  }

  /// Within [low, high]; while the fallback is active, `margin` farther inside.
  template <class Window>
  bool is_in_range(const Window& window) const {
    using Each = typename Window::value_type;
    bool inside = true;
    for (std::size_t i = 0; i < size_of<Each>; ++i) {
      const auto x = static_cast<Real>(element(window.back(), i));
      const Real margin = active_ ? value_for<Real>(Io::Config::margin, i) : Real(0);
      inside = inside && x >= value_for<Real>(Io::Config::low, i) + margin &&
               x <= value_for<Real>(Io::Config::high, i) - margin;
    }
    return inside;
  }

  bool is_right(const typename Io::Inputs& in) {
    bool finite = is_finite(in.primary);
    bool in_range = true;
    bool stale = primary_age_.is_stale(in.primary);
    if constexpr (requires { in.watched; }) {
      const bool number = is_finite(in.watched);
      in_range = !number || is_in_range(in.watched);
      finite = finite && number;
      stale = watched_age_.is_stale(in.watched) || stale;
    }
    not_finite_ += !finite;
    out_of_range_ += !in_range;
    stale_ += stale;
    return finite && in_range && !stale;
  }

  void choose(bool right) {
    if (!right) {
      right_ = 0;
      if (wrong_ < kBad) ++wrong_;
      if (wrong_ < kBad || active_) return;
      active_ = true;
      ++fallbacks_;
    } else {
      wrong_ = 0;
      if (!active_ || kGood == 0) return;
      if (++right_ < kGood) return;
      active_ = false;
      right_ = 0;
    }
  }

  template <class Window>
  static void pass(const Window& window, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      element(out.chosen, i) = static_cast<Scalar>(element(window.back(), i));
    }
  }

  bool active_ = false;
  std::uint32_t wrong_ = 0;  // ticks in a row, up to kBad
  std::uint32_t right_ = 0;  // ticks in a row while the fallback is active
  Age primary_age_{};
  Age watched_age_{};
  std::uint64_t fallback_ticks_ = 0;
  std::uint64_t fallbacks_ = 0;
  std::uint64_t not_finite_ = 0;
  std::uint64_t out_of_range_ = 0;
  std::uint64_t stale_ = 0;
  std::uint64_t safe_ = 0;
};

}  // namespace eagerx::models
