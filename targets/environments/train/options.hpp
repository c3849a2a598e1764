// The command line of eagerx-train.
#pragma once

#include <string>
#include <vector>

#include "targets/environments/client/problem.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

using client::Problem;

/// One of the settings of a sweep.
struct Case {
  std::string words;  // "learning_rate=0.001 layers=64,64"
  Settings settings;
};

struct Options {
  std::string library;
  std::string output = "policy.safetensors";
  std::string checkpoint, resume, from, csv, curve, record, tensorboard;  // empty: none
  std::string failure_replay;         // the table of a campaign; empty: none
  std::string results = "sweep.csv";  // of a sweep
  std::string preset;                 // empty: none
  bool algorithm_given = false;       // by --algorithm
  std::string name;                   // of one of several trainings: "seed 3"
  std::string kernels;                // empty: the fastest
  std::uint64_t steps = 5'000'000;    // of all environments, at most
  std::uint64_t seeds = 1;            // trainings, from settings.seed on
  unsigned threads = 0;               // 0: one for each core
  double checkpoint_every_s = 60.0;   // at least
  bool is_quiet = false;
  bool wants_help = false;
  bool only_checks = false;         // options and the places of files; there is no library yet
  std::vector<std::string> replay;  // tables of runs
  std::vector<std::string> given;   // settings in words, the last of a name counts: "clip=0.3"
  std::vector<Case> cases;          // of a sweep; empty: it is none
  Settings settings;
};

/// Throws Problem with kUsage.
Options parse_options(int argc, const char* const* argv);

/// Adds to a problem the words of its settings, for eagerx-gen, which knows their places in a file;
/// none unless requested (--check). `words`: those of a case.
Problem in_words_of(Problem problem, const Options& options, const std::string& words = {});

/// The text of --help.
std::string help_text();

}  // namespace eagerx::train
