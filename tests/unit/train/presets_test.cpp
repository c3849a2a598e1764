// Named settings: what they set, what overrides them, and which one a training suggests.
#include "targets/environments/train/presets.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "targets/environments/client/words.hpp"
#include "targets/environments/options/train_presets.hpp"

namespace eagerx::train {
namespace {

using options::kTrainPresets;
using options::Preset;

Options parsed(std::vector<const char*> words) {
  words.insert(words.begin(), {"eagerx-train", "lib.so"});
  return parse_options(static_cast<int>(words.size()), words.data());
}

std::string refused(const std::vector<const char*>& words) {
  try {
    parsed(words);
  } catch (const Problem& problem) {
    return fmt::format("{}; {}", problem.what(), problem.help);
  }
  return "nothing";
}

TEST(TrainPresets, EachSetsItsValuesOnly) {
  for (const Preset& preset : kTrainPresets) {
    Settings expected;
    expected.algorithm = preset.algorithm;
    for (const std::string_view word : client::pieces_of(preset.values, ' ')) {
      const std::size_t equals = word.find('=');
      const std::string before = text_of(expected);
      set(expected, word.substr(0, equals), std::string(word.substr(equals + 1)));
      EXPECT_NE(text_of(expected), before) << word << " is the default";
      EXPECT_NO_THROW(check_algorithm(expected, word.substr(0, equals))) << word;
    }
    const Options options = parsed({"--preset", preset.name});
    EXPECT_EQ(text_of(options.settings), text_of(expected)) << preset.name;
    EXPECT_EQ(options.settings.algorithm, preset.algorithm);
  }
}

TEST(TrainPresets, SettingsOverrideThemInAnyOrder) {
  for (const auto& words :
       {std::vector<const char*>{"--preset", "locomotion", "--hidden", "32", "--setting",
                                 "n_epochs=3"},
        {"--setting", "n_epochs=3", "--hidden", "32", "--preset", "locomotion"}}) {
    const Settings settings = parsed(words).settings;
    EXPECT_EQ(settings.n_epochs, 3);
    EXPECT_EQ(settings.net_arch, std::vector<std::size_t>{32});
    EXPECT_EQ(settings.n_envs, 1024);
  }
}

TEST(TrainPresets, WrongOnes) {
  EXPECT_EQ(refused({"--preset", "locomotoin"}),
            "there is no preset `locomotoin`; did you mean `locomotion`?");
  EXPECT_EQ(refused({"--preset", "x"}),
            "there is no preset `x`; available: locomotion, rare_goal, reaching, swing_up");
  EXPECT_EQ(refused({"--preset", "locomotion", "--algorithm", "sac"}),
            "the preset `locomotion` is for ppo, and the algorithm is sac; leave out "
            "`--algorithm`, or `--preset`");
  EXPECT_EQ(refused({"--preset", "reaching", "--algorithm", "sac"}), "nothing");
}

TEST(TrainPresets, ReachingIsThatOfTheExample) {
  std::ifstream file(EAGERX_SOURCE_DIR "/examples/arm_reaching/sac.yaml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(text.empty());
  const Options preset = parsed({"--preset", "reaching"});
  Settings example;
  for (std::string_view line : client::pieces_of(text, '\n')) {
    line = line.substr(0, line.find(" #"));
    if (line.empty() || line.starts_with('#')) continue;
    std::string value(line.substr(line.find(": ") + 2));
    if (value.starts_with('[')) value = "256,256";
    set(example, line.substr(0, line.find(':')), value);
  }
  EXPECT_EQ(text_of(preset.settings), text_of(example));
}

TEST(TrainPresets, AreSuggestedForWhatTheyWereMeasuredOn) {
  client::Description robot, car;
  robot.has_success = car.has_success = true;
  robot.actions = {{"joints", "float32", 12, {}, {}}};
  car.actions = {{"force", "float32", 1, {}, {}}};
  const CurvePoint none{8192.0, -1.0, 0.0, -1.0, 0.0, 1.0, 1e-3, 0.01};
  CurvePoint some = none;
  some.success = 0.01;
  Options options;
  EXPECT_NE(preset_advice(options, robot, {none}).find("`--preset locomotion`"), std::string::npos);
  EXPECT_NE(preset_advice(options, car, {none}).find("`--preset rare_goal`"), std::string::npos);
  EXPECT_EQ(preset_advice(options, car, {none, some}), "");
  options.preset = "rare_goal";
  EXPECT_EQ(preset_advice(options, car, {none}), "") << "it is used already";
  options.preset.clear();
  options.settings.algorithm = "sac";
  EXPECT_EQ(preset_advice(options, robot, {none}), "");
}

}  // namespace
}  // namespace eagerx::train
