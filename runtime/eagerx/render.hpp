// What a program shows: the end of the connections that only pictures need.
#pragma once

#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx {

/// A trace that can show pictures has `static constexpr bool kDraws = true`, `bool draws() const`,
/// which does not change during a run, and `show(Rate<...> rate, Seq tick, const Message& message)`
/// for a scene or an image. What only pictures need runs while draws() is true.
template <class Trace>
inline constexpr bool can_draw = requires {
  requires Trace::kDraws;
};

struct NoDrawing {};
/// The memory of what only pictures need.
template <class Trace, class Drawing>
using DrawingOf = std::conditional_t<can_draw<Trace>, Drawing, NoDrawing>;

/// The node of `render:`.
template <class Io>
class Render {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class Trace>
  void callback(const Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& /*out*/,
                Trace& trace) {
    if (!in.source.empty()) trace.show(typename Io::Rate{}, tick.n, in.source.back());
  }
};

}  // namespace eagerx
