// eagerx-gen design kalman: covariances of a KalmanFilter, and the gain of an Observer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/commands/design_commands.hpp"
#include "generator/tools/commands/design_values.hpp"
#include "generator/tools/commands/design_write.hpp"
#include "generator/tools/linear/design.hpp"

namespace eagerx::gen {
namespace {

struct KalmanOptions : DesignOptions {
  std::vector<std::string> process, measurement;
  bool model = false;
};

/// Variances of what a node sends, where sensor models alone say them: element by element.
std::vector<std::optional<double>> modelled_noise(const Graph& graph, std::size_t n) {
  const GraphNode& node = graph.nodes[n];
  const std::string id = node.entity != nullptr ? node.entity->id.value : std::string();
  std::vector<std::optional<double>> variances;
  if (id == "Mux") {
    for (const Input& input : node.inputs) {
      const auto part = modelled_noise(graph, input.source_node);
      variances.insert(variances.end(), part.begin(), part.end());
    }
    return variances;
  }
  variances.resize(node.outputs.empty() ? 0 : node.outputs.front().space.size());
  if (id != "SensorModel") return variances;
  const auto each = [&](const char* name, std::size_t i) {
    const std::vector<double> values = parameter_of(node.config, name);
    return values.empty() ? 0.0 : values[values.size() == 1 ? 0 : i];
  };
  for (std::size_t i = 0; i < variances.size(); ++i) {
    // Even noise of half the width w has the variance w²/3.
    const double spread = each("spread", i), step = each("resolution", 0) / 2.0;
    variances[i] = each("noise", i) * each("noise", i) + (spread * spread + step * step) / 3.0;
  }
  return variances;
}

class KalmanValues {
 public:
  KalmanValues(DesignRun& run, const KalmanOptions& options) : run_(run), options_(options) {}

  KalmanRequest request;

  /// Of the model in `request`.
  bool read() { return read_measurements() && read_process(); }

 private:
  bool read_measurements() {
    const Input& measured = *run_.input("measured");
    std::vector<std::optional<double>> deviations(measured.space.size());
    const auto modelled = modelled_noise(*run_.plan().graph, measured.source_node);
    for (std::size_t i = 0; i < deviations.size() && modelled.size() == deviations.size(); ++i) {
      if (modelled[i] && *modelled[i] > 0.0) deviations[i] = std::sqrt(*modelled[i]);
    }
    for (const std::string& text : options_.measurement) {
      const auto value = split_value("--measurement", text, run_.diagnostics());
      if (!value) return false;
      if (!run_.is_input(value->name, measured))
        return unknown("--measurement", value->name, {measured.written});
      if (!spread_values("--measurement", *value, run_.unit(run_.channel(measured)), deviations,
                         run_.diagnostics()))
        return false;
    }
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      if (!deviations[i]) {
        run_.diagnostics()
            .usage_error("E0522", fmt::format("no SensorModel says the noise of element {} of `{}`",
                                              i, measured.written))
            .help = fmt::format("write its standard deviation: `--measurement {}[{}]=VALUE`",
                                measured.written, i);
        return false;
      }
      request.measured.push_back(*deviations[i]);
    }
    return true;
  }
  bool read_process() {
    const std::size_t order = request.model.order;
    std::vector<std::optional<double>> states(order);
    const Input* const u = run_.input("u");
    std::vector<std::optional<double>> inputs(u != nullptr ? u->space.size() : 0);
    for (const std::string& text : options_.process) {
      const auto value = split_value("--process", text, run_.diagnostics());
      if (!value) return false;
      const std::string whole(trimmed(text.substr(0, text.find('='))));
      const auto named = std::ranges::find(request.state, whole);
      if (named != request.state.end()) {
        const auto number = positive_in("", "--process", value->values.front(), run_.diagnostics());
        if (!number) return false;
        states[static_cast<std::size_t>(named - request.state.begin())] = *number;
      } else if (value->name == "x") {
        if (!spread_values("--process", *value, "", states, run_.diagnostics())) return false;
      } else if (u != nullptr && run_.is_input(value->name, *u)) {
        if (!spread_values("--process", *value, run_.unit(run_.channel(*u)), inputs,
                           run_.diagnostics()))
          return false;
      } else {
        std::vector<std::string> names = request.state;
        names.push_back("x");
        if (u != nullptr) names.push_back(u->written);
        return unknown("--process", whole, names);
      }
    }
    if (options_.process.empty()) {
      run_.diagnostics().usage_error("E0522", "no noise drives the system").help =
          "write its standard deviation at a tick: `--process x[0]=VALUE`, or of the input `u`";
      return false;
    }
    for (const auto& each : states) request.process.push_back(each.value_or(0.0));
    for (const auto& each : inputs) request.input.push_back(each.value_or(0.0));
    return true;
  }
  bool unknown(const char* option, const std::string& name, const std::vector<std::string>& names) {
    run_.diagnostics()
        .usage_error("E0522", fmt::format("`{} {}` is nothing that this filter has", option, name))
        .help = "there is `" + join(names, "`, `") + "`";
    return false;
  }

  DesignRun& run_;
  const KalmanOptions& options_;
};

/// The model of the node, or with `--model` that of the graph. False with a problem, in `problem`.
bool find_model(DesignRun& run, const KalmanOptions& options, KalmanRequest& request,
                DesignReport& report, std::string& problem, std::string& help) {
  const auto order = static_cast<std::size_t>(parameter_of(run.node().config, "order").front());
  if (!options.model) {
    request.model = {order, parameter_of(run.node().config, "a"),
                     parameter_of(run.node().config, "b"), parameter_of(run.node().config, "c")};
    return true;
  }
  const Input* const u = run.input("u");
  const auto printed = run.plant(u != nullptr ? std::optional(run.channel(*u)) : std::nullopt, {});
  if (!printed) return false;
  ModelDesign found = model_of(*printed, run.plan());
  problem = found.problem;
  help = found.help;
  if (!problem.empty()) return false;
  if (found.model.order != order) {
    problem = fmt::format("`{}` has {}, and what it measures depends on {}: {}", run.node().name,
                          counted(order, "state"), found.model.order, join(found.state, ", "));
    help = fmt::format("write `order: {}`, and lists of this size", found.model.order);
    return false;
  }
  request.model = found.model;
  request.state = found.state;
  report.parameters.push_back({"a", found.model.a});
  if (u != nullptr) report.parameters.push_back({"b", found.model.b});
  report.parameters.push_back({"c", found.model.c});
  report.facts.emplace_back("x", join(found.state, ", "));
  const bool is_at_zero =
      std::ranges::all_of(found.values, [](double x) { return std::abs(x) < 1e-6; });
  if (!is_at_zero)
    report.facts.emplace_back("model", "of deviations from the operating point, which is not 0");
  report.numbers["state"] = found.state;
  report.losing = found.losing;
  report.smoothing = found.smoothing;
  return true;
}

int perform_kalman(const KalmanOptions& options) {
  DesignRun run(options);
  if (!run.begin({"KalmanFilter", "Observer"})) return run.refuse();
  const Input* const u = run.input("u");
  if (!run.open_at(u != nullptr ? std::optional(run.channel(*u)) : std::nullopt) ||
      !run.build(options.model))
    return run.refuse();
  DesignReport report = run.report("steady-state Kalman filter");
  KalmanValues values(run, options);
  std::string problem, help;
  if (!find_model(run, options, values.request, report, problem, help))
    return run.refuse(problem, help);
  if (!values.read()) return run.refuse();
  const KalmanDesign design = design_kalman(values.request);
  if (!design.problem.empty()) return run.refuse(design.problem, design.help);
  if (report.type == "KalmanFilter") {
    report.parameters.push_back({"q", design.q});
    report.parameters.push_back({"r", design.r});
  } else {
    report.parameters.push_back({"gain", design.gain});
  }
  std::vector<std::string> deviations;
  for (const double each : design.deviations) deviations.push_back(fmt::format("{:.4g}", each));
  report.facts.emplace_back("errors",
                            join(deviations, ", ") + " (standard deviation of each state)");
  report.facts.emplace_back("decay", fmt::format("{:.6g} a tick (spectral radius of the errors)",
                                                 design.spectral_radius));
  Json errors = Json::list();
  for (const double each : design.deviations) errors.push_back(each);
  report.numbers["errors"] = std::move(errors);
  report.numbers["decay"] = design.spectral_radius;
  if (!run.verify(report)) return run.refuse();
  return run.end(report);
}

Command kalman_table(KalmanOptions& options) {
  return {
      .name = "kalman",
      .about =
          "compute the covariances of a KalmanFilter or the gain of an Observer from the noise of "
          "system and sensors",
      .examples = {{"with the model and the sensor noise of the graph",
                    "eagerx-gen design kalman robot.yaml --of estimate --model --process "
                    "estimate.u=0.5"}},
      .arguments = joined(
          {{graph(options),
            texts("--process", options.process,
                  "standard deviation of the noise at each tick, of a state (`x[1]`, or its name) "
                  "or of the input u",
                  "NAME=VALUE"),
            texts(
                "--measurement", options.measurement,
                "standard deviation of the noise of each element of the measurement (default: that "
                "of the graph's SensorModel)",
                "PORT=VALUE"),
            flag("--model", options.model,
                 "also compute the model a, b and c from the graph (default: that of the node)")},
           design_arguments(options, "a KalmanFilter or an Observer")}),
      .run = [&options] { return perform_kalman(options); }};
}

}  // namespace

Command design_kalman_command() {
  return experimental(with_options<KalmanOptions>(kalman_table));
}

}  // namespace eagerx::gen
