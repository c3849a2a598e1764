// The product of signals.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = a·b·c·d, element by element, multiplied from left to right. An input without a message
/// counts as zero; NaN passes.
template <class Io>
class Product {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      Real product = factor(in.a, i) * factor(in.b, i);
      if constexpr (requires { in.c; }) product *= factor(in.c, i);
      if constexpr (requires { in.d; }) product *= factor(in.d, i);
      put(out.y, i, product);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;

  template <class Window>
  static Real factor(const Window& window, std::size_t i) {
    static_assert(elements_of<Window> == kSize, "Product: all inputs have as many elements as `a`");
    return newest<Real>(window, i);
  }
};

}  // namespace eagerx::models
