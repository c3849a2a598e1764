// Searches like those of std::ranges, on one range and with a projection. std::ranges checks its
// concepts again for every lambda: each `std::ranges::any_of` takes the compiler 28 ms, and these
// take 5. The generator has hundreds.
#pragma once

#include <functional>
#include <iterator>
#include <type_traits>

namespace eagerx::gen::ranges {

struct Itself {
  template <class Value>
  constexpr const Value& operator()(const Value& value) const {
    return value;
  }
};

/// function(value), or the member of `value` that a pointer names.
template <class Function, class Value>
constexpr decltype(auto) applied(Function& function, const Value& value) {
  if constexpr (std::is_member_pointer_v<Function>) {
    return std::invoke(function, value);
  } else {
    return function(value);
  }
}

/// The first one that passes the test; the end of the range, which must outlive it, without one.
template <class Range, class Test, class Projection = Itself>
constexpr auto find_if(Range& range, Test test, Projection projection = {}) {
  auto at = std::begin(range);
  const auto end = std::end(range);
  while (at != end && !applied(test, applied(projection, *at))) ++at;
  return at;
}

template <class Range, class Value, class Projection = Itself>
constexpr auto find(Range& range, const Value& value, Projection projection = {}) {
  auto at = std::begin(range);
  const auto end = std::end(range);
  while (at != end && !(applied(projection, *at) == value)) ++at;
  return at;
}

template <class Range, class Value, class Projection = Itself>
constexpr bool contains(const Range& range, const Value& value, Projection projection = {}) {
  return find(range, value, projection) != std::end(range);
}

template <class Range, class Test, class Projection = Itself>
constexpr bool any_of(const Range& range, Test test, Projection projection = {}) {
  return find_if(range, test, projection) != std::end(range);
}

template <class Range, class Test, class Projection = Itself>
constexpr bool none_of(const Range& range, Test test, Projection projection = {}) {
  return !any_of(range, test, projection);
}

template <class Range, class Test, class Projection = Itself>
constexpr bool all_of(const Range& range, Test test, Projection projection = {}) {
  for (const auto& each : range)
    if (!applied(test, applied(projection, each))) return false;
  return true;
}

}  // namespace eagerx::gen::ranges
