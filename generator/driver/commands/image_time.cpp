#include "generator/driver/commands/image_time.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "generator/driver/commands/image_graph.hpp"

namespace eagerx::gen {
namespace {

/// Of the graph's rates, in the order of the bits of a slot.
std::vector<std::string> rate_names(const Run& run) {
  std::vector<std::string> names;
  if (!run.plan) return names;
  for (const RateClass& rate : run.plan->rates) names.push_back(rate.rate_hz.to_string() + " Hz");
  return names;
}

}  // namespace

Machine machine_of(const Target& target) {
  Machine machine{target.id.value, target.cpu, target.clock_hz.value_or(0), target.wait_states, {}};
  for (const auto& [handler, most_hz] : target.interrupts)
    machine.interrupts.push_back({handler, most_hz});
  return machine;
}

std::optional<Machine> machine_of_image(Run& run, const LibraryOptions& options,
                                        const std::string& image) {
  std::ifstream in(image, std::ios::binary);
  const auto board = board_in_image(std::string(std::istreambuf_iterator<char>(in), {}));
  if (!board) return std::nullopt;
  if (!run.plan) load(run, options);
  const Target* target = run.library.find_target(*board);
  return target == nullptr ? std::nullopt : std::optional(machine_of(*target));
}

std::optional<BoundReport> bound_of_image(Run& run, const std::string& image,
                                          const Machine* machine) {
  return bound_instructions(image, rate_names(run), machine, run.diagnostics);
}

std::optional<Json> time_json(Run& run, const LibraryOptions& options, const std::string& image) {
  const auto machine = machine_of_image(run, options, image);
  Diagnostics unbound;  // the page lists what has no bound
  const auto report =
      bound_instructions(image, rate_names(run), machine ? &*machine : nullptr, unbound);
  if (!report) return std::nullopt;
  Json json = bound_json(*report, false);
  if (const auto fit = fit_of(*report, *run.plan)) json["fit"] = fit_json(*fit);
  return json;
}

void note_built_time(Run& run, const GraphOptions& options,
                     const std::vector<BuiltProgram>& programs) {
  if (run.spec->budget && limits_time(*run.spec->budget)) return;  // which was checked
  for (const BuiltProgram& program : programs) {
    const Machine machine = machine_of(*program.target);
    // A part of a graph has no slots of its own.
    if (program.part != nullptr || !has_cycles(machine)) continue;
    Diagnostics unbound;
    const auto report = bound_instructions(program.image, rate_names(run), &machine, unbound);
    if (!report || report->slots.empty()) continue;
    const std::string command =
        fmt::format("`eagerx-gen size {} --graph {} --worst`", program.image, options.graph);
    const auto fit = fit_of(*report, *run.plan);
    if (fit)
      complain("note: {}, by the bound of the image: {}\n", busiest_text(*fit), command);
    else if (!report->missing.empty())
      complain("note: the time of slots has no bound, because of {} at {}: {}\n",
               report->missing.front().what, report->missing.front().place, command);
  }
}

void check_built_time(Run& run, const BuiltProgram& program) {
  const Machine machine = machine_of(*program.target);
  const auto report = bound_of_image(run, program.image, &machine);
  if (report)
    check_time_budget(*report, fit_of(*report, *run.plan), *run.plan, *run.spec->budget,
                      run.diagnostics);
}

}  // namespace eagerx::gen
