// eagerx-gen train: generates and builds the library of environments, and starts eagerx-train
// (targets/environments/train), which learns and does not depend on graphs.
#include "targets/environments/options/train.hpp"

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/environments.hpp"
#include "generator/driver/commands/ranks.hpp"
#include "generator/driver/commands/setting_places.hpp"
#include "generator/driver/commands/train_settings.hpp"
#include "generator/driver/commands/train_sweep.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

namespace {

struct TrainOptions : EnvironmentsOptions {
  std::string settings, sweep;  // files
};

/// Words of both files; nullopt and errors where they are wrong.
std::optional<std::vector<std::string>> read_settings(const TrainOptions& options, Run& run,
                                                      SettingPlaces& places) {
  std::vector<std::string> words;
  if (!options.settings.empty()) {
    const auto read = read_train_settings(options.settings, run.sources, run.diagnostics, places);
    if (!read) return std::nullopt;
    words = *read;
  }
  if (!options.sweep.empty()) {
    const auto read = read_train_sweep(options.sweep, run.sources, run.diagnostics, places);
    if (!read) return std::nullopt;
    words.insert(words.end(), read->begin(), read->end());
  }
  return words;
}

int perform(const TrainOptions& options) {
  GenerateOptions training = options;
  training.purpose = Purpose::training;
  Run run;
  SettingPlaces places;
  const auto words = [&](std::vector<std::string>& all) {
    const auto read = read_settings(options, run, places);
    if (!read) return finish(run, options);
    all = *read;
    all.insert(all.end(), options.of_program.begin(), options.of_program.end());
    return int{kDone};
  };
  const auto explain = [&](const ProcessResult& checked) {
    const bool is_io = checked.exit_code == kInputOutput;
    return places.report(checked.output, is_io, run.diagnostics) ? finish(run, options)
                                                                 : int{kDone};
  };
  return exec_in_ranks("eagerx-train", training, words, explain);
}

Command table(TrainOptions& options) {
  return {
      .name = "train",
      .about = "train a policy on a graph, with the reward of its `task:`",
      .examples =
          {{"train until the policy succeeds, and write policy.safetensors",
            "eagerx-gen train pendulum.yaml"},
           {"use another seed, and draw the learning curve",
            "eagerx-gen train pendulum.yaml --seed 2 --curve curve.svg -o swing_up.safetensors"},
           {"record the training for a page in a browser (`eagerx-gen report --training`)",
            "eagerx-gen train pendulum.yaml --record training.json"},
           {"write checkpoints during a long training",
            "eagerx-gen train robot.yaml --steps 50000000 --checkpoint robot.checkpoint"},
           {"continue from the checkpoint",
            "eagerx-gen train robot.yaml --steps 50000000 --resume robot.checkpoint"},
           {"compare settings in a table, and write the best policy",
            "eagerx-gen train robot.yaml --sweep sweep.yaml --csv settings.csv"},
           {"fine-tune a trained policy on another graph",
            "eagerx-gen train real_robot.yaml --from robot.checkpoint -o real.safetensors"},
           {"train one policy with four processes (eagerx-gen built with MPI)",
            "mpirun -n 4 eagerx-gen train robot.yaml"}},
      .arguments = joined(
          {{graph(options),
            reads(text("--settings", options.settings,
                       "settings of the algorithm, which `eagerx-gen help train-settings` lists",
                       "FILE.yaml")),
            reads(text("--sweep", options.sweep,
                       "train with each combination of the lists and ranges in this file, in "
                       "parallel, and print a table of the results",
                       "FILE.yaml"))},
           handed_on(eagerx::options::kTrain, options),
           on_environments(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command train_command() {
  return with_options<TrainOptions>(table);
}

}  // namespace eagerx::gen
