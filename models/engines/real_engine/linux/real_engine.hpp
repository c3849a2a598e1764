// RealEngine on Linux: over libftdi, with real-time scheduling where that is allowed.
#pragma once

#include <cstdio>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <models/engines/real_engine/linux/real_time.hpp>
#include <models/links/ftdi/linux/ftdi_link.hpp>

namespace eagerx::models {

/// RealEngine's requirements on the system.
template <class Config>
struct LinuxPlatform {
  static void prepare() { ask_for_real_time(static_cast<int>(Config::priority)); }

  static bool open(links::FtdiLink& link) {
    constexpr double kMsPerSecond = 1e3;
    const links::FtdiSelection selection{static_cast<int>(Config::vendor),
                                         static_cast<int>(Config::product), Config::serial,
                                         Config::description, Config::interface[0]};
    constexpr auto kTimeoutMs = static_cast<int>(Config::timeout * kMsPerSecond + 0.5);
    if (link.open(selection, kTimeoutMs, static_cast<std::uint32_t>(Config::max_hz))) return true;
    static_cast<void>(std::fprintf(
        stderr,
        "warning: there is no adapter %04x:%04x that can be opened; it is looked for while the "
        "program runs\n",
        static_cast<unsigned>(selection.vendor), static_cast<unsigned>(selection.product)));
    return false;
  }
};

template <class Io>
class RealEngine : public HardwareEngine<Io, links::FtdiLink, LinuxPlatform<typename Io::Config>> {
};

template <HardwareModel Model>
using RealSimulator = HardwareSimulator<Model, links::FtdiLink>;

}  // namespace eagerx::models
