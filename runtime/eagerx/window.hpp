// A callback's view of a connection: the last messages, oldest first, without a copy.
// SEMANTICS §4.
#pragma once

#include <bit>
#include <cstdint>
#include <eagerx/cursor.hpp>
#include <eagerx/index.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

/// Position of message `seq` in a ring of `Capacity` places. The ring stores no head.
template <std::uint32_t Capacity>
constexpr std::uint32_t ring_position(Seq seq) {
  static_assert(Capacity > 0);
  if constexpr (std::has_single_bit(Capacity)) {
    return static_cast<std::uint32_t>(seq) & (Capacity - 1U);
  } else {
    return static_cast<std::uint32_t>(seq % Capacity);
  }
}

/// The messages of an input at a tick. `MaxSize` is the maximum number of messages (the window of
/// the connection or, for window 0, the maximum that arrives between two ticks); `AlwaysFull`:
/// there are never fewer. Valid until the callback returns.
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
class Window {
 public:
  using value_type = Message;
  using Source = SourceRate;
  static constexpr std::uint32_t kMaxSize = MaxSize;
  static constexpr bool kAlwaysFull = AlwaysFull;

  /// The last `held` of `end` messages.
  constexpr Window(const Message* ring, Seq end, Seq held) : ring_(ring), end_(end) {
    if constexpr (!AlwaysFull) size_.value = static_cast<std::uint32_t>(held);
  }
  constexpr Window(const Message* ring, Received received)
      : Window(ring, received.end, received.held) {}
  /// The last `MaxSize` of `end` messages.
  constexpr Window(const Message* ring, Seq end)
      : Window(ring, end, end < MaxSize ? end : Seq{MaxSize}) {}

  constexpr std::uint32_t size() const {
    if constexpr (AlwaysFull) {
      return MaxSize;
    } else {
      return size_.value;
    }
  }
  constexpr bool empty() const { return size() == 0; }

  /// Message `i`, 0 is the oldest. `i < size()`.
#ifdef EAGERX_CHECKS
  constexpr const Message& operator[](Index i) const {
    const auto place = static_cast<std::uint32_t>(i.below(size(), "window"));
    return ring_[ring_position<Capacity>(seq(place))];
  }
#else
  constexpr const Message& operator[](std::uint32_t i) const {
    return ring_[ring_position<Capacity>(seq(i))];
  }
#endif
  constexpr const Message& front() const {
    return (*this)[0];
  }
  constexpr const Message& back() const {
    return ring_[ring_position<Capacity>(end_ - 1)];
  }

  /// The newest message, or `otherwise` if there is none.
  constexpr Message back_or(const Message& otherwise) const {
    return empty() ? otherwise : back();
  }

  /// Sequence number of message `i` in its channel.
  constexpr Seq seq(std::uint32_t i) const {
    return end_ - size() + i;
  }
  /// Time at which message `i` was sent, in seconds since the reset, without the delay.
  template <class Real>
  constexpr Real sent_s(std::uint32_t i) const {
    return SourceRate::template seconds<Real>(seq(i));
  }
  /// Seconds from message `i` to message `j` by the same times. Unlike a difference of two
  /// sent_s(), it keeps its precision in long runs.
  template <class Real>
  constexpr Real between_s(std::uint32_t i, std::uint32_t j) const {
    return i <= j ? SourceRate::template seconds<Real>(seq(j) - seq(i))
                  : -SourceRate::template seconds<Real>(seq(i) - seq(j));
  }

 private:
  struct Size {
    std::uint32_t value;
  };
  struct Nothing {};

  const Message* ring_;
  Seq end_;
  [[no_unique_address]] std::conditional_t<AlwaysFull, Nothing, Size> size_{};
};

/// An observation as EAGERx gives it to an agent: always `W` messages. Missing ones at the front
/// are copies of the oldest, or 0 if there are none, so that an agent can act immediately.
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t W, bool AlwaysFull>
class PaddedWindow {
 public:
  using value_type = Message;
  using Source = SourceRate;
  constexpr PaddedWindow(const Message* ring, Seq end, Seq held) : window_(ring, end, held) {}
  constexpr PaddedWindow(const Message* ring, Seq end) : window_(ring, end) {}

  static constexpr std::uint32_t size() { return W; }
  constexpr const Message& operator[](std::uint32_t i) const {
    if constexpr (AlwaysFull) {
      return window_[i];
    } else {
      const std::uint32_t missing = W - window_.size();
      if (missing == W) return kMissing;
      return window_[i < missing ? 0 : i - missing];
    }
  }
  constexpr const Message& back() const { return (*this)[W - 1]; }
  /// The number of messages without padding.
  constexpr std::uint32_t received() const { return window_.size(); }
  /// The same without padding.
  constexpr const auto& unpadded() const { return window_; }

 private:
  static constexpr Message kMissing = filled<Message>(ScalarOf<Message>(0));
  Window<Message, SourceRate, Capacity, W, AlwaysFull> window_;
};

}  // namespace eagerx
