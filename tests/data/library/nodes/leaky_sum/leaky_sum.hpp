// A node of a user's own folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <string_view>

namespace own {

enum class Rounding : std::uint8_t { none, nearest };

/// sum <- (1 - leak) sum + weights[0] first + weights[1] second
template <class Io>
class LeakySum {
 public:
  void reset(const typename Io::States& states) {
    sum_ = states.start.value_or(Sum{});
    ticks_ = static_cast<std::uint16_t>(states.ticks.value_or(0) + 5);
    if (states.unused && (*states.unused)[0]) ++ticks_;
  }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    using Config = typename Io::Config;
    static_assert(std::string_view(Config::label).size() > 0);
    ++ticks_;
    for (std::size_t i = 0; i < 2; ++i) {
      const Real first = in.first.empty() ? Real(0) : static_cast<Real>(in.first.back()[i]);
      const Real second = in.second.empty() ? Real(0) : static_cast<Real>(in.second.back()[i]);
      const Real kept = (Real(1) - static_cast<Real>(Config::leak)) * static_cast<Real>(sum_[i]);
      Real sum = kept + static_cast<Real>(Config::weights[0]) * first +
                 static_cast<Real>(Config::weights[1]) * second;
      if (Config::rounding == Rounding::nearest)
        sum = static_cast<Real>(static_cast<std::int64_t>(sum));
      if (Config::clipped && sum > static_cast<Real>(Config::limits[1]))
        sum = static_cast<Real>(Config::limits[1]);
      if (Config::clipped && sum < static_cast<Real>(Config::limits[0]))
        sum = static_cast<Real>(Config::limits[0]);
      if (ticks_ % Config::every == 0) sum_[i] = static_cast<float>(sum);
      out.sum[i] = sum_[i];
    }
    out.ticks = ticks_;
  }

 private:
  using Real = typename Io::Real;
  using Sum = eagerx::Array<float, 2>;
  Sum sum_{};
  std::uint16_t ticks_ = 0;
};

}  // namespace own
