#include "generator/tools/linear/loop_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eagerx::gen {
namespace {

constexpr std::size_t kFrequencies = 400, kSteps = 600;

std::vector<BodePoint> bode_of(const SampledSystem& system) {
  constexpr double kMost_dB = 800.0;  // where the gain is 0 or infinite
  std::vector<BodePoint> points;
  for (const Response& each : responses_of(system, kFrequencies)) {
    double phase_deg = std::arg(each.loop) * 180.0 / std::numbers::pi;
    if (!points.empty())
      phase_deg += 360.0 * std::round((points.back().phase_deg - phase_deg) / 360.0);
    const double gain_db = 20.0 * std::log10(std::abs(each.loop));
    points.push_back(
        {each.frequency_hz, std::clamp(gain_db, -kMost_dB, kMost_dB), phase_deg, each.loop});
  }
  return points;
}

/// Adds whole turns, so that the limit of the phase margin is -180 degrees, as textbooks draw it.
void turn_to_limit(const Margins& margins, std::vector<BodePoint>& bode) {
  if (!margins.phase_deg || !margins.crossover_hz || bode.empty()) return;
  auto near = std::ranges::lower_bound(bode, *margins.crossover_hz, {}, &BodePoint::frequency_hz);
  if (near == bode.end()) --near;
  const double turns = std::round((near->phase_deg - (*margins.phase_deg - 180.0)) / 360.0);
  for (BodePoint& each : bode) each.phase_deg -= 360.0 * turns;
}

/// Half as long again as it takes until the response stays within 1 % of its end; every n-th
/// message, so that at most kSteps are left.
std::vector<StepSample> seen_of(std::vector<StepSample> all, std::size_t& stride) {
  constexpr std::size_t kFewest = 40;
  std::size_t settled = all.size();
  while (settled > 0 && std::abs(all[settled - 1].sent - all.back().sent) < 0.01) --settled;
  all.resize(std::min(all.size(), std::max(kFewest, settled + settled / 2)));
  stride = (all.size() + kSteps - 1) / kSteps;
  std::vector<StepSample> kept;
  for (std::size_t i = 0; i < all.size(); i += stride) kept.push_back(all[i]);
  return kept;
}

double rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) return 0.0;
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

Json complex_json(const std::vector<std::complex<double>>& values) {
  Json list = Json::list();
  for (const auto z : values) list.push_back(Json::List{rounded(z.real()), rounded(z.imag())});
  return list;
}

/// [time, returned, sent]
Json step_json(const std::vector<StepSample>& samples) {
  Json list = Json::list();
  for (const StepSample& each : samples)
    list.push_back(Json::List{rounded(each.time_s), rounded(each.returned), rounded(each.sent)});
  return list;
}

}  // namespace

LoopCurves loop_curves_of(const LinearReport& report) {
  LoopCurves curves;
  curves.port = report.opened;
  curves.margins = *report.margins;
  curves.bode = bode_of(*report.system);
  turn_to_limit(curves.margins, curves.bode);
  for (const Pole& pole : report.modes.poles) {
    curves.open_poles.push_back(pole.z);
    if (pole.z.imag() != 0.0) curves.open_poles.push_back(std::conj(pole.z));
  }
  curves.closed_poles = closed_poles_of(*report.system);
  curves.step = seen_of(step_response_of(*report.system), curves.stride);
  return curves;
}

std::size_t step_messages(const LoopCurves& curves) {
  return curves.step.empty() ? 0 : (curves.step.size() - 1) * curves.stride + 1;
}

void add_simulated_step(const std::vector<double>& with, const std::vector<double>& without,
                        double size, const std::string& unit, LoopCurves& curves) {
  SimulatedStep simulated{size, unit, {}, 0.0};
  for (std::size_t i = 0; i < curves.step.size(); ++i) {
    const std::size_t message = i * curves.stride;
    if (message >= with.size() || message >= without.size()) break;
    const double sent = (with[message] - without[message]) / size;
    simulated.step.push_back({curves.step[i].time_s, 1.0 + sent, -sent});
    simulated.difference =
        std::max(simulated.difference, std::abs(-sent - curves.step[i].returned));
  }
  curves.simulated = std::move(simulated);
}

Json loop_curves_json(const LoopCurves& curves) {
  Json bode = Json::list();
  for (const BodePoint& each : curves.bode)
    bode.push_back(Json::List{rounded(each.frequency_hz), rounded(each.gain_db),
                              rounded(each.phase_deg), rounded(each.loop.real()),
                              rounded(each.loop.imag())});
  Json json{{"bode", std::move(bode)},
            {"open_poles", complex_json(curves.open_poles)},
            {"closed_poles", complex_json(curves.closed_poles)},
            {"step", step_json(curves.step)}};
  const SimulatedStep& simulated = curves.simulated;
  if (simulated.size != 0.0)
    json["simulated"] = Json{{"size", simulated.size},
                             {"unit", simulated.unit},
                             {"difference", rounded(simulated.difference)},
                             {"step", step_json(simulated.step)}};
  return json;
}

Json parameters_json(const Hyperperiod& there) {
  Json list = Json::list();
  const auto& states = there.states;
  for (std::size_t begin = 0, end = 0; begin < states.size(); begin = end) {
    Json values = Json::list(), low = Json::list(), high = Json::list();
    bool is_all = true;
    for (; end < states.size() && states[end].state == states[begin].state; ++end) {
      const ResetElement& each = states[end];
      is_all = is_all && is_parameter(there, each);
      values.push_back(each.value);
      low.push_back(each.low ? Json(*each.low) : Json(nullptr));
      high.push_back(each.high ? Json(*each.high) : Json(nullptr));
    }
    if (is_all)
      list.push_back(Json{{"name", states[begin].state},
                          {"values", std::move(values)},
                          {"low", std::move(low)},
                          {"high", std::move(high)}});
  }
  return list;
}

}  // namespace eagerx::gen
