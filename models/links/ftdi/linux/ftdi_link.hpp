// SPI, I2C and GPIO on a FT232H, FT2232H or FT4232H: one USB round trip for all that is queued.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/ftdi/linux/ftdi_device.hpp>
#include <models/links/ftdi/mpsse_batch.hpp>
#include <models/links/linux/clock.hpp>

namespace eagerx::links {

/// The counters of a link since it was first opened.
struct LinkCounts {
  std::uint64_t round_trips = 0;  // batches that were answered
  std::uint64_t one_way = 0;      // batches that nothing answers
  std::uint64_t lost = 0;         // times the chip went away
  std::uint64_t reconnects = 0;
  std::uint64_t timeouts = 0;       // batches without an answer
  std::uint64_t short_replies = 0;  // batches with a part of one
  std::uint64_t resyncs = 0;        // answers given up and thrown away
};

/// A bus (SpiBus, I2cBus, GpioBus). If the chip is gone, run() and post() look for it again, at
/// most every kRetryNs; transfers queued in the meantime are not sent later. All bytes are zero
/// until open().
class FtdiLink {
 public:
  using Clock = LinuxClock;
  static constexpr std::int64_t kRetryNs = 100'000'000;

  /// Opens the chip; false if it is not there (yet). An answer may take `timeout_ms`.
  bool open(const FtdiSelection& selection, int timeout_ms, std::uint32_t max_hz) {
    selection_ = selection;
    timeout_ms_ = timeout_ms;
    max_hz_ = max_hz;
    return connect();
  }
  void close() { device_.free(); }
  bool is_open() const { return device_.is_open(); }
  const LinkCounts& counts() const { return counts_; }
  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    f("round trips", counts_.round_trips);
    f("one-way transfers", counts_.one_way);
    f("adapter lost", counts_.lost);
    f("adapter found again", counts_.reconnects);
    f("answers missing", counts_.timeouts);
    f("answers too short", counts_.short_replies);
    f("answers thrown away", counts_.resyncs);
  }

  void spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    batch_.spi(device, out, in, n);
  }
  void i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
           std::size_t m, BusError& status) {
    batch_.i2c(device, out, n, in, m, status);
  }
  void write_pin(std::uint8_t pin, bool level) { batch_.write_pin(pin, level); }
  void read_pin(std::uint8_t pin, bool& level) { batch_.read_pin(pin, level); }

  /// Carries out everything queued, in one round trip, and waits for the answer. After an error no
  /// buffer is changed, the queue is empty and the chip is brought back to a known state by the
  /// next call.
  BusError run() {
    batch_.finish();
    const bool was_open = device_.is_open();
    const BusError error = exchange();
    batch_.clear();
    if (error == BusError::none) return error;
    batch_.forget();  // also what a batch that was refused would have set
    if (error == BusError::full || error == BusError::unsupported) return error;
    if (error != BusError::link_lost) {
      ++(error == BusError::timeout ? counts_.timeouts : counts_.short_replies);
      unsure_ = true;
    } else if (was_open) {
      ++counts_.lost;
      device_.close();
    }
    return error;
  }
  /// The same; does not wait if no answer is expected.
  BusError post() { return run(); }

 private:
  BusError exchange() {
    if (batch_.error() != BusError::none) return batch_.error();
    if (batch_.size() == 0) return BusError::none;
    if (!device_.is_open()) {
      reconnect();
      return BusError::link_lost;  // what is queued was encoded for a chip in another state
    }
    if (unsure_ && !resynchronise()) return BusError::link_lost;
    BusError error = device_.write(batch_.bytes(), batch_.size());
    if (error != BusError::none) return error;
    const std::size_t n = batch_.reply_size();
    if (n == 0) return ++counts_.one_way, BusError::none;
    error = device_.read<Clock>(reply_, n, deadline());
    if (error != BusError::none) return error;
    ++counts_.round_trips;
    batch_.deliver(reply_);
    return BusError::none;
  }

  std::int64_t deadline() const {
    constexpr std::int64_t kNsPerMs = 1'000'000;
    return Clock::now_ns() + timeout_ms_ * kNsPerMs;
  }

  bool connect() {
    tried_ns_ = Clock::now_ns();
    if (!device_.open(selection_, timeout_ms_)) return false;
    const ftdi_chip_type type = device_.context()->type;
    if (ftdi_set_bitmode(device_.context(), 0, BITMODE_RESET) < 0 ||
        ftdi_set_bitmode(device_.context(), 0, BITMODE_MPSSE) < 0) {
      return device_.close(), false;
    }
    batch_.use({type == TYPE_232H, type != TYPE_4232H, max_hz_});
    if (!resynchronise()) return device_.close(), false;
    // 60 MHz base clock, no adaptive clocking, no loop-back, pins at rest.
    constexpr std::uint8_t kSetup[] = {0x8a, 0x97, 0x85, 0x80, 0xf8, 0xfb};
    if (device_.write(kSetup, sizeof kSetup) != BusError::none) return device_.close(), false;
    return true;
  }
  void reconnect() {
    if (Clock::now_ns() - tried_ns_ >= kRetryNs && connect()) ++counts_.reconnects;
  }

  /// Discards bytes in flight: the chip answers an unknown command with FA and the command. Sends
  /// two of them, because FA AA alone may be part of an old answer.
  bool resynchronise() {
    constexpr std::uint32_t kAnswer = 0xfaaafaab;
    if (unsure_) ++counts_.resyncs;
    unsure_ = false;
    if (ftdi_tcioflush(device_.context()) < 0) return false;
    constexpr std::uint8_t kProbe[] = {0xaa, 0xab, 0x87};
    if (device_.write(kProbe, sizeof kProbe) != BusError::none) return false;
    const std::int64_t until_ns = deadline();
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < sizeof reply_ + sizeof last; ++i) {
      std::uint8_t byte = 0;
      if (device_.read<Clock>(&byte, 1, until_ns) != BusError::none) return false;
      last = last << 8U | byte;
      if (last == kAnswer) return true;
    }
    return false;
  }

  FtdiDevice device_{};
  MpsseBatch batch_{};
  std::uint8_t reply_[MpsseBatch::kMaxReply]{};
  FtdiSelection selection_{};
  LinkCounts counts_{};
  std::int64_t tried_ns_ = 0;
  int timeout_ms_ = 0;
  std::uint32_t max_hz_ = 0;
  bool unsure_ = false;
};

static_assert(SpiBus<FtdiLink> && I2cBus<FtdiLink> && GpioBus<FtdiLink>);

}  // namespace eagerx::links
