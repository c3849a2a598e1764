#include "generator/tools/monitor/rate_meter.hpp"

#include <algorithm>

namespace eagerx::gen {

void RateMeter::add(std::int64_t at_ns) {
  const std::int64_t number = at_ns / kPartNs;
  Part& part = parts_[static_cast<std::size_t>(number) % kParts];
  if (part.number != number) part = {number, at_ns, at_ns, 0};
  part.last_ns = at_ns;
  ++part.count;
  before_last_ns_ = last_ns_;
  last_ns_ = at_ns;
  ++count_;
}

std::optional<double> RateMeter::hz(std::int64_t now_ns) const {
  constexpr std::uint64_t kFew = 4;
  if (count_ < 2) return std::nullopt;
  const std::int64_t oldest = now_ns / kPartNs - static_cast<std::int64_t>(kParts) + 1;
  std::uint64_t count = 0;
  std::int64_t first_ns = last_ns_;
  for (const Part& part : parts_) {
    if (part.number < oldest || part.count == 0) continue;
    count += part.count;
    first_ns = std::min(first_ns, part.first_ns);
  }
  // Of what comes seldom the last two say more.
  std::uint64_t periods = count > 0 ? count - 1 : 0;
  if (count < kFew) {
    periods = 1;
    first_ns = before_last_ns_;
  }
  const double taken_ns = static_cast<double>(last_ns_ - first_ns);
  const double silent_ns = static_cast<double>(now_ns - last_ns_);
  const double period_ns = taken_ns / static_cast<double>(periods);
  // It may be on its way, but not for longer than that.
  const double shown_ns = silent_ns > 2.0 * period_ns ? std::max(silent_ns, period_ns) : period_ns;
  if (!(shown_ns > 0.0)) return std::nullopt;
  return 1e9 / shown_ns;
}

}  // namespace eagerx::gen
