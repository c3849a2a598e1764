// RealEngine's work at the pins of a Linux system.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <models/engines/linux_engine/linux/hardware.hpp>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_model.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <models/engines/real_engine/linux/real_time.hpp>
#include <models/links/immediate_link.hpp>
#include <models/links/linux/clock.hpp>
#include <string_view>

namespace eagerx::models {

/// The engine's requirements on the system.
template <class Config>
class LinuxPins {
 public:
  static void prepare() { ask_for_real_time(static_cast<int>(Config::priority)); }

  /// Opens all named devices. False if one is missing, which is reported.
  template <class Link>
  static bool open(Link& link) {
    auto& hardware = link.hardware();
    int missing = 0;
    const auto note = [&](bool done, std::string_view what) {
      if (!done) say_missing(what);
      missing += done ? 0 : 1;
      return true;
    };
    links::for_each_word(Config::spi, [&](std::string_view path) {
      return note(hardware.add_spi(path, static_cast<std::uint32_t>(Config::max_hz)), path);
    });
    if (Config::i2c[0] != '\0') note(hardware.open_i2c(Config::i2c), Config::i2c);
    for (const auto line : Config::pins)
      note(hardware.add_pin(Config::gpio_chip, static_cast<std::uint32_t>(line)),
           Config::gpio_chip);
    for (const auto output : Config::pwm)
      note(hardware.add_pwm(Config::pwm_chip, static_cast<unsigned>(output), Config::pwm_hz),
           Config::pwm_chip);
    for (const auto voltage : Config::adc)
      note(hardware.add_adc(Config::adc_device, static_cast<unsigned>(voltage)),
           Config::adc_device);
    links::for_each_word(Config::encoders, [&](std::string_view path) {
      return note(hardware.add_encoder(path), path);
    });
    if constexpr (Config::watchdog > 0)
      note(hardware.open_watchdog(Config::watchdog_device, Config::watchdog),
           Config::watchdog_device);
    return missing == 0;
  }

 private:
  static void say_missing(std::string_view what) {
    static_cast<void>(std::fprintf(stderr, "warning: cannot use %.*s (%s)\n",
                                   static_cast<int>(what.size()), what.data(),
                                   std::strerror(errno)));
  }
};

using LinuxLink = links::ImmediateLink<LinuxHardware<>, links::LinuxClock>;

template <class Io>
class LinuxEngine : public HardwareEngine<Io, LinuxLink, LinuxPins<typename Io::Config>> {};

template <HardwareModel Model>
using LinuxSimulator = HardwareSimulator<Model, LinuxLink>;

}  // namespace eagerx::models
