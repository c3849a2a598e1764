// Opening a chip of FTDI through libftdi.
#pragma once

#include <ftdi.h>

#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::links {

/// Which chip. Empty texts match any; `interface` is A to D of chips with several (FT2232H,
/// FT4232H).
struct FtdiSelection {
  int vendor;   // 0x0403
  int product;  // 0x6014 FT232H, 0x6010 FT2232H, 0x6011 FT4232H
  const char* serial;
  const char* description;
  char interface;
};

/// The bus error for an error of libftdi or libusb.
constexpr BusError bus_error_of(int result) {
  constexpr int kLibusbTimeout = -7;  // LIBUSB_ERROR_TIMEOUT
  if (result >= 0) return BusError::none;
  return result == kLibusbTimeout ? BusError::timeout : BusError::link_lost;
}

/// An open chip, or none. Opening and closing use the heap.
class FtdiDevice {
 public:
  bool is_open() const { return open_; }
  ftdi_context* context() { return context_; }

  /// Opens and resets the chip, with the shortest latency. False: not there, or not ours to open.
  bool open(const FtdiSelection& selection, int timeout_ms) {
    close();
    if (context_ == nullptr) context_ = ftdi_new();
    if (context_ == nullptr) return false;
    const auto text = [](const char* s) { return s[0] == '\0' ? nullptr : s; };
    const auto interface = static_cast<ftdi_interface>(INTERFACE_A + (selection.interface - 'A'));
    if (ftdi_set_interface(context_, interface) < 0) return false;
    if (ftdi_usb_open_desc(context_, selection.vendor, selection.product,
                           text(selection.description), text(selection.serial)) < 0) {
      return false;
    }
    open_ = true;
    context_->usb_read_timeout = timeout_ms;
    context_->usb_write_timeout = timeout_ms;
    constexpr unsigned char kLatencyMs = 1;
    if (ftdi_usb_reset(context_) < 0 || ftdi_set_latency_timer(context_, kLatencyMs) < 0) {
      return close(), false;
    }
    return true;
  }
  void close() {
    if (open_) ftdi_usb_close(context_);
    open_ = false;
  }
  /// Frees the memory after the last use.
  void free() {
    close();
    if (context_ != nullptr) ftdi_free(context_);
    context_ = nullptr;
  }

  /// Sends all bytes; one bulk transfer for each 4096.
  BusError write(const std::uint8_t* bytes, std::size_t n) {
    const int sent = ftdi_write_data(context_, bytes, static_cast<int>(n));
    if (sent < 0) return bus_error_of(sent);
    return sent == static_cast<int>(n) ? BusError::none : BusError::timeout;
  }
  /// Reads until there are `n` bytes or `now()` is past `deadline_ns`. Errors: link_lost, timeout
  /// (nothing came), short_reply.
  template <class Clock>
  BusError read(std::uint8_t* bytes, std::size_t n, std::int64_t deadline_ns) {
    std::size_t got = 0;
    while (got < n) {
      const int result = ftdi_read_data(context_, bytes + got, static_cast<int>(n - got));
      const BusError error = bus_error_of(result);
      if (error == BusError::link_lost) return error;
      if (result > 0) got += static_cast<std::size_t>(result);
      if (got < n && Clock::now_ns() > deadline_ns) {
        return got == 0 ? BusError::timeout : BusError::short_reply;
      }
    }
    return BusError::none;
  }

 private:
  ftdi_context* context_ = nullptr;
  bool open_ = false;
};

}  // namespace eagerx::links
