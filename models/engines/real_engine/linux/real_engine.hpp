// RealEngine on Linux: over libftdi, with real-time scheduling where that is allowed.
#pragma once

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <models/links/ftdi/linux/ftdi_link.hpp>

namespace eagerx::models {

/// What RealEngine wants of the system.
template <class Config>
struct LinuxPlatform {
  /// Locks the program's memory and gives it real-time priority `priority` (SCHED_FIFO), unless
  /// that is 0. What is not allowed is said once, and the program goes on.
  static void prepare() {
    constexpr auto kPriority = static_cast<int>(Config::priority);
    if (kPriority <= 0) return;
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
      say("memory is not locked, a page fault may delay an instant", "raise `ulimit -l`");
    }
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) {
      say("no real-time priority, other programs may delay an instant", "raise `ulimit -r`");
    }
  }

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

 private:
  static void say(const char* what, const char* help) {
    static_cast<void>(
        std::fprintf(stderr, "note: %s (%s); as root, or %s\n", what, std::strerror(errno), help));
  }
};

template <class Io>
class RealEngine : public HardwareEngine<Io, links::FtdiLink, LinuxPlatform<typename Io::Config>> {
};

template <HardwareModel Model>
using RealSimulator = HardwareSimulator<Model, links::FtdiLink>;

}  // namespace eagerx::models
