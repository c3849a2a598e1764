// Pins on Linux: a line of /dev/gpiochipN, second version of its interface (Linux 5.10). Source:
// linux/gpio.h.
#pragma once

#include <linux/gpio.h>

#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/linux/file.hpp>
#include <string_view>

namespace eagerx::links {

/// One line, an input until it is written. All bytes are zero until open().
template <class System = Kernel>
class LinuxPin {
 public:
  bool open(const char* chip, std::uint32_t line) {
    File file;
    if (!file.open<System>(chip, O_RDWR)) return false;
    gpio_v2_line_request request{};
    request.offsets[0] = line;
    request.num_lines = 1;
    request.config.flags = GPIO_V2_LINE_FLAG_INPUT;
    std::string_view("eagerx").copy(request.consumer, sizeof request.consumer - 1);
    const int done = System::ioctl(file.handle(), GPIO_V2_GET_LINE_IOCTL, &request);
    file.close<System>();
    is_output_ = false;
    return line_.adopt(done < 0 ? -1 : request.fd);
  }
  void close() { line_.template close<System>(); }

  BusError write(bool level) {
    if (!line_.is_open()) return BusError::link_lost;
    if (!is_output_) return make_output(level);
    gpio_v2_line_values values{level ? 1U : 0U, 1U};
    return carry_out(GPIO_V2_LINE_SET_VALUES_IOCTL, &values);
  }
  BusError read(bool& level) const {
    if (!line_.is_open()) return BusError::link_lost;
    gpio_v2_line_values values{0, 1};
    const BusError error = carry_out(GPIO_V2_LINE_GET_VALUES_IOCTL, &values);
    if (error == BusError::none) level = (values.bits & 1U) != 0;
    return error;
  }

 private:
  /// With its level from the beginning: it makes no spike.
  BusError make_output(bool level) {
    gpio_v2_line_config config{};
    config.flags = GPIO_V2_LINE_FLAG_OUTPUT;
    config.num_attrs = 1;
    config.attrs[0].mask = 1;
    config.attrs[0].attr.id = GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES;
    config.attrs[0].attr.values = level ? 1U : 0U;
    const BusError error = carry_out(GPIO_V2_LINE_SET_CONFIG_IOCTL, &config);
    is_output_ = error == BusError::none;
    return error;
  }
  BusError carry_out(std::uintptr_t request, void* argument) const {
    return System::ioctl(line_.handle(), request, argument) < 0 ? error_of(errno) : BusError::none;
  }

  File line_;
  bool is_output_ = false;
};

}  // namespace eagerx::links
