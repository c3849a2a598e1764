#include "generator/driver/commands/image_time.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "generator/driver/commands/image_graph.hpp"
#include "generator/support/diagnostics/search.hpp"

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

std::optional<ImageTime> time_of_image(Run& run, const LibraryOptions& options,
                                       const std::string& image, bool of_graph,
                                       Diagnostics& diagnostics) {
  const auto machine = machine_of_image(run, options, image);
  auto bound =
      bound_instructions(image, rate_names(run), machine ? &*machine : nullptr, diagnostics);
  if (!bound) return std::nullopt;
  ImageTime time{std::move(*bound), std::nullopt, std::nullopt};
  if (!of_graph || !run.plan) return time;
  time.steps = step_bounds(time.bound, *run.plan);
  time.fit = fit_of(time.bound, *run.plan);
  return time;
}

bool check_image_nodes(const std::string& image, const std::vector<std::string>& nodes,
                       const Graph& graph, Diagnostics& diagnostics) {
  for (const std::string& name : nodes) {
    if (ranges::contains(graph.nodes, name, &GraphNode::name)) continue;
    diagnostics
        .error("E0361", {},
               fmt::format("`{}` is an image of another graph: `{}` has no node `{}`", image,
                           graph.file_name, name))
        .help = "give an image that was built from this graph and for the same engine";
    return false;
  }
  return true;
}

std::string time_text(const ImageTime& time) {
  return bound_text(time.bound) + (time.steps ? steps_text(*time.steps, time.bound.time) : "") +
         (time.fit ? fit_text(*time.fit) : "");
}

Json time_json(const ImageTime& time, bool with_functions) {
  Json json = bound_json(time.bound, with_functions);
  if (time.steps) json["steps"] = steps_json(*time.steps, time.bound.time);
  if (time.fit) json["fit"] = fit_json(*time.fit);
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
  const auto report = bound_instructions(program.image, rate_names(run), &machine, run.diagnostics);
  if (report)
    check_time_budget(*report, fit_of(*report, *run.plan), *run.plan, *run.spec->budget,
                      run.diagnostics);
}

}  // namespace eagerx::gen
