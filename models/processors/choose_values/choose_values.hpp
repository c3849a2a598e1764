// Maps whole numbers to values.
#pragma once

#include <cstddef>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Each number k becomes values[k]; numbers outside take the nearest value.
template <class Io>
struct ChooseValues {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Number = ScalarOf<typename Io::Input>;
    constexpr std::size_t kCount = Io::Config::values.size();
    using Value = ScalarOf<typename Io::Output>;
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      const Number number = element(in, i);
      Value value = static_cast<Value>(Io::Config::values[0]);
      for (std::size_t k = 1; k < kCount; ++k)
        value = select(number >= static_cast<Number>(k), static_cast<Value>(Io::Config::values[k]),
                       value);
      element(out, i) = value;
    }
    return out;
  }
};

}  // namespace eagerx::models
