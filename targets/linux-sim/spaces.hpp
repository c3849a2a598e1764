// Messages that are out of the space that their output is declared with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <iterator>
#include <string>

namespace eagerx::linux_sim {

/// The text of SpaceCounts::first().
std::string space_problem(const char* channel, const Bounds& bounds, std::size_t element, Seq seq,
                          double value);

/// Counts them for each channel, and remembers the first. A message counts once, and NaN is out of
/// every space with bounds.
template <class Graph>
class SpaceCounts {
 public:
  template <class Message>
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

  /// f(name of the channel, count) for each.
  template <class F>
  void for_each_count(F&& f) const {
    for (std::size_t i = 0; i < std::size(counts_); ++i)
      f(std::string("out of its space: ") + Graph::kChannels[i].name, counts_[i]);
  }

  /// "`smooth/filtered` left its space, from -2 to 2: element 0 of message 12 is 2.1"
  std::string first() const {
    if constexpr (requires { Graph::kBounds; }) {
      const Channel& what = Graph::kChannels[channel_];
      const Bounds& bounds = Graph::kBounds[what.first + (what.bounds == 1 ? 0 : element_)];
      return space_problem(what.name, bounds, element_, seq_, value_);
    } else {
      return {};
    }
  }

 private:
  [[gnu::noinline, gnu::cold]] void note(std::uint32_t channel, Seq seq, std::size_t element,
                                         double value) {
    if (total_++ == 0) {
      channel_ = channel;
      seq_ = seq;
      element_ = element;
      value_ = value;
    }
    ++counts_[channel];
  }

  std::uint64_t counts_[std::size(Graph::kChannels)]{};
  std::uint64_t total_ = 0;
  std::uint32_t channel_ = 0;  // of the first
  Seq seq_ = 0;
  std::size_t element_ = 0;
  double value_ = 0.0;
};

/// Of this process, which runs one program.
template <class Graph>
inline constinit SpaceCounts<Graph> spaces_of_run{};

}  // namespace eagerx::linux_sim
