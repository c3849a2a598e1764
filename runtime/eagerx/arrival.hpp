// Asynchronous inputs: the clock, not a count, decides which messages a callback sees.
// SEMANTICS §10.
#pragma once

#include <cstdint>
#include <eagerx/cursor.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/window.hpp>

namespace eagerx {

/// The number of messages that a node has sent since the reset, and the times of the last
/// `Capacity` ones, in nanoseconds of the engine's clock.
template <std::uint32_t Capacity>
class Sent {
 public:
  constexpr void reset() { count_ = 0; }
  constexpr Seq count() const { return count_; }
  constexpr void add(std::int64_t now_ns) { at_ns_[ring_position<Capacity>(count_++)] = now_ns; }
  /// When message `seq` was sent; `seq` is one of the last `Capacity`.
  constexpr std::int64_t at_ns(Seq seq) const { return at_ns_[ring_position<Capacity>(seq)]; }

 private:
  Seq count_ = 0;
  std::int64_t at_ns_[Capacity]{};
};

/// Counts of the asynchronous inputs of a program since it began.
struct Arrivals {
  std::uint64_t dropped = 0;     // ticks whose callback was dropped: an input had no message yet
  std::uint64_t overtaken = 0;   // messages that left their ring before they had arrived
  std::uint64_t unanswered = 0;  // episodes whose first observation never was complete

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    f("callbacks without a message", dropped);
    f("messages overtaken", overtaken);
    f("episodes without an observation", unanswered);
  }
};

/// An input that reads a ring of `Capacity` messages: messages sent at least `delay_ns` ago have
/// arrived. `MaxSize` is the maximum size of its window; the ring's sender may write one more
/// message while the window is read.
template <std::uint32_t Capacity, std::uint32_t MaxSize>
class ArrivalCursor {
  static_assert(MaxSize + 1 < Capacity);

 public:
  constexpr void reset(std::int64_t delay_ns) {
    delay_ns_ = delay_ns;
    total_ = 0;
  }
  /// Messages that have arrived by `now_ns`.
  template <std::uint32_t Stamps>
  constexpr Seq take(const Sent<Stamps>& source, std::int64_t now_ns, Arrivals& arrivals) {
    static_assert(Stamps >= Capacity);
    constexpr Seq kUnread = Capacity - MaxSize - 1;  // the number of messages that may be in flight
    const Seq sent = source.count();
    if (sent > total_ + kUnread) {
      arrivals.overtaken += sent - kUnread - total_;
      total_ = sent - kUnread;
    }
    while (total_ < sent && now_ns - source.at_ns(total_) >= delay_ns_) ++total_;
    return total_;
  }
  /// For window 0: the messages that have arrived since the last call.
  template <std::uint32_t Stamps>
  constexpr Received take_new(const Sent<Stamps>& source, std::int64_t now_ns, Arrivals& arrivals) {
    const Seq before = total_;
    const std::uint64_t overtaken = arrivals.overtaken;
    const Seq total = take(source, now_ns, arrivals);
    const Seq fresh = total - before;
    if (fresh <= MaxSize) return {total, fresh};
    // The oldest of the new ones, which take() may have counted.
    const std::uint64_t lost = overtaken + fresh - MaxSize;
    if (lost > arrivals.overtaken) arrivals.overtaken = lost;
    return {total, MaxSize};
  }

 private:
  std::int64_t delay_ns_ = 0;
  Seq total_ = 0;
};

}  // namespace eagerx
