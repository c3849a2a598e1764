#include "generator/graph/resolve/safe_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/number.hpp"
#include "generator/graph/resolve/bounds.hpp"

namespace eagerx::gen {
namespace {

class SafeOutputReader {
 public:
  SafeOutputReader(const Input& input, std::size_t index, const SafeOutputSpec& spec,
                   const Rational& rate_hz, Diagnostics& diagnostics)
      : input_(input), spec_(spec), rate_hz_(rate_hz), diagnostics_(diagnostics) {
    result_.input = index;
    result_.space = input.space;
    result_.span = spec.span;
  }

  /// nullopt if there was a problem.
  std::optional<SafeOutput> read() {
    if (input_.window != 1) {
      fail(fmt::format("`{}` has `window: {}`, and an output is one message", input_.written,
                       input_.window))
          .help = "leave `window` out, or write `" + input_.name +
                  ": none` if nothing acts on this observation";
      return std::nullopt;
    }
    read_limits();
    read_value();
    read_times();
    return good_ ? std::optional(result_) : std::nullopt;
  }

 private:
  Diagnostic& fail(std::string message) {
    good_ = false;
    return diagnostics_.error("E0348", spec_.span, std::move(message));
  }

  void read_limits() {
    const auto bound = [&](const std::optional<YamlValue>& yaml, std::vector<double>& into) {
      if (!yaml) return;
      const auto values = safe_value(input_.written, input_.space, *yaml, diagnostics_);
      good_ = good_ && values.has_value();
      if (values) into = *values;
    };
    bound(spec_.low, result_.space.low);
    bound(spec_.high, result_.space.high);
    if (!good_) return;
    const Space& space = result_.space;
    for (std::size_t i = 0; i < space.size(); ++i) {
      if (bound_of(space.low, i, lowest_of(space.dtype)) <=
          bound_of(space.high, i, highest_of(space.dtype)))
        continue;
      fail(fmt::format("`low` of `{}` is above its `high`", input_.written));
      return;
    }
  }

  void read_value() {
    if (!good_) return;
    result_.value = zero_in(result_.space);
    if (!spec_.value) return;
    const auto value = safe_value(input_.written, result_.space, *spec_.value, diagnostics_);
    good_ = good_ && value.has_value();
    if (value) result_.value = *value;
  }

  void read_times() {
    result_.holds_always = spec_.holds_always;
    if (spec_.hold_s) result_.hold_s = spec_.hold_s->value;
    if (!spec_.ramp_per_s) return;
    const double ramp = *spec_.ramp_per_s;
    if (!is_floating(input_.space.dtype)) {
      fail(fmt::format("`{}` is {}, which cannot change little by little", input_.written,
                       input_.space.describe()))
          .help = "leave `ramp` out";
    } else if (!(ramp > 0.0 && ramp / rate_hz_.to_double() > 0.0)) {
      fail(fmt::format("the `ramp` of `{}` must be above 0", input_.written)).help =
          "without `ramp` the safe value leaves at once";
    }
    result_.ramp_per_s = ramp;
  }

  const Input& input_;
  const SafeOutputSpec& spec_;
  const Rational& rate_hz_;
  Diagnostics& diagnostics_;
  SafeOutput result_;
  bool good_ = true;
};

/// `none`: what helps where no known name is near.
void report_unknown(const std::string& name, Span span, const char* what,
                    const std::vector<std::string>& known, const Help& none,
                    Diagnostics& diagnostics) {
  if (contains(known, name)) return;
  diagnostics.error("E0307", span, fmt::format("there is no {} `{}`", what, name)).help =
      did_you_mean(name, known, none);
}

void report_unknown(const GraphNode& environment, const SafetySpec& written, bool has_engine,
                    Diagnostics& diagnostics) {
  const auto none = [&](const std::string& name, const std::vector<std::string>& known,
                        const char* otherwise) -> Help {
    if (!has_engine) return suggestion(name, known, otherwise);
    return "nothing acts on outputs of a simulation: if this is for a library of some of its "
           "nodes, name them with `--of NODE`, and their ports are known";
  };
  const auto outputs = names_of(environment.inputs), actions = names_of(environment.outputs);
  for (const auto& output : written.outputs)
    report_unknown(output.name.value, output.name.span, "observation", outputs,
                   none(output.name.value, outputs, "the graph has no observations"), diagnostics);
  for (const Setting& setting : written.frozen)
    report_unknown(setting.name, setting.span, "action", actions,
                   none(setting.name, actions, "the graph has no actions"), diagnostics);
}

}  // namespace

void read_safe_outputs(const GraphNode& environment, const SafetySpec* written, Safety& safety,
                       Diagnostics& diagnostics) {
  if (written != nullptr) report_unknown(environment, *written, false, diagnostics);
  if (environment.outputs.empty() || (written != nullptr && written->no_outputs)) return;
  for (const auto& action : environment.outputs) {
    const Setting* const setting =
        written != nullptr ? find_named(written->frozen, action.name) : nullptr;
    safety.frozen.push_back(
        setting == nullptr ? 0U : static_cast<std::uint32_t>(whole_of(setting->value).value_or(0)));
  }
  for (std::size_t i = 0; i < environment.inputs.size(); ++i) {
    const Input& input = environment.inputs[i];
    const SafeOutputSpec* spec =
        written != nullptr ? find_named(written->outputs, input.name) : nullptr;
    if (spec != nullptr && spec->is_free) continue;
    SafeOutputSpec zero;
    if (spec == nullptr) {
      safety.undeclared.push_back(i);
      if (input.window != 1) continue;
      zero.span = input.span;
      spec = &zero;
    }
    if (auto output = SafeOutputReader(input, i, *spec, environment.rate_hz, diagnostics).read())
      safety.outputs.push_back(std::move(*output));
  }
}

void resolve_safe_outputs(UnresolvedGraph& draft) {
  const SafetySpec* const written = draft.spec.safety ? &*draft.spec.safety : nullptr;
  const GraphNode& environment = draft.graph.environment();
  // Observations that a policy of the program answers, or that one learns from, do not leave,
  // unless somebody says so.
  const bool is_answered = draft.spec.agent.kind == AgentSpec::Kind::policy || draft.spec.task;
  const bool stay = is_answered && (written == nullptr || written->outputs.empty());
  if (!draft.spec.has_engine() && !stay) {
    read_safe_outputs(environment, written, draft.graph.safety, draft.diagnostics);
  } else if (written != nullptr) {
    report_unknown(environment, *written, draft.spec.has_engine(), draft.diagnostics);
  }
}

}  // namespace eagerx::gen
