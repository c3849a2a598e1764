// Every element plus a number.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Every element x becomes x + offset, computed in Real.
template <class Io>
struct Offset {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Real = typename Io::Real;
    constexpr auto kOffset = constants<Real>(Io::Config::offset);
    static_assert(is_one_or_each(kOffset, size_of<typename Io::Input>),
                  "Offset: `offset` has one value, or one for each element");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      put(out, i, static_cast<Real>(element(in, i)) + each<Real>(kOffset, i));
    }
    return out;
  }
};

}  // namespace eagerx::models
