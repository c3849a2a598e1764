// Maps a whole number to a value.
#pragma once

#include <cstddef>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Number k becomes values[k]; numbers outside take the nearest value.
template <class Io>
struct ChooseValue {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Number = ScalarOf<typename Io::Input>;
    constexpr std::size_t kCount = Io::Config::values.size();
    using Value = ScalarOf<typename Io::Output>;
    const Number number = element(in, 0);
    typename Io::Output out{};
    element(out, 0) = static_cast<Value>(Io::Config::values[0]);
    for (std::size_t k = 1; k < kCount; ++k) {
      element(out, 0) = select(number >= static_cast<Number>(k),
                               static_cast<Value>(Io::Config::values[k]), element(out, 0));
    }
    return out;
  }
};

}  // namespace eagerx::models
