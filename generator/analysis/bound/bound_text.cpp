// The table of bounds, as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/analysis/bound/bound.hpp"

namespace eagerx::gen {
namespace {

constexpr double kUsPerS = 1e6;

double us_of(const TimeModel& time, std::uint64_t cycles) {
  return time.seconds(cycles) * kUsPerS;
}

std::string row_text(const InstructionBound& row, const std::optional<TimeModel>& time,
                     std::string_view indent = "  ") {
  std::string text = fmt::format("{:<30} {:>10}", fmt::format("{}{}", indent, row.name), row.most);
  if (time) text += fmt::format(" {:>10} {:>11.1f}", row.cycles, us_of(*time, row.cycles));
  return text + (row.is_bound ? "\n" : " and more\n");
}

void add_rows(std::string& text, const char* title, const std::vector<InstructionBound>& rows,
              const std::optional<TimeModel>& time) {
  if (rows.empty()) return;
  text += fmt::format("{}\n", title);
  for (const InstructionBound& row : rows) text += row_text(row, time);
}

/// With the nodes of each, if there are several kinds: else they are those of a step.
void add_slots(std::string& text, const BoundReport& report) {
  if (report.slots.empty()) return;
  text += "slots, without the schedule\n";
  for (const SlotBound& slot : report.slots) {
    text += row_text(slot, report.time);
    if (report.slots.size() == 1) return;
    for (const InstructionBound& node : slot.nodes) text += row_text(node, report.time, "    ");
  }
}

std::string wait_states_text(const TimeModel& time) {
  if (!time.wait_states) return "wait states of the memory not stated, none counted";
  return fmt::format("{} wait state{}", *time.wait_states, *time.wait_states == 1 ? "" : "s");
}

/// What the figures rest on.
std::string assumptions_text(const TimeModel& time) {
  std::string text =
      fmt::format("cycles of a {} by Arm's tables; us at {:.6g} MHz, {}\n", time.cpu,
                  static_cast<double>(time.clock_hz) / kUsPerS, wait_states_text(time));
  for (const InterruptBound& interrupt : time.interrupts)
    text += fmt::format("us include {}: {} cycles, at most {:g} times a second\n",
                        interrupt.handler, interrupt.cycles, interrupt.most_hz);
  text += fmt::format("not covered: {}DMA, other bus masters, accesses that are not aligned\n",
                      time.interrupts.empty() ? "interrupts, " : "other interrupts, ");
  return text;
}

Json rows_json(const std::vector<InstructionBound>& rows, const std::optional<TimeModel>& time) {
  Json json = Json::list();
  for (const InstructionBound& row : rows) json.push_back(bound_row_json(row, time));
  return json;
}

Json slots_json(const BoundReport& report) {
  Json json = Json::list();
  for (const SlotBound& slot : report.slots) {
    Json row = bound_row_json(slot, report.time);
    row["nodes"] = rows_json(slot.nodes, report.time);
    json.push_back(std::move(row));
  }
  return json;
}

Json time_model_json(const TimeModel& time) {
  Json json{{"board", time.board}, {"cpu", time.cpu}, {"clock_hz", time.clock_hz}};
  if (time.wait_states) json["wait_states"] = std::uint64_t{*time.wait_states};
  Json interrupts = Json::list();
  for (const InterruptBound& one : time.interrupts)
    interrupts.push_back(
        Json{{"handler", one.handler}, {"cycles", one.cycles}, {"most_hz", one.most_hz}});
  json["interrupts"] = std::move(interrupts);
  return json;
}

}  // namespace

/// The shortest time that has room for the work and for all interrupts that can begin in it:
/// M. Joseph, P. Pandya, "Finding Response Times in a Real-Time System" (1986).
double TimeModel::seconds(std::uint64_t cycles) const {
  const auto hz = static_cast<double>(clock_hz);
  double share = 0;
  for (const InterruptBound& one : interrupts)
    share += static_cast<double>(one.cycles) * one.most_hz / hz;
  if (share >= 1) return std::numeric_limits<double>::infinity();
  double busy = static_cast<double>(cycles);
  for (double before = -1; busy > before;) {
    before = busy;
    busy = static_cast<double>(cycles);
    for (const InterruptBound& one : interrupts)
      busy += (std::floor(before / hz * one.most_hz) + 1) * static_cast<double>(one.cycles);
  }
  return busy / hz;
}

const InstructionBound* BoundReport::part(std::string_view name) const {
  const auto found = std::ranges::find(parts, name, &InstructionBound::name);
  return found == parts.end() ? nullptr : &*found;
}

Json bound_row_json(const InstructionBound& row, const std::optional<TimeModel>& time) {
  Json json{{"name", row.name}, {"most", row.most}, {"bound", row.is_bound}};
  if (!time) return json;
  json["cycles"] = row.cycles;
  json["us"] = us_of(*time, row.cycles);
  return json;
}

std::string bound_rows_text(const char* title, const std::vector<InstructionBound>& rows,
                            const std::optional<TimeModel>& time) {
  std::string text;
  add_rows(text, title, rows, time);
  return text;
}

std::string bound_text(const BoundReport& report) {
  std::string text = report.time ? fmt::format("{:<30} {:>10} {:>10} {:>11}\n",
                                               "at most, from the image", "instr.", "cycles", "us")
                                 : fmt::format("instructions at most, from the image alone: {}\n",
                                               report.why_no_time);
  add_rows(text, "parts of a step", report.parts, report.time);
  add_slots(text, report);
  add_rows(text, "nodes, in a step", report.nodes, report.time);
  if (report.time) text += assumptions_text(*report.time);
  return text;
}

Json bound_json(const BoundReport& report, bool with_functions) {
  Json json;
  json["parts"] = rows_json(report.parts, report.time);
  json["slots"] = slots_json(report);
  json["nodes"] = rows_json(report.nodes, report.time);
  if (report.time) json["time"] = time_model_json(*report.time);
  Json functions = Json::list();
  for (const FunctionBound& one : report.functions)
    functions.push_back(Json{{"name", one.name}, {"address", one.address}, {"most", one.most}});
  if (with_functions) json["functions"] = std::move(functions);
  Json missing = Json::list();
  for (const NoBound& one : report.missing)
    missing.push_back(
        Json{{"what", one.what}, {"place", one.place}, {"function", one.function}, {"of", one.of}});
  json["missing"] = std::move(missing);
  return json;
}

}  // namespace eagerx::gen
