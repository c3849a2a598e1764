// The hub's links to all parts of a graph. Each link has its own frames, exchanges and line
// (host.hpp); messages between parts go through the hub. All programs follow one order of messages,
// so the hub never waits for two parts that wait for each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/link/host.hpp>
#include <eagerx/rate.hpp>
#include <tuple>
#include <utility>

namespace eagerx::link {

/// The compile-time constants of a part.
struct PartFacts {
  const char* name;
  const char* target;   // the id of its board, or of Linux
  const char* machine;  // that it runs on; empty: this one, or a board
  std::uint64_t graph;  // Identity::graph
};

/// Selects the link of part `K`.
template <std::size_t K>
struct PartIndex {};

/// A message that one part sends and another reads with a delay reaches that part `lag` ticks of
/// its node later, except the first, which arrives immediately. Whether one arrives at tick `n`.
constexpr bool comes_late(Seq n, Seq lag) {
  return n == 0 || n > lag;
}
constexpr Seq sent_before(Seq n, Seq lag) {
  return n == 0 ? 0 : n - lag;
}

inline constexpr std::uint32_t kNoChannel = UINT32_MAX;

/// The hub's copies of a part's messages, by channel.
struct PartProgress {
  std::uint32_t last = kNoChannel;     // that came
  std::uint32_t awaited = kNoChannel;  // asked for after it
};

/// `Links` are HostLinks, one for each part.
template <class... Links>
class Star {
 public:
  static constexpr std::size_t kParts = sizeof...(Links);

  template <std::size_t K>
  auto& link() {
    return std::get<K>(links_);
  }
  template <std::size_t K>
  const auto& link() const {
    return std::get<K>(links_);
  }
  const PartProgress& progress(std::size_t part) const { return progress_[part]; }

  /// Whether all of them continue.
  bool ok() const {
    return std::apply([](const auto&... link) { return (link.ok() && ...); }, links_);
  }
  template <std::size_t K, class Message>
  void put(PartIndex<K> /*part*/, const Message& message) {
    link<K>().put(message);
  }
  template <std::size_t K, class Message>
  bool get(PartIndex<K> /*part*/, Message& message) {
    return link<K>().get(message);
  }
  /// The same for a message with a channel.
  template <std::size_t K, class Message>
  bool get(PartIndex<K> /*part*/, std::uint32_t channel, Message& message) {
    progress_[K].awaited = channel;
    if (!link<K>().get(message)) return false;
    progress_[K] = {channel, kNoChannel};
    return true;
  }

  /// Whether a hub that supports it (pipeline.hpp) requests messages before it needs them.
  bool is_pipelined() const { return is_pipelined_; }
  void set_pipelined(bool is_pipelined) { is_pipelined_ = is_pipelined; }
  template <std::size_t K>
  bool is_full(PartIndex<K> /*part*/) const {
    return link<K>().is_full();
  }
  template <std::size_t K>
  void submit(PartIndex<K> /*part*/) {
    link<K>().submit();
  }

  void begin_episode(const Episode& episode) {
    for_each([&](auto& link) { link.begin_episode(episode); });
  }
  void begin_step() {
    for_each([](auto& link) { link.begin_step(); });
  }
  void set_late(std::uint64_t in_a_row) {
    for_each([&](auto& link) { link.set_late(in_a_row); });
  }
  void make_safe() {
    for_each([](auto& link) { link.make_safe(); });
  }
  template <class F>
  void for_each(F&& f) {
    std::apply([&](auto&... link) { (f(link), ...); }, links_);
  }

 private:
  std::tuple<Links...> links_{};
  PartProgress progress_[kParts] = {};
  bool is_pipelined_ = false;
};

}  // namespace eagerx::link
