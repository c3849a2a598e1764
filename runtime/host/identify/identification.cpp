#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/identify/identification.hpp>

namespace eagerx::identification {
namespace {

constexpr double kDeviations = 3.0;  // to each side of a value, in the YAML
constexpr double kFollows = 0.1;     // of a sensor's largest value: more left over is no fit

std::string number(double value) {
  char text[32];
  const auto digits = std::snprintf(text, sizeof text, "%.7g", value);
  return {text, static_cast<std::size_t>(digits)};
}

/// "[1, 2]", or "1" for a scalar.
std::string list(const std::vector<double>& values, bool is_scalar) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return is_scalar ? text : "[" + text + "]";
}

/// The graph's names of the owner of a state and of the state: "robot/body.mass" is the state
/// `body.mass` of `robot`.
std::string owner_of(const std::string& name) {
  return name.substr(0, name.find_first_of("./"));
}
std::string state_of(const std::string& name) {
  std::string state = name.substr(std::min(name.find_first_of("./"), name.size() - 1) + 1);
  std::replace(state.begin(), state.end(), '/', '.');
  return state;
}

/// "pendulum/u/action_applied" → "pendulum.u"
std::string port(std::string_view channel) {
  std::string name(channel.substr(0, channel.rfind('/')));
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

/// Elements of one state, one after the other.
template <class F>
void for_each_state(const std::vector<Parameter>& parameters, F&& f) {
  for (std::size_t i = 0; i < parameters.size(); i += parameters[i].size)
    f(std::span(parameters).subspan(i, parameters[i].size));
}

}  // namespace

/// Marks the parameters that change what the sensors report in a run whose states begin at `state`.
/// False if that run is not finite.
bool Identification::mark_parameters(double state) {
  Trial tried = full_;
  std::ranges::fill(tried.states, state);
  const std::vector<double> middle = run_(tried);
  if (!std::ranges::all_of(middle, [](double x) { return std::isfinite(x); })) return false;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    Parameter& parameter = parameters_[i];
    if (parameter.matters || !(parameter.high > parameter.low)) continue;
    Trial other = tried;
    other.parameters[i] += (parameter.high - parameter.low) / 4;
    parameter.matters = run_(other) != middle;
  }
  return true;
}

/// Those of the parameters that change what the sensors report. From rest, an equation without
/// input stays there whatever its parameters are, so those that seem to change nothing are tried
/// from another state.
bool Identification::choose_parameters(std::string& problem) {
  const auto is_open = [](const Parameter& each) { return each.high > each.low && !each.matters; };
  bool is_finite = mark_parameters(0.0);
  if (std::ranges::any_of(parameters_, is_open)) is_finite = mark_parameters(1.0) || is_finite;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    // The solver reports a simulation that is never finite.
    if (!is_finite && is_open(parameters_[i])) parameters_[i].matters = true;
    if (parameters_[i].matters) chosen_.push_back(i);
  }
  if (chosen_.empty() && experiment_.actuators().empty()) {
    problem =
        "error: there is nothing to identify\nhelp: let the graph sample a state of an object from "
        "a range, as in `states: {model_parameters: {uniform: {low: […], high: […]}}}`";
    return false;
  }
  return true;
}

const std::vector<double>& Identification::run_chosen(const Trial& trial) {
  for (std::size_t p = 0; p < chosen_.size(); ++p)
    full_.parameters[chosen_[p]] = trial.parameters[p];
  full_.states = trial.states;
  for (std::size_t a = 0; a < full_.delays.size(); ++a)
    full_.delays[a] = trial.parameters[chosen_.size() + a];
  return run_(full_);
}

bool Identification::find(double tick_s, double longest_delay_s, std::string& problem) {
  if (experiment_.objects().empty()) {
    problem = "error: no object of this program is simulated by differential equations";
    return false;
  }
  for (const Parameter& parameter : parameters_)
    full_.parameters.push_back((parameter.low + parameter.high) / 2);
  full_.states.assign(experiment_.segments() * experiment_.states(), 0.0);
  full_.delays.assign(experiment_.actuators().size(), 0);
  if (!choose_parameters(problem)) return false;

  std::vector<Range> ranges;
  Trial trial = full_;
  trial.parameters.clear();
  for (const std::size_t i : chosen_) {
    ranges.push_back({parameters_[i].low, parameters_[i].high});
    trial.parameters.push_back(full_.parameters[i]);
  }
  // A delay is one more parameter, in ticks; between two of them the input is their mean.
  const double most = std::max(longest_delay_s / tick_s, 1e-3);
  for (std::size_t a = 0; a < experiment_.actuators().size(); ++a) {
    ranges.push_back({0.0, most});
    trial.parameters.push_back(0.0);
  }
  LeastSquares solver(
      experiment_, ranges,
      experiment_.actuators().size(), [this](const Trial& tried) -> const auto& {
        return run_chosen(tried);
      });
  bool numbers = solver.fit(trial);
  for (std::size_t a = 0; a < experiment_.actuators().size() && numbers; ++a)
    numbers = find_delay(a, most, solver, trial);
  if (!numbers || !solver.refine(trial)) {
    problem = "error: the simulation is not finite\nhelp: narrow the ranges of the graph";
    return false;
  }
  const std::vector<double> deviations = solver.deviations(trial);
  for (std::size_t p = 0; p < chosen_.size(); ++p) {
    parameters_[chosen_[p]].value = trial.parameters[p];
    parameters_[chosen_[p]].deviation = deviations[p];
  }
  constexpr double kRounding = std::numeric_limits<float>::epsilon();  // of a part of a tick
  for (std::size_t a = 0; a < experiment_.actuators().size(); ++a) {
    const std::size_t p = chosen_.size() + a;
    delays_.push_back({experiment_.actuators()[a], trial.parameters[p] * tick_s,
                       std::max(deviations[p], kRounding) * tick_s});
  }
  leftover_ = solver.leftover();
  for (std::size_t g = 0; g < leftover_.size(); ++g) counts_.push_back(solver.counts(g));
  return true;
}

/// Goes down from several delays, for there is more than one minimum. The best one stays, but noise
/// alone is no reason for a longer delay.
bool Identification::find_delay(std::size_t actuator, double most, LeastSquares& solver,
                                Trial& trial) const {
  constexpr int kStarts = 4;
  double least = solver.deviance();
  const Trial first = trial;
  for (int i = 1; i <= kStarts; ++i) {
    Trial tried = first;
    tried.parameters[chosen_.size() + actuator] = most * i / (kStarts + 1);
    if (!solver.fit(tried)) return false;
    constexpr double kNoise = 9.0;  // three standard deviations
    if (solver.deviance() >= least - kNoise) continue;
    least = solver.deviance();
    trial = tried;
  }
  return true;
}

std::string Identification::report(const trace_log::Log& log,
                                   std::span<const Channel> channels) const {
  std::string text = "log " + log.path + ": graph " + log.graph + " on " + log.engine + ", " +
                     host::counted(log.episodes(), "episode") + ", " +
                     host::counted(experiment_.segments(), "segment") + "\n";
  const std::vector<double> scale = experiment_.group_scale();
  if (!log.complete) text += "the log ends early, in line " + std::to_string(log.lines) + "\n";
  for (std::size_t g = 0; g < leftover_.size(); ++g) {
    const Experiment::Group& group = experiment_.groups()[g];
    if (!counts_[g]) continue;
    text += std::string("sensor ") + channels[group.channel].name + "[" +
            std::to_string(group.element) + "]: " + number(leftover_[g]) + " left over";
    if (leftover_[g] > kFollows * scale[g])
      text += ", so the simulation does not follow it: do not rely on the values below";
    text += "\n";
  }
  for (const Parameter& parameter : parameters_) {
    if (!(parameter.high > parameter.low)) continue;
    text += "parameter " + parameter.state +
            (parameter.is_scalar ? "" : "[" + std::to_string(parameter.element) + "]") + ": ";
    const double half = (parameter.high - parameter.low) / 2;
    if (!parameter.matters) {
      text += "the sensors above do not depend on it\n";
      continue;
    }
    text += number(parameter.value) + " +- " + number(parameter.deviation);
    if (parameter.deviation > half / 2) text += ", the log says little of it";
    if (parameter.value <= parameter.low || parameter.value >= parameter.high)
      text += ", at the end of its range";
    text += "\n";
  }
  for (const Delay& delay : delays_)
    text += std::string("delay ") + port(channels[delay.channel].name) + ": " +
            number(delay.value_s) + " +- " + number(delay.deviation_s) + " s\n";
  return text;
}

std::string Identification::yaml(const trace_log::Log& log,
                                 std::span<const Channel> channels) const {
  std::string text = "# From " + log.path + " by `eagerx-gen identify`: values +- " +
                     number(kDeviations) + " standard deviations.\n";
  std::string owner;
  for_each_state(parameters_, [&](std::span<const Parameter> elements) {
    const Parameter& first = elements.front();
    if (std::none_of(elements.begin(), elements.end(), [](const auto& e) { return e.matters; }))
      return;
    std::vector<double> low, high;
    for (const Parameter& element : elements) {
      const double margin = kDeviations * element.deviation;
      low.push_back(element.matters ? std::max(element.value - margin, element.low) : element.low);
      high.push_back(element.matters ? std::min(element.value + margin, element.high)
                                     : element.high);
    }
    if (owner.empty()) text += "objects:\n";
    if (owner != owner_of(first.state)) text += "  " + owner_of(first.state) + ":\n    states:\n";
    owner = owner_of(first.state);
    text += "      " + state_of(first.state) + ": {space: {low: " + list(low, first.is_scalar) +
            ", high: " + list(high, first.is_scalar) + "}, uniform: space}\n";
  });
  bool begun = false;
  for (const Delay& delay : delays_) {
    const std::string to = port(channels[delay.channel].name);
    const double margin = kDeviations * delay.deviation_s;
    const std::string range =
        "delay: {uniform: {low: " + number(std::max(delay.value_s - margin, 0.0)) +
        ", high: " + number(delay.value_s + margin) + "}}";
    // A graph has no connections to what is inside of its objects.
    if (std::count(to.begin(), to.end(), '.') > 1) {
      text += "# On the connection to `" + to.substr(to.find('.') + 1) + "` in the manifest of `" +
              to.substr(0, to.find('.')) + "`: " + range + "\n";
      continue;
    }
    text += std::string(begun ? "" : "connections:\n") + "  - {to: " + to + ", " + range + "}\n";
    begun = true;
  }
  return text;
}

}  // namespace eagerx::identification
