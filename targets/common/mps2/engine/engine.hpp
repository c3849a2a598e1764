// RealEngine's work on an MPS2 board: the shields' connectors instead of an adapter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_model.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <models/links/immediate_link.hpp>
#include <string_view>
#include <targets/common/bare-metal/board_time.hpp>
#include <targets/common/mps2/gpio.hpp>
#include <targets/common/mps2/i2c.hpp>
#include <targets/common/mps2/spi.hpp>
#include <targets/common/mps2/watchdog.hpp>

namespace eagerx::board::mps2 {

/// As manifest.yaml names them.
enum class I2cChoice : std::uint8_t { none, shield0, shield1 };

/// All MPS2 images clock their peripherals with it (DAI 0386, table 3-1).
inline constexpr std::uint32_t kPeripheralHz = 25'000'000;
using Dog = ApbWatchdog<kPeripheralHz>;

/// A SPI and its select line.
struct Connector {
  std::uintptr_t base = 0;
  std::uint8_t select = 0;
};
/// That of the name "adc", "shield0" or "shield1"; a base of 0 for others.
constexpr Connector connector_of(std::string_view name) {
  if (name == "adc") return {kSpiAdc, kSelectAdc};
  if (name == "shield0") return {kSpiShield0, kSelectShield0};
  if (name == "shield1") return {kSpiShield1, kSelectShield1};
  return {};
}

/// The connectors of a text such as "shield0 adc".
struct ConnectorList {
  static constexpr std::size_t kMost = 3;
  std::array<Connector, kMost> items{};
  std::size_t size = 0;
  bool is_right = true;

  constexpr explicit ConnectorList(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find(' ') < text.size() ? text.find(' ') : text.size();
      if (end > 0) add(std::string_view(text.data(), end));
      text.remove_prefix(end < text.size() ? end + 1 : end);
    }
  }

 private:
  constexpr void add(std::string_view name) {
    const Connector connector = connector_of(name);
    is_right = is_right && connector.base != 0 && size < kMost;
    if (size < kMost) items[size++] = connector;
  }
};

/// For ImmediateLink: select lines, an I2C and pins by number. All bytes are zero until started.
class Hardware {
 public:
  static constexpr std::size_t kMostPins = 8;

  void add_select(const Connector& connector, std::uint32_t max_hz) {
    connector_[selects_] = connector;
    spi_[selects_++].start(connector.base, kPeripheralHz, max_hz);
  }
  void start_i2c(std::uintptr_t base, std::uint32_t max_hz) { i2c_.start(base, max_hz); }
  void add_pin(std::uint8_t pin) { pin_[pins_++] = pin; }
  bool start_watchdog(std::uint32_t ms) { return is_watched_ = Dog::start(ms); }
  void feed() {
    if (is_watched_) Dog::feed();
  }

  BusError spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    if (device.select >= selects_) return BusError::unsupported;
    const Connector& connector = connector_[device.select];
    return spi_[device.select].transfer(device, connector.select, out, in, n);
  }
  BusError i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
               std::size_t m) {
    return i2c_.transfer(device, out, n, in, m);
  }
  BusError write_pin(std::uint8_t pin, bool level) {
    return pin < pins_ ? Gpio<>::write_pin(pin_[pin], level) : BusError::unsupported;
  }
  BusError read_pin(std::uint8_t pin, bool& level) {
    return pin < pins_ ? Gpio<>::read_pin(pin_[pin], level) : BusError::unsupported;
  }

 private:
  std::array<Spi<BoardTime>, ConnectorList::kMost> spi_{};
  std::array<Connector, ConnectorList::kMost> connector_{};
  I2c<BoardTime> i2c_{};
  std::array<std::uint8_t, kMostPins> pin_{};
  bool is_watched_ = false;
  std::size_t selects_ = 0;
  std::size_t pins_ = 0;
};

using Link = links::ImmediateLink<Hardware, BoardTime>;
static_assert(SpiBus<Link> && I2cBus<Link> && GpioBus<Link>);

/// RealEngine's requirements on the system.
template <class Config>
struct EnginePlatform {
  static void prepare() { start_clock(); }

  static bool open(Link& link) {
    static constexpr ConnectorList kSelects{Config::selects};
    static_assert(kSelects.is_right,
                  "Mps2Engine: `selects` are up to 3 of adc, shield0 and shield1");
    static_assert(are_pins(), "Mps2Engine: `pins` are 0 to 63");
    constexpr std::uintptr_t kBases[] = {0, kI2cShield0, kI2cShield1};
    constexpr std::uintptr_t kBase = kBases[static_cast<std::size_t>(Config::i2c)];
    Hardware& hardware = link.hardware();
    for (std::size_t i = 0; i < kSelects.size; ++i)
      hardware.add_select(kSelects.items[i], Config::max_hz);
    if (kBase != 0) hardware.start_i2c(kBase, Config::max_hz);
    for (const auto pin : Config::pins) hardware.add_pin(static_cast<std::uint8_t>(pin));
    if constexpr (Config::watchdog > 0) return hardware.start_watchdog(Config::watchdog);
    return true;
  }

 private:
  static constexpr bool are_pins() {
    for (const auto pin : Config::pins) {
      if (pin < 0 || pin > 63) return false;
    }
    return true;
  }
};

template <class Io>
class Engine : public models::HardwareEngine<Io, Link, EnginePlatform<typename Io::Config>> {};

template <models::HardwareModel Model>
using Simulator = models::HardwareSimulator<Model, Link>;

}  // namespace eagerx::board::mps2
