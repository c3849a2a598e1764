#include "targets/environments/train/presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <runtime/host/base/nearest.hpp>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/client/words.hpp"
#include "targets/environments/options/train_presets.hpp"

namespace eagerx::train {
namespace {

using options::kTrainPresets;
using options::Preset;

std::string_view name_of(std::string_view word) {
  return word.substr(0, word.find('='));
}

const Preset& preset_of(const std::string& name) {
  const auto* preset = std::ranges::find(kTrainPresets, name, &Preset::name);
  if (preset != std::end(kTrainPresets)) return *preset;
  std::vector<std::string> known;
  for (const Preset& each : kTrainPresets) known.emplace_back(each.name);
  throw Problem(client::kUsage, fmt::format("there is no preset `{}`", name),
                host::suggestion(name, known));
}

}  // namespace

void apply_preset(Options& options) {
  if (options.preset.empty()) return;
  const Preset& preset = preset_of(options.preset);
  if (options.algorithm_given && options.settings.algorithm != preset.algorithm)
    throw Problem(client::kUsage,
                  fmt::format("the preset `{}` is for {}, and the algorithm is {}", preset.name,
                              preset.algorithm, options.settings.algorithm),
                  "leave out `--algorithm`, or `--preset`");
  options.settings.algorithm = preset.algorithm;
  std::vector<std::string> words;
  for (const std::string_view word : client::pieces_of(preset.values, ' ')) {
    if (std::ranges::find(options.given, name_of(word), name_of) != options.given.end()) continue;
    set(options.settings, name_of(word), std::string(word.substr(name_of(word).size() + 1)));
    words.emplace_back(word);
  }
  options.given.insert(options.given.begin(), words.begin(), words.end());
}

std::string preset_advice(const Options& options, const client::Description& description,
                          const std::vector<CurvePoint>& curve) {
  if (!options.preset.empty() || options.settings.algorithm != "ppo") return {};
  if (!description.chooses() && description.action_numbers() >= options::kLocomotionActions)
    return fmt::format(
        "an action has {} numbers: `--preset locomotion` was measured on a robot with 12",
        description.action_numbers());
  const auto succeeds = [](const CurvePoint& point) {
    return point.success > 0.0 || point.evaluation_success > 0.0;
  };
  if (description.has_success && std::ranges::none_of(curve, succeeds))
    return "no episode reached the goal: `--preset rare_goal` was measured on a task whose goal "
           "few episodes reach";
  return {};
}

}  // namespace eagerx::train
