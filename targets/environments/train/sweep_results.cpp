#include "targets/environments/train/sweep_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <runtime/host/base/cells.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/number.hpp>
#include <utility>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

constexpr std::string_view kResultColumns =
    "training,settings,seed,succeeds,steps,successes,episodes,return,processor_s,problem";
constexpr std::size_t kCells = 10;

/// In quotes, one line: a message may have several, and quotes.
std::string quoted(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  std::ranges::replace(text, '"', '\'');
  return '"' + text + '"';
}

std::string line_of(const SweepRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", row.training, quoted(row.settings),
                     row.seed, row.succeeds ? 1 : 0, row.steps, row.successes, row.episodes,
                     row.mean_return, row.processor_s, quoted(row.problem));
}

bool read_quoted(std::string_view cell, std::string& text) {
  const bool is_right = cell.size() >= 2 && cell.starts_with('"') && cell.ends_with('"');
  if (is_right) text = cell.substr(1, cell.size() - 2);
  return is_right && text.find('"') == std::string::npos;
}

bool read_hash(std::string_view cell, std::string& text) {
  text = cell;
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return cell.size() == 16 && std::ranges::all_of(cell, is_digit);
}

bool read_row(std::string_view line, SweepRow& row) {
  const std::vector<std::string_view> cell = host::cells_of(line);
  const auto whole = [](std::string_view text, std::uint64_t& value) {
    return host::read_number(text, std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(),
                             value);
  };
  const auto real = [](std::string_view text, double& value) {
    constexpr double kMost = std::numeric_limits<double>::max();
    return host::read_number(text, -kMost, kMost, value);
  };
  std::uint64_t succeeds = 0;
  const bool is_read = cell.size() == kCells && read_hash(cell[0], row.training) &&
                       read_quoted(cell[1], row.settings) && whole(cell[2], row.seed) &&
                       whole(cell[3], succeeds) && whole(cell[4], row.steps) &&
                       whole(cell[5], row.successes) && whole(cell[6], row.episodes) &&
                       real(cell[7], row.mean_return) && real(cell[8], row.processor_s) &&
                       read_quoted(cell[9], row.problem);
  row.succeeds = succeeds == 1;
  return is_read && succeeds <= 1 && row.successes <= row.episodes && row.processor_s >= 0.0 &&
         (row.episodes > 0) == row.problem.empty();
}

}  // namespace

SweepResults::SweepResults(std::string path) : path_(std::move(path)) {
  rows_ = read();
}

/// Nothing of a file that is empty, and of what is no file: that cannot be read again.
std::vector<SweepRow> SweepResults::read() const {
  std::error_code ignored;
  std::vector<SweepRow> rows;
  if (!std::filesystem::exists(path_, ignored) || !host::is_replaced_by_output(path_)) return rows;
  const std::string text = read_file(path_);
  if (text.empty()) return rows;
  const auto refuse = [&](const std::string& what) {
    throw Problem(kInputOutput, fmt::format("`{}` {}", path_, what),
                  "give a new file, or one that a sweep has written");
  };
  if (!text.starts_with(std::string(kResultColumns) + "\n")) refuse("has no results of a sweep");
  std::size_t number = 1;
  for (std::size_t at = kResultColumns.size() + 1; at < text.size();) {
    ++number;
    const std::size_t end = text.find('\n', at);
    SweepRow row;
    if (end == std::string::npos || !read_row(std::string_view(text).substr(at, end - at), row))
      refuse(fmt::format("is damaged: line {} is not a result", number));
    rows.push_back(std::move(row));
    at = end + 1;
  }
  return rows;
}

const SweepRow* SweepResults::find(std::string_view training) const {
  const auto found = std::ranges::find(rows_, training, &SweepRow::training);
  return found == rows_.end() ? nullptr : &*found;
}

std::string SweepResults::add(SweepRow row) {
  rows_.push_back(std::move(row));
  try {
    write();
  } catch (const Problem& problem) {
    return problem.what();
  }
  return {};
}

void SweepResults::add_from_file() {
  std::vector<SweepRow> all = read();
  for (SweepRow& row : rows_) {
    if (std::ranges::find(all, row.training, &SweepRow::training) == all.end())
      all.push_back(std::move(row));
  }
  rows_ = std::move(all);
}

void SweepResults::write() {
  const host::FileLock lock(path_);
  if (lock.error() != 0)
    throw Problem(kInputOutput, fmt::format("cannot write `{}`: {}", path_,
                                            host::problem_of_writing(lock.error())));
  add_from_file();
  std::string text = std::string(kResultColumns) + "\n";
  for (const SweepRow& row : rows_) text += line_of(row);
  write_file(path_, text);
}

}  // namespace eagerx::train
