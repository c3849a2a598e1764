// The pictures of a program: the receiver of connections that only pictures need.
#pragma once

#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx {

/// Hooks that can show pictures have `static constexpr bool kDraws = true`, `bool draws() const`,
/// which does not change during a run, and `show(Rate<...> rate, Seq tick, const Message& message)`
/// for a scene or an image. Nodes that only pictures need run while draws() is true.
template <class Hooks>
inline constexpr bool can_draw = requires {
  requires Hooks::kDraws;
};

struct NoDrawing {};
/// The memory of nodes that only pictures need.
template <class Hooks, class Drawing>
using DrawingOf = std::conditional_t<can_draw<Hooks>, Drawing, NoDrawing>;

/// The node of `render:`.
template <class Io>
class Render {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class Hooks>
  void callback(const Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& /*out*/,
                Hooks& hooks) {
    if (!in.source.empty()) hooks.show(typename Io::Rate{}, tick.n, in.source.back());
  }
};

}  // namespace eagerx
