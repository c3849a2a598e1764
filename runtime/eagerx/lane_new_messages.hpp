// Connections with `window: 0` over SIMD vectors: the number of new messages differs between lanes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/cursor.hpp>
#include <eagerx/lanes.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/simd.hpp>
#include <eagerx/window.hpp>

namespace eagerx {

template <std::size_t N>
struct LaneReceived {
  LaneSeq<N> end;
  LaneCounts<N> held;
};

/// As NewMessages, lane by lane.
template <std::size_t N>
class NewLanes {
 public:
  LaneReceived<N> take(const LaneSeq<N>& total) {
    const LaneCounts<N> fresh = total.count - seen_;
    seen_ = total.count;
    return {total, fresh};
  }
  void load(std::size_t lane, const NewMessages& one) {
    set_lane(seen_, static_cast<int>(lane), static_cast<std::uint32_t>(one.seen_));
  }
  void store(std::size_t lane, NewMessages& one) const {
    one.seen_ = eagerx::lane(seen_, static_cast<int>(lane));
  }

 private:
  LaneCounts<N> seen_{};
};

/// The new messages of each lane.
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
class NewLaneWindow {
 public:
  using value_type = Message;
  using Source = SourceRate;
  static constexpr std::uint32_t kMaxSize = MaxSize;
  static constexpr bool kAlwaysFull = AlwaysFull;
  static constexpr std::size_t kWidth = static_cast<std::size_t>(lanes<ScalarOf<Message>>);
  using Counts = LaneCounts<kWidth>;

  NewLaneWindow(const Message* ring, const LaneReceived<kWidth>& received)
      : ring_(ring), received_(received) {}

  /// Of each lane.
  const Counts& size() const { return received_.held; }
  auto empty() const { return size() == Counts(0U); }
  /// Message `i` of the lanes that have more than `i`; 0 is the oldest.
  Message operator[](std::uint32_t i) const {
    static_assert(std::has_single_bit(Capacity), "sequence numbers of lanes are modulo 2^32");
    const LaneSeq<kWidth>& end = received_.end;
    const Counts position =
        (end.count + end.offset - received_.held + Counts(i)) & Counts(Capacity - 1U);
    Message result = ring_[0];
    for (std::uint32_t place = 1; place < Capacity; ++place)
      result = detail::unless(position == Counts(place), ring_[place], result);
    return result;
  }

  /// As LaneWindow's.
  const Message* ring() const { return ring_; }
  Seq received(std::size_t lane) const {
    return eagerx::lane(received_.end.count, static_cast<int>(lane));
  }
  std::uint32_t offset(std::size_t lane) const {
    return eagerx::lane(received_.end.offset, static_cast<int>(lane));
  }
  Seq held(std::size_t lane) const { return eagerx::lane(received_.held, static_cast<int>(lane)); }

 private:
  const Message* ring_;
  LaneReceived<kWidth> received_;
};

}  // namespace eagerx
