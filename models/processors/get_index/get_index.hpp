// Some elements of a message.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Element i of the result is element index[i] of the message (row-major).
template <class Io>
struct GetIndex {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(exist(), "GetIndex: `index` is beyond the end of the message");
    typename Io::Output out{};
    static_assert(size_of<typename Io::Output> == Io::Config::index.size());
    for (std::size_t i = 0; i < Io::Config::index.size(); ++i) {
      const auto index = static_cast<std::size_t>(Io::Config::index[i]);
      element(out, i) = static_cast<ScalarOf<typename Io::Output>>(element(in, index));
    }
    return out;
  }

 private:
  static constexpr bool exist() {
    for (const auto index : Io::Config::index) {
      if (index < 0 || static_cast<std::size_t>(index) >= size_of<typename Io::Input>) return false;
    }
    return true;
  }
};

}  // namespace eagerx::models
