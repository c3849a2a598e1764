// The contents of `task:` as written.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// How connections and channels call the task.
inline constexpr const char* kTask = "task";

/// A name in the task's expressions for a sensor, an output of a node or an action.
struct TaskInputSpec {
  Spanned<std::string> name, from;
  std::optional<ProcessorSpec> processor;
};

/// A part of the reward: `weight` times the number `value`.
struct TermSpec {
  Spanned<std::string> name;
  YamlValue value;
  double weight = 1.0;
};

/// Something that is true or false after every step.
struct TaskConditionSpec {
  Spanned<std::string> name;
  YamlValue that;
};

/// Noise on an observation: numbers for each element, or one for all.
struct NoiseSpec {
  Spanned<std::string> observation;
  YamlValue numbers;
  bool is_range = false;  // half the width of even noise; else standard deviations
};

/// How a stage samples a state, instead of as the graph does.
struct StageStateSpec {
  Spanned<std::string> state;  // "pendulum.model_state"
  RandomSpec random;
};

/// A part of a training, before the graph as written.
struct StageSpec {
  Spanned<std::string> name;
  std::vector<StageStateSpec> states;
  std::vector<std::pair<Spanned<std::string>, double>> weights;  // of terms
  std::optional<double> success, mean_return;                    // that end it
  bool is_as_written = false;                                    // says nothing of the two
  Span until;
};

struct TaskSpec {
  Span span;
  std::vector<TaskInputSpec> inputs;
  std::vector<TermSpec> reward;
  std::vector<TaskConditionSpec> terminated, truncated, success;
  std::vector<NoiseSpec> noise;
  std::vector<StageSpec> stages;
  std::vector<Spanned<std::string>> critic;      // `critic: […]`, inputs of the task and states
  std::optional<Spanned<Rational>> after_s;      // `truncated: {after: …}`
  std::optional<Spanned<Rational>> over_last_s;  // `success: {over_last: …}`
};

/// Of a tree that `check` has accepted, without its span. Problems: E0204 a task without a term,
/// E0206 `over_last` without a condition, a name that `critic` or `stages` has twice.
TaskSpec read_task_spec(const YamlValue& yaml, Diagnostics& diagnostics);

/// `stages:` of a task. Problems: E0202 an empty `until`, E0204 an invalid share, E0206 a duplicate
/// name.
FormatPtr stages_format();
std::vector<StageSpec> read_stages(const YamlValue* yaml, Diagnostics& diagnostics);

}  // namespace eagerx::gen
