// `stages:` of a task: the first phases of a training.
#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

FormatPtr distributions_format() {
  Format states = *format::map("states", distribution_format());
  states.key = format::port("a state such as `pendulum.model_state`");
  states.file_names = true;  // what a key may be, `key` says
  return std::make_shared<const Format>(std::move(states));
}

std::optional<double> number_at(const YamlValue& yaml, std::string_view key) {
  const YamlValue* value = yaml.find(key);
  return value != nullptr ? real_of(*value) : std::nullopt;
}

void read_until(const YamlValue& yaml, StageSpec& stage, Diagnostics& diagnostics) {
  stage.until = yaml.span;
  stage.success = number_at(yaml, "success");
  stage.mean_return = number_at(yaml, "return");
  if (!stage.success && !stage.mean_return)
    diagnostics.error("E0202", yaml.span, "`until` is empty").help =
        "write when the next stage begins, such as `{success: 0.9}` or `{return: 100}`";
  if (stage.success && !(*stage.success > 0.0 && *stage.success <= 1.0))
    diagnostics
        .error("E0204", yaml.find("success")->span,
               "expected a share of the episodes, above 0 and at most 1")
        .help = "0.9 means nine of ten episodes";
}

StageSpec read_stage(const YamlValue& yaml, Diagnostics& diagnostics) {
  StageSpec stage;
  const YamlValue& name = *yaml.find("name");
  stage.name = {name.text, name.span};
  stage.is_as_written = true;
  if (const YamlValue* states = yaml.find("states")) {
    stage.is_as_written = states->entries.empty();
    for (const auto& entry : states->entries) {
      const std::optional<RandomSpec> random = read_random(entry.value, diagnostics);
      if (random) stage.states.push_back({{entry.key, entry.key_span}, *random});
    }
  }
  if (const YamlValue* weights = yaml.find("weights")) {
    stage.is_as_written = stage.is_as_written && weights->entries.empty();
    for (const auto& entry : weights->entries) {
      stage.weights.emplace_back(Spanned<std::string>{entry.key, entry.key_span},
                                 real_of(entry.value).value_or(0.0));
    }
  }
  read_until(*yaml.find("until"), stage, diagnostics);
  return stage;
}

}  // namespace

FormatPtr stages_format() {
  return format::list(
      "a list of stages",
      format::record(
          "a stage",
          {{"name", format::name("a name"), true, "name in progress messages and tables"},
           {"states", distributions_format(), false,
            "distributions of states in this stage: `{pendulum.model_state: {uniform: …}}`"},
           {"weights", format::map("terms of the reward", format::number("a number")), false,
            "weights of terms that replace the graph's"},
           {"until",
            format::record("`until`", {{"success", format::number("a share"), false,
                                        "share of the episodes that succeed, 0 to 1"},
                                       {"return", format::number("a number"), false,
                                        "mean return of the episodes"}}),
            true, "what the policy without noise must reach before the next stage begins"}}),
      1);
}

std::vector<StageSpec> read_stages(const YamlValue* yaml, Diagnostics& diagnostics) {
  std::vector<StageSpec> stages;
  if (yaml == nullptr) return stages;
  for (const YamlValue& item : yaml->items) {
    StageSpec stage = read_stage(item, diagnostics);
    const auto earlier = ranges::find_if(
        stages, [&](const StageSpec& each) { return each.name.value == stage.name.value; });
    if (earlier != stages.end()) {
      diagnostics
          .error("E0206", stage.name.span,
                 fmt::format("two stages are called `{}`", stage.name.value))
          .notes.push_back({"first here", earlier->name.span, ""});
      continue;
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace eagerx::gen
