// The sum of the callbacks: the same entities with the same windows on plain arrays, called as
// often as in the generated program, without schedule, rings, skips and delays. Its messages are
// other ones.
#include <cstddef>
#include <cstdint>
#include <eagerx/window.hpp>
#include <models/mix/mix.hpp>

#include "loops.hpp"

namespace eagerx::bench {

/// Where the messages of both inputs of a node come from.
struct Sources {
  std::uint16_t a, b;
};

}  // namespace eagerx::bench

#include <by_hand.hpp>

namespace eagerx::bench {
namespace {

constexpr std::uint32_t kMostWindow = 4;

/// The last messages of a node.
struct Messages {
  std::uint32_t last[kMostWindow];
};
Messages messages[kNodes + 1];  // the last one is the action

template <std::uint32_t RateHz, std::uint32_t Size>
using PlainWindow = Window<std::uint32_t, Rate<RateHz>, kMostWindow, Size, true>;

template <std::uint32_t RateHz, std::uint32_t A, std::uint32_t B>
struct PlainIo {
  using Real = float;
  using Rate = eagerx::Rate<RateHz>;
  struct Config {};
  struct Inputs {
    PlainWindow<RateHz, A> a;
    PlainWindow<RateHz, B> b;
  };
  struct Outputs {
    std::uint32_t& mixed;
  };
  struct States {};
};

template <std::uint32_t RateHz, std::uint32_t A>
struct PlainIo<RateHz, A, 0> : PlainIo<RateHz, A, 1> {
  struct Inputs {
    PlainWindow<RateHz, A> a;
  };
};

template <std::uint32_t RateHz, std::uint32_t A, std::uint32_t B, std::size_t Count>
constinit Mix<PlainIo<RateHz, A, B>> group_of_nodes[Count]{};

/// Calls every node of a group once.
template <std::uint32_t RateHz, std::uint32_t A, std::uint32_t B, std::size_t Count>
void run_group(const Sources (&sources)[Count], std::size_t first, Seq tick) {
  using Io = PlainIo<RateHz, A, B>;
  auto& nodes = group_of_nodes<RateHz, A, B, Count>;
  for (std::size_t i = 0; i < Count; ++i) {
    const PlainWindow<RateHz, A> a(messages[sources[i].a].last, A);
    typename Io::Outputs out{messages[first + i].last[0]};
    if constexpr (B > 0) {
      const PlainWindow<RateHz, B> b(messages[sources[i].b].last, B);
      nodes[i].callback(Tick{tick}, {a, b}, out);
    } else {
      nodes[i].callback(Tick{tick}, {a}, out);
    }
  }
}

}  // namespace

std::uint32_t run_by_hand(std::uint64_t steps) {
  // Two steps of the environment at a time, so that every rate is called a whole number of times.
  constexpr int kTogether = 2;
  for (std::uint64_t step = 0; step < steps; step += kTogether) {
    messages[kNodes].last[0] = static_cast<std::uint32_t>(step);
    for_each_group([&]<std::uint32_t RateHz, std::uint32_t A, std::uint32_t B, std::size_t Count>(
                       const Sources(&sources)[Count], std::size_t first) {
      constexpr Seq kTimes = RateHz * kTogether / kEnvironmentHz;
      for (Seq i = 0; i < kTimes; ++i) {
        run_group<RateHz, A, B, Count>(sources, first, step / kTogether * kTimes + i);
      }
    });
  }
  return messages[0].last[0];
}

}  // namespace eagerx::bench
