// Lane-by-lane parts of a SIMD group: nodes and processors that are written for plain numbers. They
// receive and send the same messages as in the program of a single environment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/lanes.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/window.hpp>

namespace eagerx {

/// The window of one lane, of the type that the environment's own program has.
template <class One>
class OneLane;
template <class Message, class SourceRate, std::uint32_t Capacity, std::uint32_t MaxSize,
          bool AlwaysFull>
class OneLane<Window<Message, SourceRate, Capacity, MaxSize, AlwaysFull>> {
 public:
  using One = Window<Message, SourceRate, Capacity, MaxSize, AlwaysFull>;

  template <class Lanes>
  OneLane(const Lanes& window, std::size_t lane) : received_{window.received(lane), MaxSize} {
    if constexpr (requires { window.held(lane); }) {
      received_.held = window.held(lane);
    } else if (received_.end < MaxSize) {
      received_.held = received_.end;
    }
    const std::uint32_t offset = window.offset(lane);
    for (std::uint32_t i = 0; i < Capacity; ++i)
      store_message(window.ring()[ring_position<Capacity>(i + offset)], lane, ring_[i]);
  }
  // NOLINTNEXTLINE(google-explicit-constructor): is one
  operator One() const { return {ring_, received_}; }

 private:
  Message ring_[Capacity];
  Received received_;
};

/// Copies a message of one lane before and after a callback.
template <class One, class Lanes>
class OneMessage {
 public:
  OneMessage(Lanes& lanes, std::size_t lane) : lanes_(lanes), lane_(lane) {
    store_message(lanes, lane, one);
  }
  OneMessage(const OneMessage&) = delete;
  OneMessage& operator=(const OneMessage&) = delete;
  ~OneMessage() { load_message(lanes_, lane_, one); }

  One one;

 private:
  Lanes& lanes_;
  std::size_t lane_;
};

/// The processor of plain numbers, `OneIo` has its Input and Output.
template <class Processor, class OneIo, class Input, class Output, std::size_t N>
struct ConvertByLane {
  static Output convert(const Input& in) {
    Output out;
    for (std::size_t k = 0; k < N; ++k) {
      typename OneIo::Input one;
      store_message(in, k, one);
      load_message(out, k, Processor::convert(one));
    }
    return out;
  }
};

}  // namespace eagerx
