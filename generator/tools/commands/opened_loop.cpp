#include "generator/tools/commands/opened_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/analysis/info/info.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/tools/page/units.hpp"

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

/// 5 % of what the port can send, or else 1.
double default_step(const Space& space, std::size_t element) {
  constexpr double kShare = 0.05;
  if (element >= space.low.size() || element >= space.high.size()) return 1.0;
  const double range = space.high[element] - space.low[element];
  return std::isfinite(range) && range > 0.0 ? kShare * range : 1.0;
}

std::vector<double> numbers_in(const Json* list) {
  std::vector<double> numbers;
  if (list == nullptr || !list->is<Json::List>()) return numbers;
  for (const Json& item : *list->as<Json::List>())
    numbers.push_back(number_of(&item).value_or(0.0));
  return numbers;
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
  const auto curves = loop_curves_of_program(run, image, words, *opened, 0.0, report, code);
  if (!curves) return std::nullopt;
  return loop_page_json(*curves, report);
}

}  // namespace

Json loop_page_json(const LoopCurves& curves, const LinearReport& report) {
  Json json = loop_curves_json(curves);
  json["margins"] = margins_json(report);
  return json;
}

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

std::optional<LoopCurves> loop_curves_of_program(Run& run, const std::string& image,
                                                 std::vector<std::string> words,
                                                 const PortElement& port, double size,
                                                 const LinearReport& report, int& code) {
  LoopCurves curves = loop_curves_of(report);
  if (size == 0.0) size = default_step(space_of(*run.plan, port.channel), port.element);
  const std::size_t messages = report.system->opened;
  words.insert(words.end(), {"--step-size", fmt::format("{:.17g}", size), "--hyperperiods",
                             fmt::format("{}", (step_messages(curves) + messages - 1) / messages)});
  std::string failure;
  const auto text = printed_by(image, words, failure, code);
  const auto json = text ? parse_json(*text) : std::nullopt;
  if (!json) {
    complain_text(failure);
    return std::nullopt;
  }
  const Channel& sent = run.plan->channels[port.channel];
  const GraphNode& node = run.graph->nodes[sent.node];
  add_simulated_step(numbers_in(member(&*json, "with")), numbers_in(member(&*json, "without")),
                     size, unit_of(*run.graph, node, node.outputs[sent.output]), curves);
  return curves;
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
