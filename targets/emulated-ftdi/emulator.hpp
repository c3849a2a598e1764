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

/// Which chip the adapter has, as it says over USB (FTDI AN_121 and the data sheets).
struct Model {
  const char* name;
  std::uint16_t product;
  std::uint16_t release;  // bcdDevice, by which libftdi knows the chip
  unsigned interfaces;
  unsigned with_mpsse;  // the first ones; the others have a serial line only
};
inline constexpr Model kFt232h{"FT232H", 0x6014, 0x0900, 1, 1};
inline constexpr Model kFt2232h{"FT2232H", 0x6010, 0x0700, 2, 2};
inline constexpr Model kFt4232h{"FT4232H", 0x6011, 0x0800, 4, 2};

/// From the environment variable EAGERX_EMULATOR, `name=value` with spaces between; see README.md.
struct Settings {
  bool emulated_time = true;
  std::uint64_t seed = 1;
  double faults = 0.0;
  std::uint32_t kinds = 0xffffffff;
  std::uint64_t most = 0xffffffffffffffff;
  double from_s = 0.0;    // no faults before
  double absent_s = 0.0;  // the adapter is plugged in so much later
  std::string pendulum;   // factors of its parameters
  double motor_delay_s = 0.0;
  std::string report;
  std::string voltages;
  Model model = kFt232h;
  unsigned wired = 0;  // the interface that the devices are on; nothing is on the others
};

/// The transfers over USB.
struct UsbCounts {
  std::uint64_t out = 0;        // bulk transfers to the chip
  std::uint64_t in = 0;         // bulk transfers from the chip that carried an answer
  std::uint64_t empty = 0;      // bulk transfers from the chip that did not
  std::uint64_t elsewhere = 0;  // bulk transfers of interfaces that nothing is wired to
  std::uint64_t batches = 0;    // transfers to the chip that ask for an answer at once
};

/// Results of bulk and control transfers are libusb's error codes, or the number of bytes.
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
  const Model& model() const { return settings_.model; }
  /// Another chip, with the devices on interface `wired` (0 is A). The adapter is to be opened
  /// after that.
  void set_model(const Model& model, unsigned wired);

  /// How much longer a sleep takes than it should.
  std::int64_t oversleep_ns();
  /// The program was woken up too late.
  void overslept() { converter_.want_zero(time_.now_ns()); }
  /// Whether the adapter is plugged in; it comes back by itself some time after a fault.
  bool is_there();
  /// Returns a number that is valid until the adapter is unplugged.
  std::uint64_t open();
  int control(std::uint64_t opened, unsigned interface, std::uint8_t type, std::uint8_t request,
              std::uint16_t value, std::uint8_t* data, std::uint16_t n);
  int bulk_out(std::uint64_t opened, unsigned interface, const std::uint8_t* bytes, int n);
  int bulk_in(std::uint64_t opened, unsigned interface, std::uint8_t* bytes, int n, int& moved,
              unsigned timeout_ms);
  void pull_out(std::int64_t for_ns);
  /// Writes all counts to Settings::report, if that is not empty.
  void report() const;

 private:
  bool gone(std::uint64_t opened) { return !is_there() || opened != plugged_; }
  bool has_faults() const { return time_.now_ns() >= faults_from_ns_; }
  void note_voltage(std::int64_t begun_ns) const;
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
  int voltages_ = -1;  // descriptor of Settings::voltages
  std::uint8_t latency_ms_ = 16;
};

/// The one of this process.
Emulator& emulator();

}  // namespace eagerx::emulated
