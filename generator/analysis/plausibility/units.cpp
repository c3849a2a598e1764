#include "generator/analysis/plausibility/units.hpp"

#include <cmath>
#include <numbers>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

struct Named {
  std::string_view name;
  UnitOfMeasure unit;
};

constexpr double kPi = std::numbers::pi;
constexpr double kPerMinute = 1.0 / 60.0;
constexpr double kStandardGravity = 9.80665;

//                                           m kg  s  A  K rad
constexpr std::array<std::int8_t, 6> kNone = {0, 0, 0, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kLength = {1, 0, 0, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kVolume = {3, 0, 0, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kMass = {0, 1, 0, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kTime = {0, 0, 1, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kFrequency = {0, 0, -1, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kCurrent = {0, 0, 0, 1, 0, 0};
constexpr std::array<std::int8_t, 6> kTemperature = {0, 0, 0, 0, 1, 0};
constexpr std::array<std::int8_t, 6> kAngle = {0, 0, 0, 0, 0, 1};
constexpr std::array<std::int8_t, 6> kTurning = {0, 0, -1, 0, 0, 1};
constexpr std::array<std::int8_t, 6> kAcceleration = {1, 0, -2, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kForce = {1, 1, -2, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kPressure = {-1, 1, -2, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kEnergy = {2, 1, -2, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kPower = {2, 1, -3, 0, 0, 0};
constexpr std::array<std::int8_t, 6> kCharge = {0, 0, 1, 1, 0, 0};
constexpr std::array<std::int8_t, 6> kVoltage = {2, 1, -3, -1, 0, 0};
constexpr std::array<std::int8_t, 6> kResistance = {2, 1, -3, -2, 0, 0};
constexpr std::array<std::int8_t, 6> kCapacitance = {-2, -1, 4, 2, 0, 0};
constexpr std::array<std::int8_t, 6> kInductance = {2, 1, -2, -2, 0, 0};
constexpr std::array<std::int8_t, 6> kFluxDensity = {0, 1, -2, -1, 0, 0};

// The SI (BIPM, 9th edition) and what robots are measured in besides. A temperature in degC has
// another zero than one in K, and a number alone no unit: neither is here.
constexpr Named kUnits[] = {
    {"1", {kNone, 1.0}},
    {"%", {kNone, 0.01}},
    {"m", {kLength, 1.0}},
    {"km", {kLength, 1e3}},
    {"dm", {kLength, 1e-1}},
    {"cm", {kLength, 1e-2}},
    {"mm", {kLength, 1e-3}},
    {"um", {kLength, 1e-6}},
    {"in", {kLength, 0.0254}},
    {"ft", {kLength, 0.3048}},
    {"l", {kVolume, 1e-3}},
    {"L", {kVolume, 1e-3}},
    {"ml", {kVolume, 1e-6}},
    {"kg", {kMass, 1.0}},
    {"g", {kMass, 1e-3}},
    {"mg", {kMass, 1e-6}},
    {"t", {kMass, 1e3}},
    {"s", {kTime, 1.0}},
    {"ms", {kTime, 1e-3}},
    {"us", {kTime, 1e-6}},
    {"ns", {kTime, 1e-9}},
    {"min", {kTime, 60.0}},
    {"h", {kTime, 3600.0}},
    {"Hz", {kFrequency, 1.0}},
    {"kHz", {kFrequency, 1e3}},
    {"MHz", {kFrequency, 1e6}},
    {"A", {kCurrent, 1.0}},
    {"mA", {kCurrent, 1e-3}},
    {"uA", {kCurrent, 1e-6}},
    {"K", {kTemperature, 1.0}},
    {"rad", {kAngle, 1.0}},
    {"mrad", {kAngle, 1e-3}},
    {"deg", {kAngle, kPi / 180.0}},
    {"degree", {kAngle, kPi / 180.0}},
    {"degrees", {kAngle, kPi / 180.0}},
    {"\u00b0", {kAngle, kPi / 180.0}},
    {"rev", {kAngle, 2.0 * kPi}},
    {"rpm", {kTurning, 2.0 * kPi* kPerMinute}},
    {"gn", {kAcceleration, kStandardGravity}},
    {"N", {kForce, 1.0}},
    {"kN", {kForce, 1e3}},
    {"mN", {kForce, 1e-3}},
    {"Nm", {kEnergy, 1.0}},
    {"mNm", {kEnergy, 1e-3}},
    {"J", {kEnergy, 1.0}},
    {"kJ", {kEnergy, 1e3}},
    {"mJ", {kEnergy, 1e-3}},
    {"Wh", {kEnergy, 3600.0}},
    {"Pa", {kPressure, 1.0}},
    {"hPa", {kPressure, 1e2}},
    {"kPa", {kPressure, 1e3}},
    {"MPa", {kPressure, 1e6}},
    {"bar", {kPressure, 1e5}},
    {"mbar", {kPressure, 1e2}},
    {"W", {kPower, 1.0}},
    {"mW", {kPower, 1e-3}},
    {"kW", {kPower, 1e3}},
    {"C", {kCharge, 1.0}},
    {"Ah", {kCharge, 3600.0}},
    {"mAh", {kCharge, 3.6}},
    {"V", {kVoltage, 1.0}},
    {"mV", {kVoltage, 1e-3}},
    {"uV", {kVoltage, 1e-6}},
    {"kV", {kVoltage, 1e3}},
    {"ohm", {kResistance, 1.0}},
    {"kohm", {kResistance, 1e3}},
    {"Mohm", {kResistance, 1e6}},
    {"F", {kCapacitance, 1.0}},
    {"uF", {kCapacitance, 1e-6}},
    {"nF", {kCapacitance, 1e-9}},
    {"H", {kInductance, 1.0}},
    {"mH", {kInductance, 1e-3}},
    {"uH", {kInductance, 1e-6}},
    {"T", {kFluxDensity, 1.0}},
    {"mT", {kFluxDensity, 1e-3}},
    {"uT", {kFluxDensity, 1e-6}},
};

/// A name with a power: `m`, `s^2`, `s2`, `m^-1`.
std::optional<UnitOfMeasure> factor_of(std::string_view text) {
  int power = 1;
  if (!text.empty() && text.back() >= '1' && text.back() <= '9' && text != "1") {
    power = text.back() - '0';
    text.remove_suffix(1);
    if (text.ends_with("^-")) power = -power;
    if (text.ends_with('-')) text.remove_suffix(1);
    if (text.ends_with('^')) text.remove_suffix(1);
  }
  for (const Named& named : kUnits) {
    if (named.name != text) continue;
    UnitOfMeasure unit = named.unit;
    for (auto& base : unit.powers) base = static_cast<std::int8_t>(base * power);
    unit.scale = std::pow(unit.scale, power);
    return unit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<UnitOfMeasure> unit_of(std::string_view text) {
  text = trimmed(text);
  UnitOfMeasure result;
  bool divides = false;
  for (;;) {
    const std::size_t end = text.find_first_of("*/");
    const auto factor = factor_of(trimmed(text.substr(0, end)));
    if (!factor) return std::nullopt;
    for (std::size_t i = 0; i < UnitOfMeasure::kBases; ++i) {
      const int power = result.powers[i] + (divides ? -factor->powers[i] : factor->powers[i]);
      constexpr int kMost = 100;
      if (power > kMost || power < -kMost) return std::nullopt;
      result.powers[i] = static_cast<std::int8_t>(power);
    }
    result.scale = divides ? result.scale / factor->scale : result.scale * factor->scale;
    if (end == std::string_view::npos) return result;
    divides = text[end] == '/';
    text.remove_prefix(end + 1);
  }
}

bool same_quantity(const UnitOfMeasure& a, const UnitOfMeasure& b) {
  return a.powers == b.powers;
}

bool same_scale(const UnitOfMeasure& a, const UnitOfMeasure& b) {
  constexpr double kRounding = 1e-9;  // of the products above
  return std::abs(a.scale - b.scale) <= kRounding * std::abs(a.scale);
}

}  // namespace eagerx::gen
