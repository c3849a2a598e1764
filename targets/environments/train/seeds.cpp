#include "targets/environments/train/seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <runtime/host/base/counted.hpp>
#include <vector>

#include "targets/environments/client/intervals.hpp"
#include "targets/environments/train/beside.hpp"
#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

struct Trained {
  std::uint64_t seed = 0;
  bool is_done = false;  // has written its policy
  int exit_code = 0;
  std::vector<CurvePoint> curve;
  Evaluation evaluation;

  Score score() const { return {evaluation.success(), evaluation.mean_return}; }
};

bool is_there(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// Those of one seed. One that had written no checkpoint before a kill begins.
Options options_of(const Options& options, std::uint64_t seed) {
  Options one = options;
  one.settings.seed = seed;
  one.name = fmt::format("seed {}", seed);
  one.output = path_of_seed(options.output, seed);
  one.curve.clear();
  if (!one.checkpoint.empty()) one.checkpoint = path_of_seed(options.checkpoint, seed);
  if (!one.resume.empty()) one.resume = path_of_seed(options.resume, seed);
  if (!is_there(one.resume)) one.resume.clear();
  if (!one.tensorboard.empty()) one.tensorboard += fmt::format("/seed{}", seed);
  return one;
}

std::string table_of(const std::vector<Trained>& all, bool has_success) {
  std::string text = fmt::format("{:>8} {:>12} {:>10} {:>12}\n", "seed", "steps",
                                 has_success ? "success" : "", "return");
  std::vector<double> returns;
  for (const Trained& one : all) {
    const std::string success =
        has_success ? fmt::format("{} of {}", one.evaluation.successes, one.evaluation.episodes)
                    : std::string();
    const double steps = one.curve.empty() ? 0.0 : one.curve.back().steps;
    text += fmt::format("{:>8} {:>12} {:>10} {:>12.4g}\n", one.seed, rounded(steps), success,
                        one.evaluation.mean_return);
    returns.push_back(one.evaluation.mean_return);
  }
  if (all.size() < 2) return text;
  const auto good = std::ranges::count(all, kDone, &Trained::exit_code);
  const client::Mean mean = client::mean_of(returns);
  return text + fmt::format("{} of {} seeds {}; return {} (95 % of the mean)\n", good, all.size(),
                            has_success ? "succeed" : "are done", client::text_of(mean));
}

class Seeds {
 public:
  Seeds(const Options& options, const Library& library)
      : options_(options),
        library_(library),
        beside_(beside(options, library, options.seeds)),
        all_(options.seeds),
        table_(options.csv),
        curves_(options.seeds),
        record_(options, library.description()) {}

  int run(const Interrupt& is_interrupted) {
    if (!options_.is_quiet && beside_.at_once > 1)
      fmt::print(stderr, "{} seeds at a time, with {} each\n", beside_.at_once,
                 host::counted(beside_.threads, "thread"));
    train_beside(options_.seeds, beside_.at_once, is_interrupted,
                 [&](std::size_t i, const Stop& stop) { train(i, stop); });
    std::erase_if(all_, [](const Trained& one) { return !one.is_done; });
    write();
    if (!options_.is_quiet) print(table_of(all_, library_.description().has_success));
    return std::ranges::max(all_, {}, &Trained::exit_code).exit_code;
  }

 private:
  void train(std::size_t i, const Stop& stop) {
    Options one = options_of(options_, options_.settings.seed + i);
    one.threads = beside_.threads;
    if (!options_.is_quiet && !options_.resume.empty() && one.resume.empty())
      fmt::print(stderr, "{} begins: it has no checkpoint\n", one.name);
    const auto table = [&](const std::vector<CurvePoint>& curve) {
      curves_[i] = curve;
      return curves_csv(curves_, options_.settings.seed);
    };
    Training training(one, library_, {&table_, table, &record_});
    const int code = training.run(stop);
    const std::lock_guard lock(mutex_);
    all_[i] = {one.settings.seed, true, code, training.curve(), training.evaluation()};
  }

  void write() const {
    std::vector<std::vector<CurvePoint>> curves;
    for (const Trained& one : all_) curves.push_back(one.curve);
    if (!options_.curve.empty())
      write_file(options_.curve, curves_svg(curves, library_.description().graph));
    const Trained& best = *std::ranges::max_element(all_, [](const Trained& a, const Trained& b) {
      return b.score().is_better_than(a.score());
    });
    const std::string path = path_of_seed(options_.output, best.seed);
    write_files({{options_.output, read_file(path)},
                 {golden_path(options_.output), read_file(golden_path(path))}});
    print(fmt::format("written: {}, the policy of seed {}\n", options_.output, best.seed));
  }

  const Options& options_;
  const Library& library_;
  const Beside beside_;
  std::mutex mutex_;                             // of
  std::vector<Trained> all_;                     // [seeds] that have ended
  CurveFile table_;                              // locks
  std::vector<std::vector<CurvePoint>> curves_;  // [seeds] as far as the table has them
  Record record_;                                // locks
};

}  // namespace

std::string path_of_seed(const std::string& path, std::uint64_t seed) {
  constexpr std::string_view kEnd = ".safetensors";
  const bool has_end = path.ends_with(kEnd);
  return fmt::format("{}.seed{}{}", path.substr(0, path.size() - (has_end ? kEnd.size() : 0)), seed,
                     has_end ? kEnd : "");
}

void check_files_of_seeds(const Options& options) {
  bool any = options.resume.empty();
  for (std::uint64_t i = 0; i < options.seeds; ++i) {
    const Options one = options_of(options, options.settings.seed + i);
    any = any || !one.resume.empty();
    if (!one.resume.empty()) check_resumed(read_file(one.resume), one.resume, one.settings);
    for (const std::string* path : {&one.output, &one.checkpoint}) {
      if (!path->empty()) claim_output(*path);
    }
  }
  if (!any) read_file(path_of_seed(options.resume, options.settings.seed));  // says why not
}

int train_seeds(const Options& options, const Library& library, const Interrupt& is_interrupted) {
  return Seeds(options, library).run(is_interrupted);
}

}  // namespace eagerx::train
