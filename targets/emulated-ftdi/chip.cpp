#include <algorithm>
#include <cstring>
#include <targets/emulated-ftdi/chip.hpp>

namespace eagerx::emulated {
namespace {

constexpr std::uint8_t kMpsse = 2;
constexpr unsigned kClock = 0x01;
constexpr unsigned kData = 0x02;

}  // namespace

void Chip::reset() {
  for (SpiSlave* slave : spi_) {
    if (slave != nullptr) slave->power_lost();
  }
  set_mode(0);
  divides_by_five_ = true;
  divisor_ = 0;
  three_phases_ = false;
  line_ = DataLine::works;
}

void Chip::set_mode(std::uint8_t mode) {
  mode_ = mode;
  pending_ = 0;
  low_values_ = 0xff;  // pins are inputs and pulled up
  low_outputs_ = 0;
  scl_ = sda_ = true;
  active_ = nullptr;
  addressing_ = false;
}

void Chip::take(const std::uint8_t* bytes, std::size_t n, std::int64_t now_ns, Fifo& to_host) {
  at_ns_ = std::max(at_ns_, now_ns);
  if (mode_ != kMpsse) {
    for (std::size_t i = 0; i < n; ++i) {
      std::uint8_t reply[64];
      const std::size_t m = serial_ == nullptr ? 0 : serial_->take(bytes[i], reply, sizeof reply);
      for (std::size_t k = 0; k < m; ++k) to_host.put(reply[k]);
    }
    return;
  }
  n = std::min(n, kPending - pending_);
  std::memcpy(bytes_.data() + pending_, bytes, n);
  pending_ += n;
  std::size_t done = 0;
  while (done < pending_) {
    const std::size_t used = command(bytes_.data() + done, pending_ - done, to_host);
    if (used == 0) break;
    done += used;
  }
  std::memmove(bytes_.data(), bytes_.data() + done, pending_ - done);
  pending_ -= done;
}

std::int64_t Chip::bit_ns() const {
  const std::int64_t half = (divides_by_five_ ? 83 : 17) * (std::int64_t{divisor_} + 1);
  return (three_phases_ ? 3 : 2) * half;
}

std::size_t Chip::command(const std::uint8_t* bytes, std::size_t n, Fifo& to_host) {
  constexpr std::int64_t kCommandNs = 80;
  const std::uint8_t opcode = bytes[0];
  const std::size_t arguments =
      opcode == 0x80 || opcode == 0x82 || opcode == 0x86 || (opcode == 0x9e && has_open_drain_) ? 2
      : (opcode & 0x80U) == 0 ? std::size_t{(opcode & 2U) != 0 ? 1U : 2U}
                              : 0;
  if (n < 1 + arguments) return 0;
  at_ns_ += kCommandNs;
  if ((opcode & 0x80U) == 0 && (opcode & 0x30U) != 0) {
    return (opcode & 2U) != 0 ? data_bits(bytes, n, to_host) : data_bytes(bytes, n, to_host);
  }
  switch (opcode) {
    case 0x80:
      set_low_pins(bytes[1], bytes[2]);
      break;
    case 0x81:
      to_host.put(low_values_);
      break;
    case 0x82:
      high_values_ = bytes[1];
      high_outputs_ = bytes[2];
      break;
    case 0x83:
      to_host.put(static_cast<std::uint8_t>((high_values_ & high_outputs_) |
                                            (high_inputs_ & ~high_outputs_)));
      break;
    case 0x86:
      divisor_ = bytes[1] | static_cast<unsigned>(bytes[2]) << 8U;
      break;
    case 0x8a:
    case 0x8b:
      divides_by_five_ = opcode == 0x8b;
      break;
    case 0x8c:
    case 0x8d:
      three_phases_ = opcode == 0x8c;
      break;
    case 0x84:
    case 0x85:
    case 0x87:
    case 0x96:
    case 0x97:
      break;
    case 0x9e:
      if (has_open_drain_) break;
      [[fallthrough]];
    default:
      to_host.put(0xfa);
      to_host.put(opcode);
      return 1;
  }
  return 1 + arguments;
}

SpiSlave* Chip::selected() const {
  for (std::size_t i = 0; i < kSelects; ++i) {
    if ((low_values_ >> (i + 3) & 1U) == 0) return spi_[i];
  }
  return nullptr;
}

void Chip::set_low_pins(std::uint8_t values, std::uint8_t outputs) {
  const std::uint8_t before = low_values_;
  low_values_ = static_cast<std::uint8_t>(values | ~outputs);  // inputs are pulled up
  low_outputs_ = outputs;
  const bool edge = ((before ^ low_values_) & kClock) != 0;
  for (std::size_t i = 0; i < kSelects; ++i) {
    const unsigned bit = 8U << i;
    if (spi_[i] == nullptr) continue;
    const bool was_chosen = (before & bit) == 0;
    const bool is_chosen = (low_values_ & bit) == 0;
    if (was_chosen && is_chosen && edge) ++edges_by_hand_;
    if (was_chosen == is_chosen) continue;
    // A clock that moves together with the select line is an edge, or none: it is undefined.
    if (edge) ++wrong_modes_;
    edges_by_hand_ = 0;
    rests_high_ = (low_values_ & kClock) != 0;
    is_chosen ? spi_[i]->select(at_ns_) : spi_[i]->release(at_ns_);
  }
  i2c_lines((low_values_ & kClock) != 0, (low_values_ & kData) != 0);
}

// Whether the edges of these transfers are those of the device's mode. The chip puts a bit out,
// then moves its clock twice, so at a level at which the command's first edge would be none it
// loses half a clock (AN_108: "use if CLK starts at"). With CPHA = 1 a device puts out its first
// bit at an edge before that, which somebody has to make.
bool Chip::understands(const SpiSlave& slave, std::uint8_t opcode) const {
  const bool starts_high = (low_values_ & kClock) != 0;
  const bool out_falling = (opcode & 1U) != 0;
  const bool in_falling = (opcode & 4U) != 0;
  const bool reads = (opcode & 0x20U) != 0;
  const bool second_edge = (slave.mode() & 1U) != 0;
  const bool clock_fits = rests_high_ == ((slave.mode() & 2U) != 0) &&
                          edges_by_hand_ == (second_edge ? 1U : 0U) &&
                          starts_high == (rests_high_ != second_edge);
  return clock_fits && !three_phases_ && out_falling != starts_high &&
         (!reads || in_falling == starts_high);
}

std::uint8_t Chip::exchange(std::uint8_t out, std::uint8_t opcode) {
  constexpr int kBits = 8;
  at_ns_ += kBits * bit_ns();
  std::uint8_t in = 0xff;
  if (SpiSlave* const slave = selected()) {
    if (understands(*slave, opcode)) {
      in = slave->exchange(out);
    } else {
      ++wrong_modes_;
    }
  } else if ((opcode & 0x10U) != 0) {
    i2c_byte(out);
  } else if (active_ != nullptr) {
    in = active_->read();
  }
  if (line_ == DataLine::stuck_low) return 0x00;
  return line_ == DataLine::stuck_high ? 0xff : in;
}

std::size_t Chip::data_bytes(const std::uint8_t* bytes, std::size_t n, Fifo& to_host) {
  const std::size_t length = (bytes[1] | static_cast<std::size_t>(bytes[2]) << 8U) + 1;
  const bool writes = (bytes[0] & 0x10U) != 0;
  if (writes && n < 3 + length) return 0;
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint8_t in = exchange(writes ? bytes[3 + i] : 0, bytes[0]);
    if ((bytes[0] & 0x20U) != 0) to_host.put(in);
  }
  return 3 + (writes ? length : 0);
}

// Only what I2C needs: one bit, the acknowledge.
std::size_t Chip::data_bits(const std::uint8_t* bytes, std::size_t n, Fifo& to_host) {
  const bool writes = (bytes[0] & 0x10U) != 0;
  if (writes && n < 3) return 0;
  at_ns_ += bit_ns();
  if ((bytes[0] & 0x20U) != 0) {
    const bool low = acknowledged_ && line_ != DataLine::stuck_high;
    to_host.put(low || line_ == DataLine::stuck_low ? 0 : 1);
  }
  return writes ? 3 : 2;
}

void Chip::i2c_lines(bool scl, bool sda) {
  if (scl && scl_ && sda_ && !sda) {  // start
    addressing_ = true;
    active_ = nullptr;
  }
  if (scl && scl_ && !sda_ && sda) {  // stop
    addressing_ = false;
    active_ = nullptr;
  }
  scl_ = scl;
  sda_ = sda;
}

void Chip::i2c_byte(std::uint8_t byte) {
  acknowledged_ = false;
  if (refuse_) {
    refuse_ = false;
    active_ = nullptr;
    addressing_ = false;
    return;
  }
  if (addressing_) {
    addressing_ = false;
    for (std::size_t i = 0; i < i2c_slaves_; ++i) {
      if (i2c_[i]->address() == byte >> 1U) active_ = i2c_[i];
    }
    if (active_ != nullptr && (byte & 1U) == 0) active_->begin();
    acknowledged_ = active_ != nullptr;
  } else if (active_ != nullptr) {
    active_->write(byte);
    acknowledged_ = true;
  }
}

}  // namespace eagerx::emulated
