// Settings by their table: every row has a place, a default within its range, and comes back.
#include "targets/environments/train/settings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <runtime/host/base/renamed.hpp>
#include <string>

#include "targets/environments/options/train_settings.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {
namespace {

using options::kTrainSettings;
using options::Setting;
using options::SettingKind;

/// The message when `text` is its value; "" if there is none.
std::string said(const std::string& name, const std::string& text) {
  Settings settings;
  try {
    set(settings, name, text);
  } catch (const Problem& problem) {
    return problem.what();
  }
  return {};
}

/// Another value that a setting may have.
std::string other_value(const Setting& row) {
  switch (row.kind) {
    case SettingKind::layers:
      return "3,5";
    case SettingKind::word:
      return std::string(row.words).substr(std::string(row.words).rfind(',') + 1);
    case SettingKind::truth:
      return std::string(row.otherwise) == "true" ? "false" : "true";
    case SettingKind::whole:
      return fmt::format("{}", static_cast<std::size_t>(row.high));
    case SettingKind::number:
      return fmt::format("{}", static_cast<float>((row.low + row.high) / 4.0));
  }
  return {};
}

TEST(TrainSettings, EachIsSetAndStandsInTheText) {
  const std::string before = text_of(Settings());
  for (const Setting& row : kTrainSettings) {
    Settings settings;
    const std::string value = other_value(row);
    set(settings, row.name, value);
    EXPECT_EQ(difference(before, text_of(settings)),
              fmt::format("{} {} (here {})", row.name, row.otherwise, value));
  }
}

TEST(TrainSettings, NamesOfOtherLibrariesGetOurs) {
  const auto help = [](const std::string& name) {
    Settings settings;
    try {
      set(settings, name, "1");
    } catch (const client::Problem& problem) {
      return problem.help;
    }
    return std::string();
  };
  const std::string all = "; `eagerx-gen help train-settings` lists them";
  EXPECT_EQ(help("lr"), "it is `learning_rate` here" + all);
  EXPECT_EQ(help("lam"), "it is `gae_lambda` here" + all);
  EXPECT_EQ(help("num_envs"), "it is `n_envs` here" + all);
  EXPECT_EQ(help("clip_coef"), "it is `clip_range` here" + all);
  EXPECT_EQ(help("learning_rat"),
            "did you mean `learning_rate`? `eagerx-gen help train-settings` lists them");
  EXPECT_EQ(help("xyzzy"), "`eagerx-gen help train-settings` lists them");
}

TEST(TrainSettings, OutOfRangeIsRefused) {
  for (const Setting& row : kTrainSettings) {
    if (row.kind == SettingKind::word || row.kind == SettingKind::truth) {
      EXPECT_NE(said(row.name, "neither"), "") << row.name;
      continue;
    }
    for (const double wrong : {row.low - 1.0, row.high * 2.0 + 1.0, std::nan("")})
      EXPECT_NE(said(row.name, fmt::format("{}", wrong)), "") << row.name << ' ' << wrong;
  }
  EXPECT_EQ(said("clop", "1"), "there is no setting `clop`");
  EXPECT_EQ(said("net_arch", "1,1,1,1,1,1,1,1,1"), "there are at most 8 layers");
  EXPECT_EQ(said("activation_fn", "elu"), "`elu` is none of tanh, relu");
}

TEST(TrainSettings, AFormerNameIsRefusedWithTheNewOne) {
  const auto is_setting = [](std::string_view name) {
    return std::ranges::find(kTrainSettings, name, &Setting::name) != std::end(kTrainSettings);
  };
  for (const host::Renamed& one : host::kRenamed) {
    if (one.where != host::kTrainSettings || one.new_name == "failure-replay") continue;
    EXPECT_TRUE(is_setting(one.new_name)) << one.new_name;
    EXPECT_FALSE(is_setting(one.old_name)) << one.old_name;
    Settings settings;
    try {
      set(settings, one.old_name, "1");
      ADD_FAILURE() << one.old_name;
    } catch (const Problem& problem) {
      EXPECT_EQ(problem.what(), fmt::format("there is no setting `{}`", one.old_name));
      EXPECT_EQ(problem.help,
                fmt::format("write `{}`, the new name of `{}`", one.new_name, one.old_name));
    }
  }
}

TEST(TrainSettings, WhatDoesNotGoTogetherIsRefused) {
  const auto checked = [](const char* name, const char* text) -> std::string {
    Settings settings;
    set(settings, name, text);
    try {
      check(settings);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return {};
  };
  EXPECT_EQ(checked("clip_range", "0.3"), "");
  EXPECT_EQ(checked("n_envs", "200"), "n_envs: 200 is neither 8, 16, 32, 64 nor a multiple of 128");
  EXPECT_EQ(checked("n_envs", "24"), "n_envs: 24 is neither 8, 16, 32, 64 nor a multiple of 128");
  EXPECT_EQ(checked("rnn", "gru"), "");
  EXPECT_EQ(checked("bptt_steps", "5"), "") << "without a memory";
  EXPECT_EQ(checked("min_std", "5"), "min_std is more than max_std");
  EXPECT_EQ(checked("min_learning_rate", "0.1"),
            "min_learning_rate is more than max_learning_rate");
}

TEST(TrainSettings, SequencesOfAMemoryFitIntoTheHorizon) {
  const auto checked = [](const char* steps, std::size_t environments) -> std::string {
    Settings settings;
    set(settings, "rnn", "lstm");
    set(settings, "bptt_steps", steps);
    settings.n_envs = environments;
    try {
      check(settings);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return {};
  };
  EXPECT_EQ(checked("8", 64), "");
  EXPECT_EQ(checked("16", 64), "");
  EXPECT_EQ(checked("32", 128), "");
  EXPECT_EQ(checked("32", 64),
            "n_steps: 32 of 64 environments are 2048 steps, no multiple of 128 * bptt_steps");
  EXPECT_EQ(checked("5", 128), "n_steps: 32 is not a multiple of bptt_steps, 5");
}

TEST(TrainSettings, OnTheCommandLine) {
  const auto parse = [](std::vector<const char*> words) -> std::string {
    words.insert(words.begin(), {"eagerx-train", "lib.so"});
    try {
      return text_of(parse_options(static_cast<int>(words.size()), words.data()).settings);
    } catch (const Problem& problem) {
      return problem.what();
    }
  };
  Settings expected;
  expected.net_arch = {8, 16};
  expected.clip_range = 0.3F;
  EXPECT_EQ(parse({"--setting", "clip_range=0.3", "--setting=net_arch=8,16"}), text_of(expected));
  EXPECT_EQ(parse({"--setting", "clip_range"}), "--setting: `clip_range` is not NAME=VALUE");
  EXPECT_EQ(parse({"--setting", "clip_range=0.3", "--algorithm", "sac"}),
            "clip_range is a setting of ppo, and the algorithm is sac");
  EXPECT_EQ(parse({"--setting", "batch_size=256"}),
            "batch_size is a setting of sac, and the algorithm is ppo");
  EXPECT_EQ(parse({"--algorithm", "sac", "--setting", "batch_size=200"}),
            "batch_size: 200 is not a multiple of 128");
  EXPECT_EQ(parse({"--setting", "clip_range=x"}),
            "--setting: clip_range: `x` is not a number from 0.001 to 10");
}

}  // namespace
}  // namespace eagerx::train
