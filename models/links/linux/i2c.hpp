// I2C on Linux: /dev/i2c-N. Source: linux/i2c-dev.h, Documentation/i2c/dev-interface.rst.
#pragma once

#include <linux/i2c-dev.h>
#include <linux/i2c.h>

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/linux/file.hpp>

namespace eagerx::links {

/// The system sets the clock, so a device's max_hz is ignored. All bytes are zero until
/// open().
template <class System = Kernel>
class LinuxI2c {
 public:
  bool open(const char* path) { return file_.template open<System>(path, O_RDWR); }
  void close() { file_.template close<System>(); }

  /// Writes n bytes, then reads m after a repeated start. Errors: nak, timeout, link_lost,
  /// unsupported (more than 8192 bytes, the kernel's limit).
  BusError transfer(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
                    std::size_t m) {
    constexpr std::size_t kMost = 8192;
    if (!file_.is_open()) return BusError::link_lost;
    if (n > kMost || m > kMost) return BusError::unsupported;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the kernel only reads it
    auto* const sent = const_cast<std::uint8_t*>(out);
    i2c_msg messages[2] = {{device.address, 0, static_cast<std::uint16_t>(n), sent},
                           {device.address, I2C_M_RD, static_cast<std::uint16_t>(m), in}};
    const bool writes = n > 0 || m == 0;
    const unsigned count = (writes ? 1U : 0U) + (m > 0 ? 1U : 0U);
    i2c_rdwr_ioctl_data data{writes ? messages : messages + 1, count};
    if (System::ioctl(file_.handle(), I2C_RDWR, &data) < 0) return error_of(errno);
    return BusError::none;
  }

 private:
  File file_;
};

}  // namespace eagerx::links
