// Telemetry of a board: `telemetry:` of the graph over the serial port, in the time between slots.
#pragma once

#include <cstdint>
#include <eagerx/bounded.hpp>
#include <eagerx/link/telemetry.hpp>
#include <targets/common/bare-metal/clock.hpp>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/pace.hpp>
#include <type_traits>

namespace eagerx::board {

template <class Graph>
concept HasTelemetry = requires {
  typename Graph::Telemetry;
};

/// The work between two slots.
template <class Layout>
class TelemetryWork {
 public:
  static constexpr bool kWorks = true;

  link::Telemetry<Layout> telemetry{};

  void until(std::uint64_t deadline, std::uint64_t late_slots) {
    telemetry.set_late(late_slots);
    // A step is some 100 instructions; a core of 25 MHz does 500 in this time.
    constexpr std::uint64_t kMarginsPerSecond = 50'000;  // 20 us
    const std::uint64_t margin = clock_hz() / kMarginsPerSecond + 1;
    while (clock_ticks() + margin < deadline) {
      note_wait();  // it works where it would wait otherwise
      if (!telemetry.step(kOffer)) return;
    }
  }
  /// With `--timing`, all copies of a slot find room, and nothing is sent.
  std::uint64_t measured() {
    telemetry.discard();
    return clock_ticks();
  }

  /// After the run, whose outputs are safe: sends the contents of the ring, within twice the time
  /// that the line needs. The rest counts as dropped.
  void finish() {
    constexpr std::uint64_t kBitsOfByte = 10;
    constexpr std::uint64_t kBytes = sizeof telemetry;
    telemetry.end_run();
    const std::uint64_t end =
        clock_ticks() + 2 * kBytes * kBitsOfByte * clock_hz() / Layout::kBaud + clock_hz() / 10;
    while (clock_ticks() < end) {
      if (!telemetry.step(kOffer)) return;
    }
    telemetry.drop_all();
  }

 private:
  // Its own type, not a pointer: a call that `eagerx-gen size --worst` can follow.
  static constexpr auto kOffer = [](std::uint8_t byte) { return uart_offer(byte); };
};

template <class Graph>
struct IdleWorkOf {
  using Type = target::NoIdleWork;
};
template <HasTelemetry Graph>
struct IdleWorkOf<Graph> {
  using Type = TelemetryWork<typename Graph::Telemetry>;
};

/// `Base`, and every message is also offered to its telemetry.
template <class Base>
class TelemetryHooks : public Base {
 public:
  void on_episode(std::uint32_t index) {
    this->idle_work.telemetry.episode(index);
    Base::on_episode(index);
  }
  template <class Message>
  [[gnu::always_inline]] void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    Base::on_message(channel, seq, message);
    this->idle_work.telemetry.take(channel, seq, message);
  }
};

}  // namespace eagerx::board
