// Clocks and windows of environments in one SIMD group that began at different times, and copies of
// one environment into and out of its lane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/cursor.hpp>
#include <eagerx/hooks.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/simd.hpp>
#include <eagerx/trace.hpp>
#include <eagerx/window.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

/// Registers of a SIMD vector: several hide the latency of each other's operations. More than four
/// are spilled, and clang 14 spills four. Measured with tests/bench/environments; bits do not
/// depend on it.
#if defined(EAGERX_SIMD_REGISTERS)
inline constexpr std::size_t kSimdRegisters = EAGERX_SIMD_REGISTERS;
#elif defined(__clang__)
inline constexpr std::size_t kSimdRegisters = 2;
#else
inline constexpr std::size_t kSimdRegisters = 4;
#endif

/// Lanes of a SIMD vector of numbers of type Real: the environments of a SIMD group.
template <class Real, std::size_t Registers = kSimdRegisters>
inline constexpr std::size_t kSimdLanes = Registers* kRegisterBytes / sizeof(Real);

/// Counts of messages or ticks, one per lane.
template <std::size_t N>
using LaneCounts = Simd<std::uint32_t, N>;

/// The number of messages of a channel in each lane, and their place in the rings, which run by the
/// clock of the SIMD group: count + offset. Counts stay below 2^31.
template <std::size_t N>
struct LaneSeq {
  LaneCounts<N> count;
  LaneCounts<N> offset;
};

/// Ticks of a rate so far. Initially no lane holds an environment.
template <std::size_t N>
struct LaneClock {
  Seq shared = 1;  // of the SIMD group: where messages are; tick 0 is of a reset, which is no step
  LaneCounts<N> offset{};  // shared - the environment's own, modulo 2^32

  LaneClock& operator++() { return ++shared, *this; }
  template <class Ticks>
  friend LaneClock operator-(LaneClock clock, Ticks ticks) {
    clock.shared -= static_cast<Seq>(ticks);
    return clock;
  }
  LaneCounts<N> counts() const {
    return LaneCounts<N>(static_cast<std::uint32_t>(shared)) - offset;
  }
  /// A number of messages that end at this clock's place in the ring.
  LaneSeq<N> at(const LaneCounts<N>& count) const { return {count, offset}; }

  operator Seq() const { return shared; }  // NOLINT(google-explicit-constructor): a ring position
  operator LaneSeq<N>() const {            // NOLINT(google-explicit-constructor): as Seq
    return {counts(), offset};
  }

  /// The ticks of the environment in `lane`; below 2^31.
  void load(std::size_t lane, Seq own) {
    set_lane(offset, static_cast<int>(lane), static_cast<std::uint32_t>(shared - own));
  }
  Seq store(std::size_t lane) const {
    return static_cast<std::uint32_t>(shared) - eagerx::lane(offset, static_cast<int>(lane));
  }
};

/// A tick as a message: each lane's own.
template <std::size_t N>
Simd<std::int64_t, N> lane_ticks(const LaneClock<N>& clock) {
  return Simd<std::int64_t, N>(clock.counts());
}

/// A tick of a SIMD group. `n` is the group's tick, which has no meaning for an environment.
template <std::size_t N>
struct LaneTick : Tick {
  LaneCounts<N> counts;

  explicit LaneTick(const LaneClock<N>& clock) : Tick{clock.shared}, counts(clock.counts()) {}
  auto is_first() const { return counts == LaneCounts<N>(0U); }
  Seq in_lane(int lane) const { return eagerx::lane(counts, lane); }
  Tick one(std::size_t lane) const { return {in_lane(static_cast<int>(lane))}; }
};

/// The last messages of a connection whose lanes send at the same ticks: like Window, but lanes may
/// hold fewer messages.
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
class LaneWindow {
 public:
  using value_type = Message;
  using Source = SourceRate;
  static constexpr std::uint32_t kMaxSize = MaxSize;
  static constexpr bool kAlwaysFull = AlwaysFull;
  static constexpr std::size_t kWidth = static_cast<std::size_t>(lanes<ScalarOf<Message>>);
  using Counts = LaneCounts<kWidth>;

  LaneWindow(const Message* ring, const LaneClock<kWidth>& end)
      : ring_(ring), end_(end.shared), count_(end.counts()) {}

  auto size() const {
    if constexpr (AlwaysFull) {
      return MaxSize;
    } else {
      return select(count_ < Counts(MaxSize), count_, Counts(MaxSize));
    }
  }
  /// false, or the mask of empty lanes.
  auto empty() const {
    if constexpr (AlwaysFull) {
      return false;
    } else {
      return count_ == Counts(0U);
    }
  }
  /// Message `i` of a full window, 0 is the oldest.
  const Message& operator[](std::uint32_t i) const {
    return ring_[ring_position<Capacity>(end_ - MaxSize + i)];
  }
  const Message& back() const { return (*this)[MaxSize - 1]; }
  Message back_or(const Message& otherwise) const;

  /// For one lane: messages so far, and their offset in the ring.
  const Message* ring() const { return ring_; }
  Seq received(std::size_t lane) const { return eagerx::lane(count_, static_cast<int>(lane)); }
  std::uint32_t offset(std::size_t lane) const {
    return static_cast<std::uint32_t>(end_) - eagerx::lane(count_, static_cast<int>(lane));
  }

 private:
  const Message* ring_;
  Seq end_;
  Counts count_;
};

/// The same for a connection with delays or skipped messages, whose windows end at different places
/// in each lane.
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
class ScatteredWindow {
 public:
  using value_type = Message;
  using Source = SourceRate;
  static constexpr std::uint32_t kMaxSize = MaxSize;
  static constexpr bool kAlwaysFull = AlwaysFull;
  static constexpr std::size_t kWidth = static_cast<std::size_t>(lanes<ScalarOf<Message>>);
  using Counts = LaneCounts<kWidth>;

  ScatteredWindow(const Message* ring, const LaneSeq<kWidth>& end) : ring_(ring), end_(end) {}

  auto size() const {
    if constexpr (AlwaysFull) {
      return MaxSize;
    } else {
      return select(end_.count < Counts(MaxSize), end_.count, Counts(MaxSize));
    }
  }
  auto empty() const {
    if constexpr (AlwaysFull) {
      return false;
    } else {
      return end_.count == Counts(0U);
    }
  }
  Message operator[](std::uint32_t i) const {
    static_assert(std::has_single_bit(Capacity), "sequence numbers of lanes are modulo 2^32");
    const Counts position =
        (end_.count + end_.offset - Counts(MaxSize - i)) & Counts(Capacity - 1U);
    Message result = ring_[0];
    for (std::uint32_t place = 1; place < Capacity; ++place) {
      const auto here = position == Counts(place);
      for (std::size_t k = 0; k < size_of<Message>; ++k)
        element(result, k) = select(here, element(ring_[place], k), element(result, k));
    }
    return result;
  }
  Message back() const { return (*this)[MaxSize - 1]; }
  Message back_or(const Message& otherwise) const;

  /// As LaneWindow's.
  const Message* ring() const { return ring_; }
  Seq received(std::size_t lane) const { return eagerx::lane(end_.count, static_cast<int>(lane)); }
  std::uint32_t offset(std::size_t lane) const {
    return eagerx::lane(end_.offset, static_cast<int>(lane));
  }

 private:
  const Message* ring_;
  LaneSeq<kWidth> end_;
};

namespace detail {

/// `message`, or `otherwise` in the lanes of `missing`.
template <class Truth, class Message>
Message unless(const Truth& missing, const Message& otherwise, const Message& message) {
  Message result;
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    element(result, i) = select(missing, element(otherwise, i), element(message, i));
  return result;
}

}  // namespace detail

template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
Message LaneWindow<Message, SourceRate, Capacity, MaxSize, AlwaysFull>::back_or(
    const Message& otherwise) const {
  if constexpr (AlwaysFull) {
    return back();
  } else {
    return detail::unless(empty(), otherwise, back());
  }
}
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
Message ScatteredWindow<Message, SourceRate, Capacity, MaxSize, AlwaysFull>::back_or(
    const Message& otherwise) const {
  if constexpr (AlwaysFull) {
    return back();
  } else {
    return detail::unless(empty(), otherwise, back());
  }
}

namespace detail {

/// Message `i` of a window padded to its maximum size: copies of the oldest message if there are
/// fewer, `otherwise` if there are none.
template <class Window, class Message = typename Window::value_type>
Message padded(const Window& window, std::uint32_t i, LaneOf<ScalarOf<Message>> otherwise) {
  if constexpr (Window::kAlwaysFull) {
    return static_cast<void>(otherwise), window[i];
  } else {
    using Counts = typename Window::Counts;
    const Counts missing = Counts(Window::kMaxSize) - window.size();
    Message result = window[Window::kMaxSize - 1];
    for (std::uint32_t k = Window::kMaxSize - 1; k > i; --k)
      result = unless(missing > Counts(k - 1), result, window[k - 1]);
    return unless(window.empty(), filled<Message>(otherwise), result);
  }
}

}  // namespace detail

/// Like PaddedWindow: always the maximum number of messages, padded in front with copies of the
/// oldest, or 0 if there are none.
template <class Window>
class PaddedLanes : Window {
 public:
  using Message = typename Window::value_type;
  using value_type = Message;
  using Window::Window;

  static constexpr std::uint32_t size() { return Window::kMaxSize; }
  /// Returns a reference if the window is always full, because a copy would go through memory.
  decltype(auto) operator[](std::uint32_t i) const {
    const auto& window = static_cast<const Window&>(*this);
    if constexpr (Window::kAlwaysFull) {
      return window[i];
    } else {
      constexpr LaneOf<ScalarOf<Message>> kMissing{};
      return detail::padded(window, i, kMissing);
    }
  }
  decltype(auto) back() const { return (*this)[size() - 1]; }
};

/// As FloorSequence, lane by lane, with values below 2^31.
template <std::int64_t A, std::int64_t B, std::size_t N>
class FloorLanes {
 public:
  using Numbers = Simd<std::int32_t, N>;
  static_assert(A < (std::int64_t{1} << 30) && B < (std::int64_t{1} << 30));

  void advance() {
    rest_ += Numbers(static_cast<std::int32_t>(A % B));
    const auto over = rest_ >= Numbers(static_cast<std::int32_t>(B));
    rest_ = select(over, rest_ - Numbers(static_cast<std::int32_t>(B)), rest_);
    value_ += select(over, Numbers(static_cast<std::int32_t>(A / B) + 1),
                     Numbers(static_cast<std::int32_t>(A / B)));
  }
  const Numbers& value() const { return value_; }

  void load(std::size_t lane, const FloorSequence<A, B>& one) {
    set_lane(value_, static_cast<int>(lane), static_cast<std::int32_t>(one.value_));
    set_lane(rest_, static_cast<int>(lane), static_cast<std::int32_t>(one.rest_));
  }
  void store(std::size_t lane, FloorSequence<A, B>& one) const {
    one.value_ = eagerx::lane(value_, static_cast<int>(lane));
    one.rest_ = eagerx::lane(rest_, static_cast<int>(lane));
  }

 private:
  Numbers value_{};
  Numbers rest_{};
};

/// As DelayCursor, lane by lane.
template <std::int64_t A, std::int64_t B, std::size_t N>
class DelayLanes {
 public:
  LaneCounts<N> take() {
    using Numbers = Simd<std::int32_t, N>;
    const Numbers total = sent_.value() + Numbers(1);
    sent_.advance();
    return LaneCounts<N>(select(total < Numbers(1), Numbers(1), total));
  }
  void load(std::size_t lane, const DelayCursor<A, B>& one) { sent_.load(lane, one.sent_); }
  void store(std::size_t lane, DelayCursor<A, B>& one) const { sent_.store(lane, one.sent_); }

 private:
  FloorLanes<A, B, N> sent_;
};

/// As SkipCursor, lane by lane.
template <std::int64_t A, std::int64_t B, std::int64_t Off, std::size_t N>
class SkipLanes {
 public:
  LaneCounts<N> take() {
    using Numbers = Simd<std::int32_t, N>;
    const LaneCounts<N> now = total_;
    const Numbers before = ahead_.value();
    sent_.advance();
    ahead_.advance();
    const Numbers most = sent_.value() + Numbers(1);
    const Numbers ahead = ahead_.value() - before;
    const Numbers arriving = select(ahead < most, ahead, most);
    total_ += LaneCounts<N>(select(arriving > Numbers(0), arriving, Numbers(0)));
    return now;
  }
  void load(std::size_t lane, const SkipCursor<A, B, Off>& one) {
    sent_.load(lane, one.sent_);
    ahead_.load(lane, one.ahead_);
    set_lane(total_, static_cast<int>(lane), static_cast<std::uint32_t>(one.total_));
  }
  void store(std::size_t lane, SkipCursor<A, B, Off>& one) const {
    sent_.store(lane, one.sent_);
    ahead_.store(lane, one.ahead_);
    one.total_ = eagerx::lane(total_, static_cast<int>(lane));
  }

 private:
  FloorLanes<A, B, N> sent_;
  FloorLanes<A, B, N> ahead_;
  LaneCounts<N> total_{};
};

/// Copies one environment's part of a program into its lane, and back. All members of a part have
/// the width of `Word`, so a lane is every Nth word of the vectorized part.
template <class Word, std::size_t N, class LanesPart, class Part>
[[gnu::always_inline]] inline void check_lane() {
  static_assert(std::is_trivially_copyable_v<Part> && std::is_trivially_destructible_v<LanesPart>);
  static_assert(sizeof(LanesPart) == N * sizeof(Part) && sizeof(Part) % sizeof(Word) == 0,
                "an entity whose manifest says `vectorized: true` has members of type Real, "
                "CountOf<Real>, and arrays of these: others would not be one in each lane");
}
template <class Word, std::size_t N, class LanesPart, class Part>
inline void load_lane(LanesPart& lanes, std::size_t lane, const Part& part) {
  if constexpr (!std::is_empty_v<Part>) {
    check_lane<Word, N, LanesPart, Part>();
    auto* const to = reinterpret_cast<unsigned char*>(&lanes) + lane * sizeof(Word);
    const auto* const from = reinterpret_cast<const unsigned char*>(&part);
#pragma GCC unroll 32
    for (std::size_t i = 0; i < sizeof(Part) / sizeof(Word); ++i)
      std::memcpy(to + i * N * sizeof(Word), from + i * sizeof(Word), sizeof(Word));
  }
}
template <class Word, std::size_t N, class LanesPart, class Part>
inline void store_lane(const LanesPart& lanes, std::size_t lane, Part& part) {
  if constexpr (!std::is_empty_v<Part>) {
    check_lane<Word, N, LanesPart, Part>();
    const auto* const from = reinterpret_cast<const unsigned char*>(&lanes) + lane * sizeof(Word);
    auto* const to = reinterpret_cast<unsigned char*>(&part);
#pragma GCC unroll 32
    for (std::size_t i = 0; i < sizeof(Part) / sizeof(Word); ++i)
      std::memcpy(to + i * sizeof(Word), from + i * N * sizeof(Word), sizeof(Word));
  }
}

template <class LanesMessage, class Message>
void load_message(LanesMessage& to, std::size_t lane, const Message& from) {
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    set_lane(element(to, i), static_cast<int>(lane), element(from, i));
}
template <class LanesMessage, class Message>
void store_message(const LanesMessage& from, std::size_t lane, Message& to) {
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    element(to, i) = eagerx::lane(element(from, i), static_cast<int>(lane));
}

/// Copies a ring, whose places follow the environment's own clock in its program, and the group's
/// clock in a SIMD group.
template <std::size_t N, class LanesMessage, class Message, std::size_t Capacity>
void load_ring(LanesMessage (&ring)[Capacity], const LaneClock<N>& clock, std::size_t lane,
               const Message (&from)[Capacity]) {
  const std::uint32_t offset = eagerx::lane(clock.offset, static_cast<int>(lane));
  for (std::uint32_t i = 0; i < Capacity; ++i)
    load_message(ring[ring_position<Capacity>(i + offset)], lane, from[i]);
}
template <std::size_t N, class LanesMessage, class Message, std::size_t Capacity>
void store_ring(const LanesMessage (&ring)[Capacity], const LaneClock<N>& clock, std::size_t lane,
                Message (&to)[Capacity]) {
  const std::uint32_t offset = eagerx::lane(clock.offset, static_cast<int>(lane));
  for (std::uint32_t i = 0; i < Capacity; ++i)
    store_message(ring[ring_position<Capacity>(i + offset)], lane, to[i]);
}

/// A hash for each lane, equal to that of HashTrace for the environment alone.
template <std::size_t N>
struct HashLanes {
  std::array<HashTrace, N> hashes{};

  template <class Message>
  void on_message(std::uint32_t channel, const LaneClock<N>& seq, const Message& message) {
    using One = decltype(lane(element(message, 0), 0));
    for (std::size_t k = 0; k < N; ++k) {
      Array<One, size_of<Message>> one;
      store_message(message, k, one);
      hashes[k].on_message(channel, seq.store(k), one);
    }
  }
  void load(std::size_t lane, const HashTrace& one) { hashes[lane] = one; }
  void store(std::size_t lane, HashTrace& one) const { one = hashes[lane]; }
};

/// No hooks, of vectorized programs.
struct NoLaneHooks : NoHooks {
  template <class Hooks>
  void load(std::size_t /*lane*/, const Hooks& /*one*/) {}
  template <class Hooks>
  void store(std::size_t /*lane*/, Hooks& /*one*/) const {}
};

}  // namespace eagerx
