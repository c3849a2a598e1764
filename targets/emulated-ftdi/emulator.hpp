// The emulated adapter with everything that is wired to it.
#pragma once

#include <cstdint>
#include <string>
#include <targets/emulated-ftdi/bench_devices.hpp>
#include <targets/emulated-ftdi/chip.hpp>
#include <targets/emulated-ftdi/faults.hpp>
#include <targets/emulated-ftdi/pendulum_rig.hpp>
#include <targets/emulated-ftdi/time.hpp>

namespace eagerx::emulated {

/// From the environment variable EAGERX_EMULATOR, `name=value` with spaces between; see README.md.
struct Settings {
  bool emulated_time = true;
  std::uint64_t seed = 1;
  double faults = 0.0;
  std::uint32_t kinds = 0xffffffff;
  std::uint64_t most = 0xffffffffffffffff;
  double from_s = 0.0;    // no faults before
  double absent_s = 0.0;  // the adapter is plugged in so much later
  std::string report;
};

/// What went over USB.
struct UsbCounts {
  std::uint64_t out = 0;      // bulk transfers to the chip
  std::uint64_t in = 0;       // bulk transfers from the chip that carried an answer
  std::uint64_t empty = 0;    // bulk transfers from the chip that did not
  std::uint64_t batches = 0;  // transfers to the chip that ask for an answer at once
};

/// Results of bulk and control transfers are libusb's error codes, or what was moved.
class Emulator {
 public:
  explicit Emulator(Settings settings);
  ~Emulator() = default;
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  Time& time() { return time_; }
  Faults& faults() { return faults_; }
  Chip& chip() { return chip_; }
  Pendulum& pendulum() { return pendulum_; }
  Encoder& encoder() { return encoder_; }
  Converter& converter() { return converter_; }
  const UsbCounts& usb() const { return usb_; }

  /// How much longer a sleep takes than it should.
  std::int64_t oversleep_ns();
  /// The program was woken up too late.
  void overslept() { converter_.want_zero(time_.now_ns()); }
  /// Whether the adapter is plugged in; it comes back by itself some time after a fault.
  bool is_there();
  /// Opening gives a number that is valid until the adapter is pulled out.
  std::uint64_t open();
  int control(std::uint64_t opened, std::uint8_t type, std::uint8_t request, std::uint16_t value,
              std::uint8_t* data, std::uint16_t n);
  int bulk_out(std::uint64_t opened, const std::uint8_t* bytes, int n);
  int bulk_in(std::uint64_t opened, std::uint8_t* bytes, int n, int& moved, unsigned timeout_ms);
  void pull_out(std::int64_t for_ns);
  /// Writes all counts to Settings::report, if that is not empty.
  void report() const;

 private:
  bool gone(std::uint64_t opened) { return !is_there() || opened != plugged_; }
  bool has_faults() const { return time_.now_ns() >= faults_from_ns_; }
  bool starts_badly(Fault fault);
  void ends_badly(Fault fault);

  Settings settings_;
  Time time_;
  Faults faults_;
  Pendulum pendulum_;
  Encoder encoder_;
  Converter converter_;
  Imu imu_;
  Pwm pwm_;
  Servo servo_;
  Chip chip_;
  Fifo to_host_;
  Fifo stale_;  // an answer that comes too late
  UsbCounts usb_;
  std::uint64_t plugged_ = 1;
  bool there_ = true;
  std::int64_t back_ns_ = 0;
  std::int64_t faults_from_ns_ = 0;
  std::int64_t answer_ns_ = 0;  // before then no answer is given
  std::size_t first_part_ = 0;  // 0: the answer comes in one piece
  bool pull_out_next_ = false;
  std::uint8_t latency_ms_ = 16;
};

/// The one of this process.
Emulator& emulator();

}  // namespace eagerx::emulated
