// Parts of a vector.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// The first sizes[0] elements of the signal are a, the next sizes[1] are b, and so on. Zero before
/// the first signal; NaN passes.
template <class Io>
class Demux {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(begin(Io::Config::sizes.size()) == elements_of<decltype(in.signal)>,
                  "Demux: `sizes` are together the number of elements of `signal`");
    if constexpr (requires { out.a; }) take<0>(in, out.a);
    if constexpr (requires { out.b; }) take<1>(in, out.b);
    if constexpr (requires { out.c; }) take<2>(in, out.c);
    if constexpr (requires { out.d; }) take<3>(in, out.d);
  }

 private:
  using Real = typename Io::Real;

  /// Where part `part` begins.
  static constexpr std::size_t begin(std::size_t part) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < part; ++i) sum += static_cast<std::size_t>(Io::Config::sizes[i]);
    return sum;
  }
  template <std::size_t Part, class Message>
  static void take(const typename Io::Inputs& in, Message& message) {
    static_assert(size_of<Message> == begin(Part + 1) - begin(Part));
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      put(message, i, newest<Real>(in.signal, begin(Part) + i));
    }
  }
};

}  // namespace eagerx::models
