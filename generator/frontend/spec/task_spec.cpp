#include "generator/frontend/spec/task_spec.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

TaskInputSpec read_input(const YamlValue::Entry& entry) {
  TaskInputSpec spec;
  spec.name = {entry.key, entry.key_span};
  const YamlValue& from = entry.value.is_scalar() ? entry.value : *entry.value.find("from");
  spec.from = {from.text, from.span};
  if (const YamlValue* processor = entry.value.find("processor"))
    spec.processor = read_processor(*processor);
  return spec;
}

TermSpec read_term(const YamlValue::Entry& entry) {
  TermSpec spec;
  spec.name = {entry.key, entry.key_span};
  spec.value = entry.value.is_scalar() ? entry.value : *entry.value.find("value");
  if (const YamlValue* weight = entry.value.find("weight"))
    spec.weight = real_of(*weight).value_or(1.0);
  return spec;
}

/// All conditions under a key; `time_key` among them is no condition, but a time.
std::vector<TaskConditionSpec> read_conditions(const YamlValue* yaml, std::string_view time_key,
                                               std::optional<Spanned<Rational>>& time_s) {
  std::vector<TaskConditionSpec> specs;
  if (yaml == nullptr) return specs;
  for (const auto& entry : yaml->entries) {
    if (entry.key == time_key) {
      time_s = {exact_of(entry.value).value_or(Rational{}), entry.value.span};
    } else {
      specs.push_back({{entry.key, entry.key_span}, entry.value});
    }
  }
  return specs;
}

/// Names that are given once.
std::vector<Spanned<std::string>> read_critic(const YamlValue* yaml, Diagnostics& diagnostics) {
  std::vector<Spanned<std::string>> names;
  if (yaml == nullptr) return names;
  for (const YamlValue& item : yaml->items) {
    const auto earlier = ranges::find(names, item.text, &Spanned<std::string>::value);
    if (earlier == names.end()) {
      names.push_back({item.text, item.span});
    } else {
      diagnostics.error("E0206", item.span, fmt::format("`{}` is listed twice", item.text))
          .notes.push_back({"first here", earlier->span, ""});
    }
  }
  return names;
}

NoiseSpec read_noise(const YamlValue::Entry& entry) {
  const YamlValue* range = entry.value.find("range");
  return {{entry.key, entry.key_span}, range != nullptr ? *range : entry.value, range != nullptr};
}

FormatPtr noise_format() {
  const auto numbers = [](const char* what) {
    return format::one_of(what, {format::list(what, format::number("a number, at least 0"), 1),
                                 format::number("a number, at least 0")});
  };
  return format::one_of(
      "a standard deviation, a list of one for each element, or `{range: …}`",
      {format::record("a range", {{"range", numbers("a number, or one for each element"), true,
                                   "bound of uniform noise, from -range to range"}}),
       format::list("standard deviations", format::number("a number, at least 0"), 1),
       format::number("a standard deviation, at least 0")});
}

FormatPtr condition_format() {
  return format::text("a condition such as `abs(theta) < 0.1`");
}

}  // namespace

FormatPtr task_format() {
  const FormatPtr port = format::port("a port such as `pendulum.theta` or `actions.voltage`");
  const FormatPtr input = format::one_of(
      "a port, or a mapping with `from` and `processor`",
      {format::record("an input of the task",
                      {{"from", port, true, "a sensor, an output of a node or an action"},
                       {"processor", processor_format(), false, "converts every message"}}),
       port});
  const FormatPtr value = format::text("an expression such as `theta^2`");
  const FormatPtr term = format::one_of(
      "an expression, or a mapping with its `value` and `weight`",
      {format::record(
           "a term of the reward",
           {{"value", value, true, "the expression, a number after every step"},
            {"weight", format::number("a number"), false, "factor of the value (default 1)"}}),
       value});
  const FormatPtr condition = condition_format();
  return format::record(
      "the task",
      {{"inputs", format::map("inputs of the task", input), false,
        "names of sensors, outputs of nodes and actions in expressions"},
       {"reward", format::map("terms of the reward", term), true,
        "terms of the reward, summed after every step in the order of the file"},
       {"terminated", format::map("conditions", condition), false,
        "an episode ends with success or failure when one of these holds"},
       {"truncated",
        format::open_record("`truncated`",
                            {{"after", format::time("a time in seconds", true), false,
                              "seconds after which an episode is cut off"}},
                            condition),
        false, "an episode is cut off after this time, or when one of these conditions holds"},
       {"success",
        format::open_record(
            "`success`",
            {{"over_last", format::time("a time in seconds", true), false,
              "seconds for which all conditions must hold without a gap (default: one step)"}},
            condition),
        false, "conditions that together are success; success does not end an episode"},
       {"noise", format::map("observations", noise_format()), false,
        "noise of observations in simulation: its standard deviation, or `{range: …}`"},
       {"critic",
        format::list("a list of inputs of the task and states",
                     format::text("an input of the task, or a state such as `pendulum.mass`")),
        false, "additional inputs of the critic of a training"},
       {"stages", stages_format(), false,
        "curriculum: stages of a training, in order, before the graph as it is written"}});
}

TaskSpec read_task_spec(const YamlValue& yaml, Diagnostics& diagnostics) {
  TaskSpec spec;
  if (const YamlValue* inputs = yaml.find("inputs")) {
    for (const auto& entry : inputs->entries) spec.inputs.push_back(read_input(entry));
  }
  const YamlValue& reward = *yaml.find("reward");
  for (const auto& entry : reward.entries) spec.reward.push_back(read_term(entry));
  if (spec.reward.empty())
    diagnostics.error("E0204", reward.span, "expected terms of the reward, found none").help =
        "write at least one, such as `upright: cos(theta)`";
  std::optional<Spanned<Rational>> none;
  spec.terminated = read_conditions(yaml.find("terminated"), {}, none);
  spec.truncated = read_conditions(yaml.find("truncated"), "after", spec.after_s);
  spec.success = read_conditions(yaml.find("success"), "over_last", spec.over_last_s);
  if (const YamlValue* noise = yaml.find("noise")) {
    for (const auto& entry : noise->entries) spec.noise.push_back(read_noise(entry));
  }
  spec.critic = read_critic(yaml.find("critic"), diagnostics);
  spec.stages = read_stages(yaml.find("stages"), diagnostics);
  if (spec.over_last_s && spec.success.empty())
    diagnostics.error("E0206", spec.over_last_s->span, "`over_last` goes with a condition").help =
        "write what must hold for so long, such as `upright: abs(theta) < 0.1`";
  return spec;
}

}  // namespace eagerx::gen
