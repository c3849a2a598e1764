// A pendulum with an encoder and a motor amplifier, wired to the adapter.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <targets/emulated-ftdi/devices.hpp>
#include <vector>

namespace eagerx::emulated {

/// The pendulum of models/objects/pendulum, integrated in double precision with steps of at most
/// 0.5 ms up to the instant at which a device looks at it.
class Pendulum {
 public:
  static constexpr std::size_t kMostCommands = 4096;  // on their way to the motor, without memory

  Pendulum() { commands_.reserve(kMostCommands); }
  /// Another one than the nominal: "m:1.1,R:0.9" are factors of its parameters. False if there is
  /// no such parameter or the factor is not positive.
  bool scale(const std::string& factors);
  /// The motor follows its commands so much later.
  void delay_motor(std::int64_t ns) { delay_ns_ = ns; }

  void advance(std::int64_t now_ns);
  /// From `now_ns` on, which advance() has reached, and the motor's delay.
  void set_voltage(double volts, std::int64_t now_ns);
  /// At once, without power.
  void switch_off();
  double voltage() const { return commands_.empty() ? volts_ : commands_.back().volts; }
  double theta() const { return theta_; }  // [rad], 0 upright
  double omega() const { return omega_; }  // [rad/s]

 private:
  struct Command {
    std::int64_t at_ns;
    double volts;
  };
  void integrate(std::int64_t until_ns);

  std::array<double, 8> factors_{1, 1, 1, 1, 1, 1, 1, 1};
  std::int64_t delay_ns_ = 0;
  /// Commands that the motor has not followed yet. Its memory is allocated at the start, so that
  /// the emulator causes no allocation in a program under a guard against allocations.
  std::vector<Command> commands_;
  double theta_ = 3.14159265358979;  // hangs down
  double omega_ = 0.0;
  double volts_ = 0.0;
  std::int64_t at_ns_ = -1;
};

/// An AS5048A on the shaft: 14 bits, zero upright. It samples when its select line falls.
class Encoder final : public SpiSlave {
 public:
  explicit Encoder(Pendulum& pendulum) : pendulum_(pendulum) {}

  unsigned mode() const override { return 1; }
  void select(std::int64_t now_ns) override;
  void release(std::int64_t now_ns) override;
  std::uint8_t exchange(std::uint8_t byte) override;
  void power_lost() override { answer_ = 0; }

  /// One bit of the next answer that carries a register is wrong.
  void corrupt(unsigned bit) { corrupt_ = 1U << bit; }
  std::uint64_t samples() const { return samples_; }

 private:
  std::uint16_t value_of(std::uint16_t address, std::int64_t now_ns);

  Pendulum& pendulum_;
  std::uint16_t command_ = 0;
  std::uint16_t answer_ = 0;  // to the command before
  bool answers_register_ = false;
  bool error_ = false;
  unsigned bytes_ = 0;
  unsigned corrupt_ = 0;
  std::uint64_t samples_ = 0;
};

/// A MCP4921 with a reference of 4.096 V and an amplifier: motor voltage = output - 2.048 V. Until
/// the first command, and without power, the motor has none.
class Converter final : public SpiSlave {
 public:
  explicit Converter(Pendulum& pendulum) : pendulum_(pendulum) {}

  unsigned mode() const override { return 0; }
  void select(std::int64_t /*now_ns*/) override { bytes_ = 0; }
  void release(std::int64_t now_ns) override;
  std::uint8_t exchange(std::uint8_t byte) override;
  void power_lost() override;

  std::uint64_t writes() const { return writes_; }
  /// From now on the motor ought to be at 0 V; without power it is.
  void want_zero(std::int64_t now_ns) {
    if (wanted_ns_ == 0 && !fresh_) wanted_ns_ = now_ns;
  }
  /// The longest time until a command of 0 V, or until now if there is none yet.
  std::int64_t slowest_zero_ns(std::int64_t now_ns) const;
  /// Times that the first command after power came back was another than 0 V.
  std::uint64_t unsafe_starts() const { return unsafe_starts_; }

 private:
  Pendulum& pendulum_;
  std::uint16_t command_ = 0;
  unsigned bytes_ = 0;
  std::uint64_t writes_ = 0;
  std::int64_t wanted_ns_ = 0;  // 0: no wish is open
  std::int64_t slowest_ns_ = 0;
  bool fresh_ = false;  // power was lost, no command since
  std::uint64_t unsafe_starts_ = 0;
};

}  // namespace eagerx::emulated
