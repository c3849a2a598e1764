// Messages outside of the declared space of their output.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <iosfwd>

namespace eagerx::linux_sim {

class CountListener;
struct GraphFacts;

/// Counts them for each channel, and remembers the first. A message counts once, and NaN is out of
/// every space with bounds.
class SpaceCounts {
 public:
  /// Before the run. `counts`: a 0 for each channel.
  void prepare(const GraphFacts& facts, std::uint64_t* counts) {
    facts_ = &facts;
    counts_ = counts;
  }

  template <class Graph, class Message>
  [[gnu::always_inline]] void see(std::uint32_t channel, Seq seq, const Message& message) {
    if constexpr (requires { Graph::kBounds; }) {
      const Channel& what = Graph::kChannels[channel];
      if (what.bounds == 0) return;
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        const Bounds& bounds = Graph::kBounds[what.first + (what.bounds == 1 ? 0 : i)];
        const auto x = static_cast<double>(element(message, i));
        if (!(x >= bounds.low && x <= bounds.high)) [[unlikely]]
          return note(channel, seq, i, x);
      }
    }
  }

  bool is_any() const { return total_ > 0; }
  /// "out of its space: CHANNEL" for each channel.
  void list(CountListener& listener) const;
  /// "`smooth/filtered` left its space, from -2 to 2: element 0 of message 12 is 2.1"
  std::string first() const;

 private:
  [[gnu::noinline, gnu::cold]] void note(std::uint32_t channel, Seq seq, std::size_t element,
                                         double value);

  const GraphFacts* facts_ = nullptr;
  std::uint64_t* counts_ = nullptr;  // [channels]
  std::uint64_t total_ = 0;
  std::uint32_t channel_ = 0;  // of the first
  Seq seq_ = 0;
  std::size_t element_ = 0;
  double value_ = 0.0;
};

}  // namespace eagerx::linux_sim
