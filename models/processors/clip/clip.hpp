// Every element within limits.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Every element is moved into [low, high]. NaN passes.
template <class Io>
struct Clip {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    constexpr auto kLow = constants<Scalar>(Io::Config::low);
    constexpr auto kHigh = constants<Scalar>(Io::Config::high);
    static_assert(is_one_or_each(kLow, size_of<typename Io::Input>) &&
                      is_one_or_each(kHigh, size_of<typename Io::Input>),
                  "Clip: `low` and `high` have one value, or one for each element");
    static_assert(in_order(Io::Config::low, Io::Config::high), "Clip: `low` is not above `high`");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      const Scalar x = element(in, i);
      element(out, i) = eagerx::clamp(x, each<Scalar>(kLow, i), each<Scalar>(kHigh, i));
    }
    return out;
  }
};

}  // namespace eagerx::models
