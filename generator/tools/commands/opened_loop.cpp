#include "generator/tools/commands/opened_loop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/analysis/info/info.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/tools/linear/loop_curves.hpp"

namespace eagerx::gen {
namespace {

/// Ages of data that go through the opened port.
std::vector<DataAge> ages_through(const Plan& plan, std::size_t channel, const PlanInfo& info) {
  std::vector<DataAge> result;
  for (const DataAge& age : info.ages) {
    const bool passes = std::ranges::any_of(age.path, [&](const AgeEdge& edge) {
      return std::ranges::any_of(plan.graph->nodes, [&](const GraphNode& node) {
        return std::ranges::any_of(node.inputs, [&](const Input& input) {
          return input.written == edge.input && input.source_node == plan.channels[channel].node &&
                 input.source_output == plan.channels[channel].output;
        });
      });
    });
    if (passes) result.push_back(age);
  }
  return result;
}

/// Of the loop opened at `port`, through the program `image`.
std::optional<Json> loop_json(Run& run, const LinearOptions& options, const std::string& image,
                              const std::string& port, int& code) {
  const auto opened = opened_port(port, *run.plan, run.diagnostics);
  if (!opened) return std::nullopt;
  std::vector<std::string> words = first_words(options, *run.plan);
  words.insert(words.end(), {"--open", fmt::format("{}", opened->channel), "--element",
                             fmt::format("{}", opened->element)});
  const auto system = system_of(run, image, words, code);
  if (!system) return std::nullopt;
  LinearReport report{&*system, modes_of(*system), {}, port, {}, {}};
  if (!add_loop(run, *opened, report)) return std::nullopt;
  Json json = loop_curves_json(loop_curves_of(report));
  json["margins"] = margins_json(report);
  return json;
}

}  // namespace

bool add_loop(Run& run, const PortElement& port, LinearReport& report) {
  if (report.system->opened == 0) {
    run.diagnostics.error("E0520", run.graph->span,
                          fmt::format("`{}` has no numbers with derivatives", report.opened));
    return false;
  }
  report.margins = margins_of(*report.system);
  report.ages =
      ages_through(*run.plan, port.channel, info_of(*run.plan, run.spec->budget, run.diagnostics));
  return true;
}

std::optional<Json> loops_json(const GenerateOptions& options,
                               const std::vector<std::string>& ports, int& code) {
  LinearOptions linear;
  static_cast<GenerateOptions&>(linear) = options;
  linear.output.clear();
  Run run;
  Json loops = Json::list();
  bool is_complete = make_linear_graph(run, linear);
  for (const std::string& port : ports)
    is_complete = is_complete && opened_port(port, *run.plan, run.diagnostics);
  const auto image = is_complete ? build_linear_program(run, linear, code) : std::nullopt;
  is_complete = image.has_value();
  for (const std::string& port : ports) {
    auto loop = is_complete ? loop_json(run, linear, *image, port, code) : std::nullopt;
    is_complete = loop.has_value();
    if (loop) loops.push_back(std::move(*loop));
  }
  // Its warnings are those of the page.
  if (is_complete) run.diagnostics = {};
  code = std::max(finish(run, options), code);
  return is_complete ? std::optional(std::move(loops)) : std::nullopt;
}

}  // namespace eagerx::gen
