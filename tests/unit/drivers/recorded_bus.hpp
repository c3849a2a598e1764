// A bus that keeps what was sent and answers with what a test has prepared.
#pragma once

#include <cstdint>
#include <deque>
#include <eagerx/bus.hpp>
#include <vector>

namespace eagerx::drivers::testing {

using Bytes = std::vector<std::uint8_t>;

struct RecordedBus {
  std::vector<Bytes> sent;
  std::vector<SpiDevice> spi_devices;
  std::deque<Bytes> answers;  // taken by transfers that read; zeros when there are none
  std::vector<std::uint8_t> addresses;
  BusError i2c_status = BusError::none;

  void spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    sent.emplace_back(out, out + n);
    spi_devices.push_back(device);
    if (in != nullptr) answer(in, n);
  }
  void i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
           std::size_t m, BusError& status) {
    sent.emplace_back(out, out + n);
    addresses.push_back(device.address);
    if (m > 0) answer(in, m);
    status = i2c_status;
  }
  BusError write(const std::uint8_t* out, std::size_t n) {
    sent.emplace_back(out, out + n);
    return BusError::none;
  }
  BusError read(std::uint8_t* in, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {  // answers one after the other
      while (!answers.empty() && answers.front().empty()) answers.pop_front();
      if (answers.empty()) return i == 0 ? BusError::timeout : BusError::short_reply;
      in[i] = answers.front().front();
      answers.front().erase(answers.front().begin());
    }
    return BusError::none;
  }
  BusError run() { return BusError::none; }

 private:
  void answer(std::uint8_t* in, std::size_t n) {
    Bytes bytes(n, 0);
    if (!answers.empty()) {
      bytes = answers.front();
      answers.pop_front();
    }
    for (std::size_t i = 0; i < n; ++i) in[i] = i < bytes.size() ? bytes[i] : 0;
  }
};
static_assert(SpiBus<RecordedBus> && I2cBus<RecordedBus> && UartBus<RecordedBus>);

}  // namespace eagerx::drivers::testing
