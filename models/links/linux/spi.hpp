// SPI on Linux: /dev/spidevB.S. Source: linux/spi/spidev.h, Documentation/spi/spidev.rst.
#pragma once

#include <linux/spi/spidev.h>

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/linux/file.hpp>

namespace eagerx::links {

/// One device with its select line, which the kernel handles. All bytes are zero until open().
template <class System = Kernel>
class LinuxSpi {
 public:
  bool open(const char* path, std::uint32_t max_hz) {
    max_hz_ = max_hz;
    has_mode_ = false;
    return file_.template open<System>(path, O_RDWR);
  }
  void close() { file_.template close<System>(); }

  /// Sends n bytes and receives as many; `in` may be null. Errors: link_lost, unsupported, timeout.
  BusError transfer(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    if (!file_.is_open()) return BusError::link_lost;
    if (!has_mode_ || mode_ != device.mode) {
      std::uint32_t mode = device.mode;
      if (System::ioctl(file_.handle(), SPI_IOC_WR_MODE32, &mode) < 0) return error_of(errno);
      mode_ = device.mode;
      has_mode_ = true;
    }
    spi_ioc_transfer transfer{};
    transfer.tx_buf = reinterpret_cast<std::uintptr_t>(out);
    transfer.rx_buf = reinterpret_cast<std::uintptr_t>(in);
    transfer.len = static_cast<std::uint32_t>(n);
    transfer.speed_hz = device.max_hz < max_hz_ ? device.max_hz : max_hz_;
    transfer.bits_per_word = 8;
    const int done = System::ioctl(file_.handle(), SPI_IOC_MESSAGE(1), &transfer);
    if (done < 0) return error_of(errno);
    return static_cast<std::size_t>(done) == n ? BusError::none : BusError::short_reply;
  }

 private:
  File file_;
  std::uint32_t max_hz_ = 0;
  std::uint8_t mode_ = 0;
  bool has_mode_ = false;
};

}  // namespace eagerx::links
