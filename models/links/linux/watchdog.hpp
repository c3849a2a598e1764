// The watchdog of a Linux system: /dev/watchdog. Source: linux/watchdog.h,
// Documentation/watchdog/watchdog-api.rst.
#pragma once

#include <linux/watchdog.h>

#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <models/links/linux/file.hpp>

namespace eagerx::links {

/// Resets the machine when it is not fed, in whole seconds. All bytes are zero until open(). A
/// program that is killed cannot stop it; close() does.
template <class System = Kernel>
class LinuxWatchdog {
 public:
  bool open(const char* path) { return file_.template open<System>(path, O_WRONLY); }
  /// The device has a time-out as soon as it is open; this sets it, rounded up to seconds. False if
  /// `ms` is too long for it.
  bool start(std::uint32_t ms) {
    constexpr std::uint32_t kMsPerSecond = 1000;
    int seconds = static_cast<int>((ms + kMsPerSecond - 1) / kMsPerSecond);
    const int wanted = seconds;
    if (!file_.is_open() || ms == 0) return false;
    if (System::ioctl(file_.handle(), WDIOC_SETTIMEOUT, &seconds) < 0) return false;
    feed();
    return seconds >= wanted;
  }
  void feed() {
    int unused = 0;
    if (file_.is_open()) System::ioctl(file_.handle(), WDIOC_KEEPALIVE, &unused);
  }
  void close() {
    int off = WDIOS_DISABLECARD;
    if (file_.is_open()) System::ioctl(file_.handle(), WDIOC_SETOPTIONS, &off);
    file_.template close<System>();
  }

 private:
  File file_;
};

static_assert(Watchdog<LinuxWatchdog<>>);

}  // namespace eagerx::links
