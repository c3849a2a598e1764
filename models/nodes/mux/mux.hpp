// Concatenates signals.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = [a, b, c, d], each flattened in row-major order. An input without a message counts as zero;
/// NaN passes.
template <class Io>
class Mux {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    std::size_t next = append(in.a, 0, out);
    next = append(in.b, next, out);
    if constexpr (requires { in.c; }) next = append(in.c, next, out);
    if constexpr (requires { in.d; }) next = append(in.d, next, out);
    static_cast<void>(next);
  }

 private:
  using Real = typename Io::Real;
  using Inputs = typename Io::Inputs;
  static constexpr std::size_t kElements = [] {
    std::size_t count = elements_of<decltype(Inputs::a)> + elements_of<decltype(Inputs::b)>;
    if constexpr (requires(Inputs & in) { in.c; }) count += elements_of<decltype(Inputs::c)>;
    if constexpr (requires(Inputs & in) { in.d; }) count += elements_of<decltype(Inputs::d)>;
    return count;
  }();
  static_assert(kElements == elements_of<decltype(Io::Outputs::y)>,
                "Mux: `size` is the number of elements of all inputs together");

  template <class Window>
  static std::size_t append(const Window& window, std::size_t next, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<Window>;
    for (std::size_t i = 0; i < kSize; ++i) put(out.y, next + i, newest<Real>(window, i));
    return next + kSize;
  }
};

}  // namespace eagerx::models
