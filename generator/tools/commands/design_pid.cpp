// eagerx-gen design pid: gains of a PidController.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/tools/commands/design_commands.hpp"
#include "generator/tools/commands/design_write.hpp"
#include "generator/tools/linear/design.hpp"

namespace eagerx::gen {
namespace {

struct PidOptions : DesignOptions {
  std::string crossover, phase_margin, terms;
};

PidRequest::Terms terms_of(const PidOptions& options, const GraphNode& node) {
  using Terms = PidRequest::Terms;
  if (options.terms == "p") return Terms::p;
  if (options.terms == "pi") return Terms::pi;
  if (options.terms == "pd") return Terms::pd;
  if (options.terms == "pid") return Terms::pid;
  const auto has = [&](const char* name) {
    const std::vector<double> values = parameter_of(node.config, name);
    return !values.empty() && values.front() != 0.0;
  };
  if (has("kd")) return has("ki") ? Terms::pid : Terms::pd;
  return has("kp") && !has("ki") ? Terms::p : Terms::pi;
}

std::optional<PidRequest> pid_request(const PidOptions& options, DesignRun& run) {
  PidRequest request;
  request.terms = terms_of(options, run.node());
  if (!options.phase_margin.empty()) {
    const NumberAndUnit parts = take_unit_off(options.phase_margin);
    const auto degrees = parse_number(trimmed(parts.number));
    if (!degrees || !(*degrees > 0.0 && *degrees < 180.0) ||
        (!parts.unit.empty() && parts.unit != "deg")) {
      run.diagnostics().usage_error(
          "E0522", fmt::format("`--phase-margin {}` is not an angle between 0 and 180 deg",
                               options.phase_margin));
      return std::nullopt;
    }
    request.phase_deg = *degrees;
  }
  if (!options.crossover.empty()) {
    const auto rate = parse_quantity(options.crossover, Quantity::rate);
    if (!rate || !(rate->to_double() > 0.0)) {
      run.diagnostics().usage_error(
          "E0522", fmt::format("`--crossover {}` is not a positive frequency", options.crossover));
      return std::nullopt;
    }
    request.crossover_hz = rate->to_double();
  }
  return request;
}

int perform_pid(const PidOptions& options) {
  DesignRun run(options);
  if (!run.begin({"PidController"}) || !run.open_at(run.sent())) return run.refuse();
  const auto request = pid_request(options, run);
  if (!request || !run.build()) return run.refuse();
  const auto printed = run.plant(run.sent(), {});
  if (!printed) return run.refuse();
  const PidDesign design = design_pid(*printed, run.plan(), *request);
  if (!design.problem.empty()) return run.refuse(design.problem, design.help);
  DesignReport report = run.report("loop shaping");
  report.parameters = {
      {"kp", {design.kp}, false}, {"ki", {design.ki}, false}, {"kd", {design.kd}, false}};
  report.facts.emplace_back("crossover", fmt::format("{:.6g} Hz", design.crossover_hz));
  if (request->terms != PidRequest::Terms::p)
    report.facts.emplace_back("phase margin", fmt::format("{:.6g} deg", design.phase_deg));
  report.numbers["crossover_hz"] = design.crossover_hz;
  report.losing = design.losing;
  report.smoothing = design.smoothing;
  if (!run.verify(report)) return run.refuse();
  return run.end(report);
}

Command pid_table(PidOptions& options) {
  return {
      .name = "pid",
      .about = "compute the gains of a PidController for a crossover frequency and a phase margin",
      .examples = {{"a crossover at 20 Hz with 60 degrees",
                    "eagerx-gen design pid robot.yaml --of speed --crossover '20 Hz' "
                    "--phase-margin '60 deg'"}},
      .arguments =
          joined({{graph(options),
                   text("--crossover", options.crossover,
                        "frequency at which the loop's gain is 1, in Hz (default: the one with the "
                        "largest integral gain)",
                        "HZ"),
                   text("--phase-margin", options.phase_margin,
                        "phase margin at the crossover, in degrees (default: 60)", "DEG"),
                   choice("--terms", {"p", "pi", "pd", "pid"},
                          "gains to compute (default: those that are not 0 in the graph, else pi)",
                          [&options](const std::string& name) { options.terms = name; })},
                  design_arguments(options, "a PidController")}),
      .run = [&options] { return perform_pid(options); }};
}

}  // namespace

Command design_pid_command() {
  return experimental(with_options<PidOptions>(pid_table));
}

}  // namespace eagerx::gen
