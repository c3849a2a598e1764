// eagerx-gen design lqr: gains of a StateFeedback.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/commands/design_commands.hpp"
#include "generator/tools/commands/design_values.hpp"
#include "generator/tools/commands/design_write.hpp"
#include "generator/tools/linear/design.hpp"

namespace eagerx::gen {
namespace {

struct LqrOptions : DesignOptions {
  std::vector<std::string> deviations, efforts;
};

/// Finds what `--deviation` and `--effort` name.
class LqrValues {
 public:
  LqrValues(DesignRun& run, const LqrOptions& options) : run_(run), options_(options) {}

  LqrRequest request;
  std::vector<std::size_t> seen;  // channels of further ports

  bool read() {
    request.gain = parameter_of(run_.node().config, "gain");
    for (const std::string& text : options_.deviations) {
      const auto value = split_value("--deviation", text, run_.diagnostics());
      if (!value || !take(*value, text)) return false;
    }
    if (request.deviations.empty()) {
      run_.diagnostics().usage_error("E0522", "no `--deviation` is given").help =
          fmt::format("add the largest tolerable deviations: `--deviation {}=…`",
                      run_.input("x") != nullptr ? run_.input("x")->written : "PORT");
      return false;
    }
    return read_efforts();
  }

 private:
  bool take(const NamedValue& value, const std::string& text) {
    for (const Input& input : run_.node().inputs) {
      if (!run_.is_input(value.name, input)) continue;
      return add(value, run_.unit(run_.channel(input)), input.space.size(),
                 {Deviation::Of::received, input.name, 0, 0, 1.0});
    }
    const std::vector<NamedChannel> ports = port_names(run_.plan());
    const auto port = ranges::find(ports, value.name, &NamedChannel::name);
    if (port != ports.end()) {
      const auto known = std::ranges::find(seen, port->channel);
      const auto at = static_cast<std::size_t>(known - seen.begin());
      const std::size_t size = space_of(run_.plan(), port->channel).size();
      if (known == seen.end()) {
        seen.push_back(port->channel);
        request.port_sizes.push_back(size);
      }
      return add(value, run_.unit(port->channel), size,
                 {Deviation::Of::port, value.name, 0, at, 1.0});
    }
    // A number of the state, whose name may end with an index.
    const auto number = positive_in("", "--deviation", value.values.front(), run_.diagnostics());
    if (!number) return false;
    request.deviations.push_back({Deviation::Of::state,
                                  std::string(trimmed(text.substr(0, text.find('=')))), 0, 0,
                                  *number});
    return true;
  }
  bool add(const NamedValue& value, const std::string& unit, std::size_t size,
           Deviation deviation) {
    std::vector<std::optional<double>> elements(size);
    if (!spread_values("--deviation", value, unit, elements, run_.diagnostics())) return false;
    for (std::size_t i = 0; i < size; ++i) {
      if (!elements[i]) continue;
      deviation.element = i;
      deviation.value = *elements[i];
      request.deviations.push_back(deviation);
    }
    return true;
  }

  bool read_efforts() {
    const std::size_t rows = run_.node().outputs.front().space.size();
    std::vector<std::optional<double>> efforts(rows);
    for (const std::string& text : options_.efforts) {
      const auto value = split_value("--effort", text, run_.diagnostics());
      if (!value) return false;
      if (!run_.is_sent(value->name)) {
        run_.diagnostics()
            .usage_error("E0522",
                         fmt::format("`{}` does not send `{}`", run_.node().name, value->name))
            .help =
            fmt::format("write `--effort {}=VALUE`", run_.plan().channels[run_.sent()].port);
        return false;
      }
      if (!spread_values("--effort", *value, run_.unit(run_.sent()), efforts, run_.diagnostics()))
        return false;
    }
    const auto limit = [&](const char* name, std::size_t i) {
      const std::vector<double> values = parameter_of(run_.node().config, name);
      return values.empty() ? 0.0 : std::abs(values[values.size() == 1 ? 0 : i]);
    };
    for (std::size_t i = 0; i < rows; ++i) {
      const double most = std::max(limit("low", i), limit("high", i));
      if (!efforts[i] && std::isfinite(most) && most > 0.0) efforts[i] = most;
      if (!efforts[i]) {
        run_.diagnostics()
            .usage_error("E0522", fmt::format("the output of `{}` has no limit that could be its "
                                              "largest effort",
                                              run_.node().name))
            .help =
            fmt::format("write `--effort {}=VALUE`", run_.plan().channels[run_.sent()].port);
        return false;
      }
      request.efforts.push_back(*efforts[i]);
    }
    return true;
  }

  DesignRun& run_;
  const LqrOptions& options_;
};

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100.0 * share);
}

void describe(const LqrDesign& design, const LqrRequest& request, DesignReport& report) {
  std::vector<std::string> efforts, missing;
  for (const double each : request.efforts) efforts.push_back(fmt::format("{:.6g}", each));
  report.facts.emplace_back("effort", join(efforts, ", "));
  Json names = Json::object();
  for (const MissingState& each : design.missing) {
    missing.push_back(fmt::format("{} ({})", each.name, percent(each.share)));
    names[each.name] = each.share;
  }
  if (design.unknown > 1e-6) {
    report.facts.emplace_back(
        "not received", fmt::format("{} of the output of the full-state regulator, for lack of {}",
                                    percent(design.unknown), join(missing, ", ")));
    report.facts.emplace_back(
        "cost", fmt::format("{:.5g} times that of the full-state regulator; the gains are the best "
                            "constant output feedback",
                            design.cost));
  } else {
    report.facts.emplace_back(
        "cost", "that of the full-state regulator: the node receives the whole state");
  }
  if (!design.free.empty())
    report.facts.emplace_back(
        "free", fmt::format("{} costs nothing, changes no gain, and does not come to rest",
                            join(design.free, ", ")));
  report.numbers["unknown"] = design.unknown;
  report.numbers["cost"] = design.cost;
  report.numbers["missing"] = std::move(names);
  report.numbers["free"] = design.free;
}

int perform_lqr(const LqrOptions& options) {
  DesignRun run(options);
  if (!run.begin({"StateFeedback"}) || !run.open_at(run.sent())) return run.refuse();
  LqrValues values(run, options);
  if (!values.read() || !run.build()) return run.refuse();
  const auto printed = run.plant(run.sent(), values.seen);
  if (!printed) return run.refuse();
  LqrDesign design = design_lqr(*printed, run.plan(), "x", values.request);
  if (!design.problem.empty()) return run.refuse(design.problem, design.help);
  DesignReport report = run.report("linear-quadratic regulator");
  DesignedParameter gain{"gain", {}};
  for (const auto& row : design.gain) gain.values.insert(gain.values.end(), row.begin(), row.end());
  report.parameters.push_back(std::move(gain));
  describe(design, values.request, report);
  report.losing = design.losing;
  report.smoothing = design.smoothing;
  if (!run.verify(report)) return run.refuse();
  return run.end(report);
}

Command lqr_table(LqrOptions& options) {
  return {
      .name = "lqr",
      .about =
          "compute the gains of a StateFeedback from the largest tolerable deviations and efforts "
          "(Bryson's rule)",
      .examples = {{"from three deviations, with the limits of the node as effort",
                    "eagerx-gen design lqr robot.yaml --of balance --deviation "
                    "balance.x=0.5,0.1,1"}},
      .arguments = joined(
          {{graph(options),
            texts("--deviation", options.deviations,
                  "largest tolerable deviation of each element of a port, or of a number of the "
                  "state",
                  "PORT=VALUE"),
            texts("--effort", options.efforts,
                  "largest effort of each element of the output (default: its limits)",
                  "PORT=VALUE")},
           design_arguments(options, "a StateFeedback")}),
      .run = [&options] { return perform_lqr(options); }};
}

}  // namespace

Command design_lqr_command() {
  return experimental(with_options<LqrOptions>(lqr_table));
}

}  // namespace eagerx::gen
