// The value that a whole number stands for.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Number k becomes values[k]; numbers outside take the nearest value.
template <class Io>
struct ChooseValue {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Number = ScalarOf<typename Io::Input>;
    constexpr std::size_t kCount = Io::Config::values.size();
    const Number number = element(in, 0);
    std::size_t k = 0;
    while (k + 1 < kCount && number >= static_cast<Number>(k + 1)) ++k;
    typename Io::Output out{};
    element(out, 0) = static_cast<ScalarOf<typename Io::Output>>(Io::Config::values[k]);
    return out;
  }
};

}  // namespace eagerx::models
