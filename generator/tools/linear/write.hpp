// A sampled system, its poles and its margins as text, JSON or a table.
#pragma once

#include <optional>
#include <string>

#include "generator/graph/plan/ages.hpp"
#include "generator/support/json/json.hpp"
#include "generator/tools/linear/corners.hpp"
#include "generator/tools/linear/modes.hpp"
#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

/// All that was found.
struct LinearReport {
  const SampledSystem* system = nullptr;
  Modes modes;
  std::optional<Margins> margins;  // with `--open`
  std::string opened;              // the port
  std::vector<DataAge> ages;       // of data that go through it
  std::optional<WorstMargins> corners;
};

std::string linear_text(const LinearReport& report);
Json linear_json(const LinearReport& report);
/// Of the opened loop alone.
Json margins_json(const LinearReport& report);
/// The loop at frequencies: frequency_hz, gain, gain_db, phase_deg.
std::string response_csv(const SampledSystem& system);

}  // namespace eagerx::gen
