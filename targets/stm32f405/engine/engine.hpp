// RealEngine's work on a STM32F405: the board's own peripherals instead of an adapter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_model.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <models/links/immediate_link.hpp>
#include <string_view>
#include <targets/common/bare-metal/board_time.hpp>
#include <targets/stm32f405/engine/hardware.hpp>

namespace eagerx::board::stm32 {

// As manifest.yaml names them.
enum class SpiChoice : std::uint8_t { none, spi1, spi2, spi3 };
enum class I2cChoice : std::uint8_t { none, i2c1, i2c2, i2c3 };

// `none` has one too, which is not used.
inline constexpr SpiPort kSpiPorts[] = {kSpi1, kSpi1, kSpi2, kSpi3};
inline constexpr I2cPort kI2cPorts[] = {kI2c1, kI2c1, kI2c2, kI2c3};

/// The pins of a text such as "PA5 PA6", at most `Most`.
template <std::size_t Most>
struct PinList {
  std::array<Pin, Most> pins{};
  std::size_t size = 0;
  bool is_right = true;  // all of them are pins, and there are not too many

  constexpr explicit PinList(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find(' ') < text.size() ? text.find(' ') : text.size();
      add(std::string_view(text.data(), end));
      text.remove_prefix(end < text.size() ? end + 1 : end);
    }
  }

 private:
  constexpr void add(std::string_view name) {
    if (name.empty()) return;
    const Pin pin = pin_of(name);
    is_right = is_right && pin != kNoPin && size < Most;
    if (size < Most) pins[size++] = pin;
  }
};

/// RealEngine's requirements on the system.
template <class Config, class Wait, class Memory = MappedMemory>
struct EnginePlatform {
  static void prepare() { start_clock(); }

  template <class Link>
  static bool open(Link& link) {
    static_assert(
        !kHasSpi || (kSpiNames.is_right && kSpi.has(kSpiLines)),
        "Stm32F405Engine: `spi_pins` are clock, MISO and MOSI of this SPI, \"PA5 PA6 PA7\"");
    static_assert(!kHasI2c || (kI2cNames.is_right && kI2c.has(kI2cLines)),
                  "Stm32F405Engine: `i2c_pins` are SCL and SDA of this I2C, \"PB6 PB7\"");
    static_assert(kSelects.is_right && kPins.is_right,
                  "Stm32F405Engine: `selects` and `pins` are up to 8 pins, \"PA4 PC13\"");
    static_assert(
        are_encoders(),
        "Stm32F405Engine: `encoders` are timers, 1 to 5 or 8, each once, and none is `pwm`");
    static_assert(are_channels(), "Stm32F405Engine: `adc` are channels, 0 to 15");
    Hardware<Wait, Memory>& hardware = link.hardware();
    bool done = true;
    if constexpr (kHasSpi) {
      done = hardware.start_spi(kSpi, kSpiLines, Config::max_hz);
      for (std::size_t i = 0; i < kSelects.size; ++i) done &= hardware.add_select(kSelects.pins[i]);
    }
    if constexpr (kHasI2c) done &= hardware.start_i2c(kI2c, kI2cLines, Config::max_hz);
    for (std::size_t i = 0; i < kPins.size; ++i) done &= hardware.add_pin(kPins.pins[i]);
    if constexpr (Config::pwm != 0)
      done &= hardware.start_pwm(timer_of(Config::pwm), Config::pwm_hz, Config::pwm_channels);
    if constexpr (Config::adc.size() > 0) {
      done &= hardware.start_adc(static_cast<float>(Config::adc_reference));
      for (const int channel : Config::adc)
        done &= hardware.add_adc(static_cast<std::uint8_t>(channel));
    }
    for (const int number : Config::encoders) done &= hardware.add_encoder(timer_of(number));
    if constexpr (Config::watchdog > 0) done &= hardware.start_watchdog(Config::watchdog);
    return done;
  }

 private:
  static constexpr bool kHasSpi = Config::spi != SpiChoice::none;
  static constexpr bool kHasI2c = Config::i2c != I2cChoice::none;
  static constexpr const SpiPort& kSpi = kSpiPorts[static_cast<std::size_t>(Config::spi)];
  static constexpr const I2cPort& kI2c = kI2cPorts[static_cast<std::size_t>(Config::i2c)];
  static constexpr PinList<3> kSpiNames{Config::spi_pins};
  static constexpr PinList<2> kI2cNames{Config::i2c_pins};
  static constexpr PinList<8> kSelects{Config::selects};
  static constexpr PinList<8> kPins{Config::pins};
  static constexpr SpiPins kSpiLines{kSpiNames.pins[0], kSpiNames.pins[1], kSpiNames.pins[2]};
  static constexpr I2cPins kI2cLines{kI2cNames.pins[0], kI2cNames.pins[1]};

  static constexpr bool are_encoders() {
    for (const int number : Config::encoders) {
      if (!is_timer(number) || number == Config::pwm) return false;
      int times = 0;
      for (const int other : Config::encoders) times += other == number ? 1 : 0;
      if (times > 1) return false;
    }
    return true;
  }
  static constexpr bool are_channels() {
    for (const int channel : Config::adc) {
      if (channel < 0 || channel >= Adc<Memory>::kChannels) return false;
    }
    return true;
  }
};

using Link = links::ImmediateLink<Hardware<BoardTime>, BoardTime>;

template <class Io>
class Engine
    : public models::HardwareEngine<Io, Link, EnginePlatform<typename Io::Config, BoardTime>> {};

template <models::HardwareModel Model>
using Simulator = models::HardwareSimulator<Model, Link>;

static_assert(SpiBus<Link> && I2cBus<Link> && GpioBus<Link> && PwmBus<Link> && AdcBus<Link> &&
              EncoderBus<Link>);

}  // namespace eagerx::board::stm32
