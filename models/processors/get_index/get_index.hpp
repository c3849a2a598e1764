// One element of a message.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Element `index` of the message (row-major), as an array of one element.
template <class Io>
struct GetIndex {
  static typename Io::Output convert(const typename Io::Input& in) {
    constexpr auto kIndex = static_cast<std::size_t>(Io::Config::index);
    static_assert(kIndex < size_of<typename Io::Input>,
                  "GetIndex: `index` is beyond the end of the message");
    return filled<typename Io::Output>(
        static_cast<ScalarOf<typename Io::Output>>(element(in, kIndex)));
  }
};

}  // namespace eagerx::models
