#include "targets/environments/train/seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "targets/environments/train/export.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

struct Trained {
  std::uint64_t seed = 0;
  int exit_code = 0;
  std::vector<CurvePoint> curve;
  Evaluation evaluation;

  Score score() const { return {evaluation.successes, evaluation.mean_return}; }
};

Options options_of(const Options& options, std::uint64_t seed) {
  Options one = options;
  one.settings.seed = seed;
  one.output = path_of_seed(options.output, seed);
  one.curve.clear();
  if (!one.tensorboard.empty()) one.tensorboard += fmt::format("/seed{}", seed);
  return one;
}

/// 95 % of the mean, by Student's distribution, of few; of many 1.96 deviations.
double half_interval(const std::vector<double>& values) {
  constexpr double kStudent[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26};
  const auto count = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const std::size_t free = values.size() - 1;
  const double factor = free <= std::size(kStudent) ? kStudent[free - 1] : 1.96;
  return factor * std::sqrt(squares / (count - 1.0) / count);
}

std::string table_of(const std::vector<Trained>& all, bool has_success) {
  std::string text = fmt::format("{:>8} {:>12} {:>10} {:>12}\n", "seed", "steps",
                                 has_success ? "success" : "", "return");
  std::vector<double> returns;
  for (const Trained& one : all) {
    const double steps = one.curve.empty() ? 0.0 : one.curve.back().steps;
    const std::string success =
        has_success ? fmt::format("{} of {}", one.evaluation.successes, one.evaluation.episodes)
                    : std::string();
    text += fmt::format("{:>8} {:>12} {:>10} {:>12.4g}\n", one.seed, rounded(steps), success,
                        one.evaluation.mean_return);
    returns.push_back(one.evaluation.mean_return);
  }
  if (all.size() < 2) return text;
  double mean = 0.0;
  for (const double value : returns) mean += value / static_cast<double>(returns.size());
  const auto good = std::ranges::count(all, kDone, &Trained::exit_code);
  return text + fmt::format("{} of {} seeds {}; return {:.4g} +- {:.2g} (95 % of the mean)\n", good,
                            all.size(), has_success ? "succeed" : "are done", mean,
                            half_interval(returns));
}

void write_all(const Options& options, const Library& library, const std::vector<Trained>& all) {
  std::vector<std::vector<CurvePoint>> curves;
  curves.reserve(all.size());
  for (const Trained& one : all) curves.push_back(one.curve);
  if (!options.curve.empty())
    write_file(options.curve, curves_svg(curves, library.description().graph));
  const Trained& best = *std::ranges::max_element(
      all, [](const Trained& a, const Trained& b) { return b.score().is_better_than(a.score()); });
  const std::string path = path_of_seed(options.output, best.seed);
  write_files({{options.output, read_file(path)},
               {golden_path(options.output), read_file(golden_path(path))}});
  print(fmt::format("written: {}, the policy of seed {}\n", options.output, best.seed));
}

}  // namespace

std::string path_of_seed(const std::string& path, std::uint64_t seed) {
  constexpr std::string_view kEnd = ".safetensors";
  const bool has_end = path.ends_with(kEnd);
  return fmt::format("{}.seed{}{}", path.substr(0, path.size() - (has_end ? kEnd.size() : 0)), seed,
                     has_end ? kEnd : "");
}

int train_seeds(const Options& options, const Library& library, const Interrupt& is_interrupted) {
  std::vector<Trained> all;
  // The first one says itself that it was interrupted: there is always one to write.
  for (std::uint64_t i = 0; i < options.seeds && (i == 0 || !is_interrupted); ++i) {
    const Options one = options_of(options, options.settings.seed + i);
    if (!options.is_quiet) print(fmt::format("seed {}\n", one.settings.seed));
    const auto table = [&](const std::vector<CurvePoint>& curve) {
      std::vector<std::vector<CurvePoint>> curves;
      curves.reserve(all.size() + 1);
      for (const Trained& each : all) curves.push_back(each.curve);
      curves.push_back(curve);
      return curves_csv(curves, options.settings.seed);
    };
    Training training(one, library, table);
    const int code = training.run(is_interrupted);
    all.push_back({one.settings.seed, code, training.curve(), training.evaluation()});
  }
  write_all(options, library, all);
  if (!options.is_quiet) print(table_of(all, library.description().has_success));
  return std::ranges::max(all, {}, &Trained::exit_code).exit_code;
}

}  // namespace eagerx::train
