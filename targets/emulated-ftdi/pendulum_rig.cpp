#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <models/drivers/as5048/as5048.hpp>
#include <models/drivers/mcp4921/mcp4921.hpp>
#include <models/engines/ode_engine/ode_model.hpp>
#include <models/engines/ode_engine/rk4.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <sstream>
#include <targets/emulated-ftdi/pendulum_rig.hpp>
#include <targets/emulated-ftdi/time.hpp>

namespace eagerx::emulated {
namespace {

struct ModelIo {
  using Real = double;
};
using Model = models::PendulumOde<ModelIo>;
using Registers = drivers::As5048A;
using Codec = drivers::MagneticEncoder<Registers>;

constexpr double kTurn = 6.283185307179586;

}  // namespace

bool Pendulum::scale(const std::string& factors) {
  static const std::array<std::string, 8> kNames = {"J", "m", "l", "b", "K", "R", "c", "d"};
  std::istringstream text(factors);
  for (std::string word; std::getline(text, word, ',');) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    const auto* const name = std::find(kNames.begin(), kNames.end(), word.substr(0, colon));
    const double factor = std::strtod(word.c_str() + std::min(colon + 1, word.size()), nullptr);
    if (name == kNames.end() || !(factor > 0.0)) return false;
    factors_[static_cast<std::size_t>(name - kNames.begin())] = factor;
  }
  return true;
}

void Pendulum::advance(std::int64_t now_ns) {
  if (at_ns_ < 0) at_ns_ = now_ns;
  while (!commands_.empty() && commands_.front().at_ns <= now_ns) {
    integrate(commands_.front().at_ns);
    volts_ = commands_.front().volts;
    commands_.erase(commands_.begin());
  }
  integrate(now_ns);
}

void Pendulum::set_voltage(double volts, std::int64_t now_ns) {
  commands_.push_back({now_ns + delay_ns_, volts});
  advance(now_ns);
}

void Pendulum::switch_off() {
  commands_.clear();
  volts_ = 0.0;
}

void Pendulum::integrate(std::int64_t until_ns) {
  constexpr std::int64_t kStepNs = kNsPerMs / 2;
  Model::Parameters parameters = Model::default_parameters();
  for (std::size_t i = 0; i < factors_.size(); ++i) parameters[i] *= factors_[i];
  const models::OdeDerivative<Model> derivative(parameters, {{volts_}});
  Model::State x{{theta_, omega_}};
  while (at_ns_ < until_ns) {
    const std::int64_t step = std::min(kStepNs, until_ns - at_ns_);
    x = models::rk4_step(derivative, x, static_cast<double>(step) / double{kNsPerSecond});
    at_ns_ += step;
  }
  theta_ = x[0];
  omega_ = x[1];
}

std::uint16_t Encoder::value_of(std::uint16_t address, std::int64_t now_ns) {
  if (address == Registers::kAngle) {
    ++samples_;
    pendulum_.advance(now_ns);
    const double turns = pendulum_.theta() / kTurn;
    const double counts = std::floor((turns - std::floor(turns)) * Codec::kCountsPerTurn + 0.5);
    return static_cast<std::uint16_t>(counts) & 0x3fffU;
  }
  if (address == Registers::kDiagnostics) return 0x0180;  // measures, gain in the middle
  if (address == Registers::kClearErrors) error_ = false;
  return 0;
}

void Encoder::select(std::int64_t /*now_ns*/) {
  bytes_ = 0;
  command_ = 0;
  if (answers_register_ && corrupt_ != 0) {
    answer_ = static_cast<std::uint16_t>(answer_ ^ corrupt_);
    corrupt_ = 0;
  }
}

std::uint8_t Encoder::exchange(std::uint8_t byte) {
  command_ = static_cast<std::uint16_t>(command_ << 8U | byte);
  return bytes_++ == 0 ? high_byte(answer_) : low_byte(answer_);
}

void Encoder::release(std::int64_t now_ns) {
  if (bytes_ != 2 || Codec::is_odd(command_)) {
    error_ = true;
    answer_ = 0;
    return;
  }
  const std::uint16_t address = command_ & 0x3fffU;
  answers_register_ = address == Registers::kAngle || address == Registers::kDiagnostics;
  const std::uint16_t value = (command_ & 0x4000U) != 0 ? value_of(address, now_ns) : 0;
  answer_ = Codec::with_parity(static_cast<std::uint16_t>(value | (error_ ? 0x4000U : 0U)));
}

std::uint8_t Converter::exchange(std::uint8_t byte) {
  command_ = static_cast<std::uint16_t>(command_ << 8U | byte);
  ++bytes_;
  return 0xff;  // the chip sends nothing: the line is pulled up
}

void Converter::release(std::int64_t now_ns) {
  if (bytes_ != 2 || (command_ & 0x8000U) != 0) return;
  ++writes_;
  pendulum_.advance(now_ns);
  const bool on = (command_ & 0x1000U) != 0;
  const double volts = on ? (command_ & 0x0fffU) / 4096.0 * 4.096 - 2.048 : 0.0;
  if (fresh_ && volts != 0.0) ++unsafe_starts_;
  fresh_ = false;
  if (volts == 0.0) {
    slowest_ns_ = slowest_zero_ns(now_ns);
    wanted_ns_ = 0;
  }
  pendulum_.set_voltage(volts, now_ns);
}

void Converter::power_lost() {
  pendulum_.switch_off();
  wanted_ns_ = 0;
  fresh_ = true;
}

std::int64_t Converter::slowest_zero_ns(std::int64_t now_ns) const {
  return wanted_ns_ == 0 ? slowest_ns_ : std::max(slowest_ns_, now_ns - wanted_ns_);
}

}  // namespace eagerx::emulated
