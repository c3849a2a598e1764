#include "generator/tools/training/training.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/text.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/files.hpp"
#include "generator/tools/training/lines.hpp"
#include "generator/tools/training/record.hpp"
#include "generator/tools/training/tables.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostTextBytes = 200'000'000;

bool is_worse(const TrainingEpisode& a, const TrainingEpisode& b) {
  return a.success != b.success ? b.success : a.sum < b.sum;
}

/// [return, 1 or 0 for success], the lowest return first.
Json returns_of(std::vector<TrainingEpisode> episodes) {
  std::ranges::stable_sort(episodes, {}, &TrainingEpisode::sum);
  Json list = Json::list();
  for (const TrainingEpisode& each : episodes) {
    Json pair = Json::list();
    pair.push_back(each.sum);
    pair.push_back(each.success ? 1 : 0);
    list.push_back(std::move(pair));
  }
  return list;
}

/// Which of the three it is, says the first line.
std::optional<TrainingRecord> read(FileId file, const std::string& text, const SourceMap& sources,
                                   Diagnostics& diagnostics) {
  TrainingLines lines(file, text, sources, diagnostics);
  if (text.starts_with('{')) return read_record(lines);
  const auto header = lines.next();
  if (header && *header == kSweepHeader) return read_sweep(lines);
  if (header) {
    const auto names = cells_of(*header);
    if (ranges::contains(names, "steps") && ranges::contains(names, "return"))
      return read_curves(*header, lines);
  }
  lines.fail("nothing that a training has written begins so");
  return std::nullopt;
}

}  // namespace

std::optional<TrainingRecord> read_training(const std::string& path, SourceMap& sources,
                                            Diagnostics& diagnostics) {
  remember_input(path);
  LoadedFile loaded = load_file(path, kMostTextBytes);
  if (loaded.status != LoadedFile::Status::loaded) {
    diagnostics
        .io_error("E0363", {},
                  loaded.status == LoadedFile::Status::too_large
                      ? fmt::format("`{}` is too large: more than {} MB", path,
                                    kMostTextBytes / 1'000'000)
                      : fmt::format("cannot read `{}`: {}", path, loaded.reason))
        .help = "give what `eagerx-gen train` wrote with `--record` or `--csv`";
    return std::nullopt;
  }
  return read_training_text(path, std::move(loaded.bytes), sources, diagnostics);
}

std::optional<TrainingRecord> read_training_text(const std::string& path, std::string bytes,
                                                 SourceMap& sources, Diagnostics& diagnostics) {
  const std::string text = normalize_text(std::move(bytes));
  const FileId file = sources.add(path, text);
  if (!check_text(text, file, diagnostics)) return std::nullopt;
  auto record = read(file, text, sources, diagnostics);
  if (!record) return std::nullopt;
  record->page["name"] = path;
  if (!record->episodes.empty()) record->page["returns"] = returns_of(record->episodes);
  return record;
}

BestAndWorst best_and_worst(const std::vector<TrainingEpisode>& episodes) {
  return {*std::ranges::max_element(episodes, is_worse),
          *std::ranges::min_element(episodes, is_worse)};
}

}  // namespace eagerx::gen
