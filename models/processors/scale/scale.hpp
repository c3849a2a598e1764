// Every element times a factor.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Every element x becomes factor·x, computed in Real.
template <class Io>
struct Scale {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Real = typename Io::Real;
    constexpr auto kFactor = constants<Real>(Io::Config::factor);
    static_assert(is_one_or_each(kFactor, size_of<typename Io::Input>),
                  "Scale: `factor` has one value, or one for each element");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      put(out, i, each<Real>(kFactor, i) * static_cast<Real>(element(in, i)));
    }
    return out;
  }
};

}  // namespace eagerx::models
