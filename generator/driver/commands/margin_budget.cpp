#include "generator/driver/commands/margin_budget.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/driver/commands/program.hpp"
#include "generator/frontend/read/rational.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/json/json.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

std::string tools_program() {
  std::error_code error;
  return (fs::read_symlink("/proc/self/exe", error).parent_path() / kToolsProgram).string();
}

/// The options that choose and change the graph, as they were given.
std::vector<std::string> command_for(const GraphOptions& options, const MarginBudgetSpec& margin) {
  std::vector<std::string> words = {tools_program(), "linearize", options.graph, "--open",
                                    margin.at.value, "--format",  "json",        "--quiet"};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {name, value});
  };
  add("--variant", options.variant);
  add("--engine", options.engine);
  if (options.rate_hz) add("--rate", options.rate_hz->to_string());
  if (options.engine_rate_hz) add("--engine-rate", options.engine_rate_hz->to_string());
  for (const std::string& path : options.paths) add("--path", path);
  if (margin.trim) words.emplace_back("--trim");
  if (margin.corners) words.emplace_back("--corners");
  return words;
}

/// The opened loop as that command prints it; nullopt with its messages in `failure` if it fails.
std::optional<Json> loop_of(const GraphOptions& options, const MarginBudgetSpec& margin,
                            std::string& failure) {
  const std::vector<std::string> command = command_for(options, margin);
  std::string printed;
  ProcessOptions lines;
  lines.line = [&](std::string_view line) { printed.append(line).append("\n"); };
  const auto result = run_process(command, lines);
  if (result && result->exit_code == 0) {
    const auto json = parse_json(printed);
    const Json* const loop = json ? member(&*json, margin.corners ? "corners" : "loop") : nullptr;
    if (loop != nullptr) return *loop;
  }
  // Once more for what it says.
  const auto said = run_process(command);
  failure = said ? said->output : "error: the program could not be started\n";
  return std::nullopt;
}

class MarginCheck {
 public:
  MarginCheck(const MarginBudgetSpec& margin, const Json& loop, Diagnostics& diagnostics)
      : margin_(margin), loop_(loop), diagnostics_(diagnostics) {}

  void run() {
    if (!truth_of(member(&loop_, "stable")).value_or(false)) {
      diagnostics_
          .error("E0428", margin_.at.span,
                 fmt::format("the loop through `{}` is unstable{}: spectral radius {:.6g}",
                             margin_.at.value, corner("stable"),
                             number("spectral_radius").value_or(0.0)))
          .help = help();
      return;
    }
    check(margin_.phase_deg, "a phase margin", magnitude(number("phase_deg")), "deg", "phase_deg");
    const auto up = decibels(number("gain")), down = decibels(number("least_gain"));
    const bool is_down = down && (!up || *down < *up);
    check(margin_.gain_db, "a gain margin", is_down ? down : up, "dB",
          is_down ? "least_gain" : "gain");
    check(margin_.delay_s, "a delay margin", number("delay_s"), "s", "delay_s");
  }

 private:
  std::optional<double> number(const char* key) const { return number_of(member(&loop_, key)); }
  static std::optional<double> magnitude(std::optional<double> value) {
    return value ? std::optional(std::abs(*value)) : std::nullopt;
  }
  static std::optional<double> decibels(std::optional<double> factor) {
    return factor ? std::optional(std::abs(20.0 * std::log10(*factor))) : std::nullopt;
  }
  /// " with robot.mass=0.6", of the corner with the figure.
  std::string corner(const char* key) const {
    const std::string at = text_of(member(member(&loop_, "at"), key));
    return at.empty() ? at : " with " + at;
  }
  std::string help() const {
    return fmt::format("`eagerx-gen linearize GRAPH.yaml --open {}` prints the loop and its poles",
                       margin_.at.value);
  }
  /// `value`: nothing if no change reaches the limit.
  void check(const std::optional<Spanned<Rational>>& entry, const char* what,
             std::optional<double> value, const char* unit, const char* figure) {
    if (!entry || !value) return;
    const double least = entry->value.to_double();
    if (*value >= least) return;
    diagnostics_
        .error("E0428", entry->span,
               fmt::format("the loop through `{}` has {} of {:.4g} {}{}, {:.4g} {} below its "
                           "budget of {:.6g}",
                           margin_.at.value, what, *value, unit, corner(figure), least - *value,
                           unit, least))
        .help = help();
  }

  const MarginBudgetSpec& margin_;
  const Json& loop_;
  Diagnostics& diagnostics_;
};

void check_one(Run& run, const GraphOptions& options, const MarginBudgetSpec& margin) {
  std::string failure;
  const auto loop = loop_of(options, margin, failure);
  if (loop) {
    MarginCheck(margin, *loop, run.diagnostics).run();
    return;
  }
  complain_text(failure);
  run.diagnostics
      .error("E0428", margin.at.span,
             fmt::format("the margins of the loop through `{}` are not known", margin.at.value))
      .help = "the messages above say why `eagerx-gen linearize` failed";
}

/// Why there is nothing to linearize; empty if there is.
std::string why_unchecked(const Graph& graph, const GraphOptions& options) {
  if (graph.has_engine() && graph.engine().entity->asynchronous)
    return fmt::format("on {}, which has no plant to linearize", graph.engine_id());
  if (graph.placement && options.split.empty()) return "of a graph with `placement:`";
  if (graph.cut) return "of nodes that are cut out of their graph";
  return {};
}

}  // namespace

void check_margin_budget(Run& run, const GraphOptions& options) {
  if (!run.spec->budget || run.spec->budget->margins.empty()) return;
  const std::string reason = why_unchecked(*run.graph, options);
  if (!reason.empty()) {
    if (!options.quiet) complain("note: margins of `budget:` are not checked {}\n", reason);
    return;
  }
  for (const MarginBudgetSpec& margin : run.spec->budget->margins) check_one(run, options, margin);
}

}  // namespace eagerx::gen
