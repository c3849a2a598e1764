// PWM, ADC and encoders on Linux: numbers in files. Sources: Documentation/driver-api/pwm.rst,
// Documentation/ABI/testing/sysfs-bus-iio and sysfs-bus-counter.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/peripheral.hpp>
#include <models/links/linux/file.hpp>
#include <string_view>

namespace eagerx::links {

/// Numbers in a file that stays open: it is read and written from its beginning every time.
class NumberFile {
 public:
  bool open(const char* path, int flags) { return file_.open(path, flags); }
  void close() { file_.close(); }
  bool is_open() const { return file_.is_open(); }

  template <class T>
  BusError read(T& value) const {
    char text[kLongest];
    if (!file_.is_open()) return BusError::link_lost;
    const ssize_t n = ::pread(file_.handle(), text, sizeof text, 0);
    if (n < 0) return error_of(errno);
    const std::from_chars_result result = std::from_chars(text, text + n, value);
    return result.ec == std::errc() ? BusError::none : BusError::frame;
  }
  BusError write(std::uint64_t value) const {
    char text[kLongest];
    if (!file_.is_open()) return BusError::link_lost;
    char* end = std::to_chars(text, text + sizeof text - 1, value).ptr;
    *end++ = '\n';
    const ssize_t n = ::pwrite(file_.handle(), text, static_cast<std::size_t>(end - text), 0);
    return n == end - text ? BusError::none : error_of(errno);
  }

 private:
  static constexpr std::size_t kLongest = 32;

  File file_;
};

/// Reads or writes the number in `folder` + `name` once.
template <class T>
BusError read_number(std::string_view folder, std::string_view name, T& value) {
  NumberFile file;
  if (!file.open(Path(folder, name).text(), O_RDONLY)) return BusError::link_lost;
  const BusError error = file.read(value);
  file.close();
  return error;
}
inline BusError write_number(std::string_view folder, std::string_view name, std::uint64_t value) {
  NumberFile file;
  if (!file.open(Path(folder, name).text(), O_WRONLY)) return BusError::link_lost;
  const BusError error = file.write(value);
  file.close();
  return error;
}

/// The end of a path with a number in it: `/pwm3`, `/in_voltage3_raw`.
class Numbered {
 public:
  Numbered(std::string_view before, unsigned number, std::string_view after) {
    char digits[12];
    const char* end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    add(before);
    add({digits, static_cast<std::size_t>(end - digits)});
    add(after);
  }
  std::string_view text() const { return {text_, size_}; }

 private:
  void add(std::string_view more) {
    if (more.size() <= sizeof text_ - size_) size_ += more.copy(text_ + size_, more.size());
  }

  char text_[64] = {};
  std::size_t size_ = 0;
};

/// One output of /sys/class/pwm/pwmchipN. All bytes are zero until open().
class LinuxPwm {
 public:
  /// The output is low at first.
  bool open(std::string_view chip, unsigned channel, std::uint32_t hz) {
    constexpr std::uint32_t kNsPerSecond = 1'000'000'000;
    if (hz == 0 || hz > kNsPerSecond) return false;
    period_ns_ = (kNsPerSecond + hz / 2) / hz;
    // An error here means that it is already exported, so its files exist.
    static_cast<void>(write_number(chip, "/export", channel));
    const Path folder(chip, Numbered("/pwm", channel, "").text());
    if (!duty_.open(Path(folder.text(), "/duty_cycle").text(), O_RDWR)) return false;
    // A period shorter than the duty is refused, and a duty while there is no period: as a channel
    // is after its export (Linux before 6.11).
    static_cast<void>(duty_.write(0));
    return write_number(folder.text(), "/period", period_ns_) == BusError::none &&
           duty_.write(0) == BusError::none &&
           write_number(folder.text(), "/enable", 1) == BusError::none;
  }
  void close() { duty_.close(); }
  BusError write_duty(float duty) const { return duty_.write(counts_of_duty(duty, period_ns_)); }

 private:
  NumberFile duty_;
  std::uint32_t period_ns_ = 0;
};

/// One voltage of an industrial-I/O device, /sys/bus/iio/devices/iio:deviceN:
/// (raw + offset)·scale in mV. All bytes are zero until open().
class LinuxAdc {
 public:
  bool open(std::string_view device, unsigned channel) {
    // Either for all channels or for each.
    if (read_number(device, Numbered("/in_voltage", channel, "_scale").text(), scale_) !=
            BusError::none &&
        read_number(device, "/in_voltage_scale", scale_) != BusError::none) {
      return false;
    }
    offset_ = 0.0F;  // there need not be one
    if (read_number(device, Numbered("/in_voltage", channel, "_offset").text(), offset_) !=
        BusError::none) {
      static_cast<void>(read_number(device, "/in_voltage_offset", offset_));
    }
    const Path raw(device, Numbered("/in_voltage", channel, "_raw").text());
    return raw_.open(raw.text(), O_RDONLY);
  }
  void close() { raw_.close(); }
  BusError read_volts(float& volts) const {
    constexpr float kVoltsPerMv = 1e-3F;
    std::int32_t raw = 0;
    const BusError error = raw_.read(raw);
    if (error == BusError::none) volts = (static_cast<float>(raw) + offset_) * scale_ * kVoltsPerMv;
    return error;
  }

 private:
  NumberFile raw_;
  float scale_ = 0.0F;
  float offset_ = 0.0F;
};

/// One count of /sys/bus/counter/devices/counterN/countM, as its function is set there. All bytes
/// are zero until open().
class LinuxEncoder {
 public:
  bool open(std::string_view folder) {
    return count_.open(Path(folder, "/count").text(), O_RDONLY);
  }
  void close() { count_.close(); }
  /// The kernel's count has up to 64 bits; here it wraps at 32.
  BusError read(std::int32_t& counts) const {
    std::uint64_t count = 0;
    const BusError error = count_.read(count);
    if (error == BusError::none)
      counts = static_cast<std::int32_t>(static_cast<std::uint32_t>(count));
    return error;
  }

 private:
  NumberFile count_;
};

}  // namespace eagerx::links
