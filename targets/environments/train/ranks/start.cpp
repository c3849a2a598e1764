#include "targets/environments/train/ranks/start.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "targets/environments/train/ranks/together.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

void check_shared(const Options& options, std::uint32_t ranks) {
  if (options.settings.algorithm != "ppo")
    throw Problem(kUsage,
                  fmt::format("{} ranks share PPO's trainings only: SAC learns from few steps at a "
                              "time, and the ranks would wait for each other",
                              ranks),
                  "leave `mpirun` or `--algorithm sac` out");
  if (options.seeds > 1)
    throw Problem(kUsage, "several ranks share one training, and `--seeds` are several",
                  "give each its `--seed`");
  if (!options.cases.empty())
    throw Problem(kUsage, "several ranks share one training, and a sweep has many",
                  "leave `mpirun` out: a sweep runs on all cores of this machine");
  if (ranks > kParts)
    throw Problem(
        kUsage, fmt::format("a training has {} parts, which {} ranks cannot share", kParts, ranks),
        fmt::format("`mpirun -n {}`, and more threads for each", kParts));
}

std::string content_of(const std::string& path) {
  return path.empty() ? std::string() : read_file(path);
}

std::string received(Ranks& ranks) {
  const std::string bytes = ranks.share({});
  return bytes.empty() ? std::string() : environments::file_of(bytes);
}

}  // namespace

void give(Ranks& ranks, int argc, const char* const* argv, const Options& options) {
  if (ranks.size() == 1) return;
  check_shared(options, ranks.size());
  ranks.share(environments::words_of(argc, argv));
  for (const std::string* path :
       {&options.library, &options.resume, &options.from, &options.failure_replay})
    ranks.share(content_of(*path));
}

void give_nothing(Ranks& ranks) {
  ranks.share({});
}

Options take_job(Ranks& ranks) {
  const std::string words = ranks.share({});
  if (words.empty()) return {};
  const auto argv = environments::command_line("eagerx-train", words);
  Options options = parse_options(static_cast<int>(argv.size()), argv.data());
  options.library = received(ranks);
  options.resume = received(ranks);
  options.from = received(ranks);
  options.failure_replay = received(ranks);
  options.csv.clear();
  options.record.clear();
  options.tensorboard.clear();
  options.is_quiet = true;
  return options;
}

int train_together(Ranks& ranks, const Options& options, const Interrupt& is_interrupted) {
  std::optional<Library> library;
  std::optional<Training> training;
  const auto begin = [&] {
    library.emplace(options.library);
    training.emplace(options, *library, ProgressReport::SharedTable{}, ranks);
  };
  together(
      ranks,
      [&] {
        try {
          begin();
        } catch (const Problem& problem) {  // another machine than that of rank 0
          if (ranks.is_first()) throw;
          throw Problem(problem.code, fmt::format("rank {}: {}", ranks.rank(), problem.what()),
                        problem.help);
        }
      },
      [] { return std::string(); });
  return training->run(is_interrupted);
}

}  // namespace eagerx::train
