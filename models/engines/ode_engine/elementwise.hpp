// Arrays computed element by element, without a loop.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <utility>

namespace eagerx::models {

/// {f(0), …, f(N − 1)}. A pack expansion instead of a loop: g++ 12 at -O2 turns short loops over
/// small arrays into vector code that is slower than the scalar one. This function and its callers
/// in the integrators are always inlined: a state that passes through memory between two stages
/// costs up to half the speed.
template <class Real, std::size_t N, class F>
[[gnu::always_inline]] inline constexpr Array<Real, N> elementwise(F f) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Array<Real, N>{{f(I)...}};
  }
  (std::make_index_sequence<N>{});
}

}  // namespace eagerx::models
