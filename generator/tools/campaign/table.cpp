#include "generator/tools/campaign/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <runtime/host/base/cells.hpp>
#include <runtime/host/base/number.hpp>
#include <string_view>

namespace eagerx::gen::campaign {
namespace {

constexpr std::string_view kFirst = "run,return,steps,success,terminated,truncated";
constexpr std::size_t kReturn = 1, kSuccess = 3, kFixed = 6;  // columns
constexpr std::size_t kMostNumbers = 100'000'000;

class CampaignReader {
 public:
  explicit CampaignReader(const std::string& path) : path_(path), file_(path) {
    table_.name = std::filesystem::path(path).stem().string();
  }

  std::optional<CampaignTable> read(std::string& problem) {
    if (read_header() && read_rows()) {
      std::erase_if(table_.sampled, [](const CampaignColumn& column) { return !differs(column); });
      return std::move(table_);
    }
    problem = problem_;
    return std::nullopt;
  }

 private:
  bool fail(const std::string& what) {
    problem_ = fmt::format("error: `{}`, line {}: {}", path_, line_, what);
    return false;
  }

  bool next(std::string& line) {
    if (!std::getline(file_, line)) return false;
    if (line.ends_with('\r')) line.pop_back();
    ++line_;
    return true;
  }

  bool read_header() {
    std::string line;
    if (!file_ || !next(line)) {
      problem_ = fmt::format("error: cannot read `{}`", path_);
      return false;
    }
    if (line.starts_with("episode,step,"))
      return fail(
          "this is the table of a run\nhelp: plot channels of the log that the run writes "
          "with `--trace`");
    if (line != kFirst && !line.starts_with(std::string(kFirst) + ","))
      return fail("this is not a table of `eagerx-gen campaign --csv`");
    const auto names = host::cells_of(line);
    for (std::size_t i = kFixed; i < names.size(); ++i) {
      const std::string_view name = names[i].substr(names[i].find(':') + 1);
      table_.sampled.push_back({std::string(name), {}});
    }
    return true;
  }

  bool read_rows() {
    std::string line;
    while (next(line)) {
      if (!read_row(host::cells_of(line))) return false;
    }
    return !table_.returns.empty() || fail("there are no runs");
  }

  bool read_row(const std::vector<std::string_view>& cells) {
    const std::size_t columns = kFixed + table_.sampled.size();
    if (cells.size() != columns)
      return fail(fmt::format("it has {} cells, and the first line has {}", cells.size(), columns));
    if ((table_.returns.size() + 1) * columns > kMostNumbers)
      return fail("there are more numbers than may be");
    if (cells[0] != std::to_string(table_.returns.size()))
      return fail(fmt::format("run {} is expected here", table_.returns.size()));
    double value = 0.0;
    if (!host::read_number(cells[kReturn], value)) return fail("`return` is not a number");
    table_.returns.push_back(value);
    if (cells[kSuccess] != "0" && cells[kSuccess] != "1") return fail("`success` is 0 or 1");
    table_.successes.push_back(cells[kSuccess] == "1");
    for (std::size_t i = 0; i < table_.sampled.size(); ++i) {
      value = std::numeric_limits<double>::quiet_NaN();
      if (!cells[kFixed + i].empty() && !host::read_number(cells[kFixed + i], value))
        return fail(fmt::format("`{}` is not a number", table_.sampled[i].name));
      table_.sampled[i].values.push_back(value);
    }
    return true;
  }

  static bool differs(const CampaignColumn& column) {
    return std::ranges::any_of(column.values, [&](double value) {
      return std::isfinite(value) && value != column.values.front();
    });
  }

  const std::string& path_;
  std::ifstream file_;
  std::size_t line_ = 0;
  std::string problem_;
  CampaignTable table_;
};

}  // namespace

std::optional<CampaignTable> read_campaign(const std::string& path, std::string& problem) {
  return CampaignReader(path).read(problem);
}

}  // namespace eagerx::gen::campaign
