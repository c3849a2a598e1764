#include "targets/environments/train/sac/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/number.hpp>
#include <vector>

#include "targets/environments/train/policy.hpp"

namespace eagerx::train::sac {
namespace {

constexpr const char* kOwnTable = "give what `--csv` of a program of this graph wrote";

[[noreturn]] void refuse_log(const std::string& name, std::size_t line, const std::string& what) {
  throw Problem(kInputOutput, fmt::format("`{}`, line {}: {}", name, line, what), kOwnTable);
}

/// The line that `text` begins with, which is removed. False if it has no end.
bool take_line(std::string_view& text, std::string_view& line) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return false;
  line = text.substr(0, end);
  if (line.ends_with('\r')) line.remove_suffix(1);
  text.remove_prefix(end + 1);
  return true;
}

void split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = end + 1;
  }
}

/// Where the table has what.
struct Columns {
  std::size_t count = 0;
  std::size_t episode = 0, step = 0, reward = 0, terminated = 0, truncated = 0;
  std::vector<std::size_t> observation, action;

  Columns(std::string_view header, const std::string& name, const Description& description) {
    std::vector<std::string_view> names;
    split(header, names);
    count = names.size();
    const auto one = [&](std::string_view wanted) {
      const auto found = std::ranges::find(names, wanted);
      if (found == names.end()) refuse_log(name, 1, fmt::format("there is no column `{}`", wanted));
      return static_cast<std::size_t>(found - names.begin());
    };
    episode = one("episode");
    step = one("step");
    reward = one("task.reward");
    terminated = one("task.terminated");
    truncated = one("task.truncated");
    for (const Space& space : description.observations) add(observation, names, name, space);
    for (const Space& space : description.actions) add(action, names, name, space);
  }

 private:
  static void add(std::vector<std::size_t>& to, const std::vector<std::string_view>& names,
                  const std::string& name, const Space& space) {
    const std::size_t before = to.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].substr(0, names[i].find('[')) == space.name) to.push_back(i);
    }
    if (to.size() - before != space.size)
      refuse_log(name, 1,
                 fmt::format("there {} {} of `{}`, not {}", to.size() - before == 1 ? "is" : "are",
                             host::counted(to.size() - before, "column"), space.name, space.size));
  }
};

/// Rows of a table, one after the other.
class Table {
 public:
  Table(std::string_view text, const std::string& name, const Description& description)
      : name_(name), head_(description), text_(text), columns_(header(), name, description) {}

  std::vector<float> observation, action;
  std::uint64_t episode = 0, step = 0;
  float reward = 0.0F;
  bool terminated = false, truncated = false;

  bool next() {
    std::string_view line;
    if (!take_line(text_, line)) return false;
    ++line_;
    split(line, cells_);
    if (cells_.size() != columns_.count)
      refuse_log(name_, line_, fmt::format("{} cells, not {}", cells_.size(), columns_.count));
    episode = whole(columns_.episode);
    step = whole(columns_.step);
    reward = number(columns_.reward);
    terminated = number(columns_.terminated) == 1.0F;
    truncated = number(columns_.truncated) == 1.0F;
    observation.clear();
    for (const std::size_t column : columns_.observation) observation.push_back(number(column));
    action.clear();
    for (std::size_t j = 0; j < columns_.action.size(); ++j) {
      const float range = head_.high[j] - head_.low[j];
      const float x = 2.0F * (number(columns_.action[j]) - head_.low[j]) / range - 1.0F;
      action.push_back(std::isnan(x) ? x : std::clamp(x, -1.0F, 1.0F));
    }
    return true;
  }
  bool is_finite() const {
    const auto finite = [](float x) { return std::isfinite(x); };
    return finite(reward) && std::ranges::all_of(action, finite) &&
           std::ranges::all_of(observation, finite);
  }

 private:
  std::string_view header() {
    std::string_view line;
    if (!take_line(text_, line)) refuse_log(name_, 1, "there is no header");
    return line;
  }
  std::uint64_t whole(std::size_t column) const {
    std::uint64_t value = 0;
    if (!host::read_number(cells_[column], value))
      refuse_log(name_, line_, fmt::format("`{}` is not a whole number", cells_[column]));
    return value;
  }
  /// NaN of an empty cell.
  float number(std::size_t column) const {
    float value = std::numeric_limits<float>::quiet_NaN();
    if (!cells_[column].empty() && !host::read_number(cells_[column], value))
      refuse_log(name_, line_, fmt::format("`{}` is not a number", cells_[column]));
    return value;
  }

  const std::string& name_;
  const Head head_;
  std::string_view text_;
  const Columns columns_;
  std::vector<std::string_view> cells_;
  std::size_t line_ = 1;
};

void add_row(Sums& sums, const std::vector<float>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) sums.add(i, row[i]);
  sums.count += 1.0;
}

}  // namespace

Log read_log(std::string_view text, const std::string& name, const Description& description,
             float discount, Memory& memory, Sums& observations, Sums& returns, Sums& rewards) {
  Table table(text, name, description);
  Log log;
  std::vector<float> before;  // empty: there is none
  std::uint64_t episode = 0, step = 0;
  float discounted = 0.0F;
  while (table.next()) {
    const bool follows = table.episode == episode && table.step == step + 1 && table.step > 0;
    const bool begins = table.step == 0;
    episode = table.episode;
    step = table.step;
    if (begins) discounted = 0.0F;
    const bool is_whole = !begins && follows && !before.empty() && table.is_finite();
    if (is_whole) {
      memory.add({before.data(), table.observation.data(), table.action.data(), table.reward,
                  table.terminated ? 0.0F : 1.0F});
      discounted = discounted * discount + table.reward;
      add_row(returns, {discounted});
      add_row(rewards, {table.reward, table.terminated ? 0.0F : 1.0F});
      ++log.transitions;
    } else if (!begins) {
      ++log.left_out;
    }
    before = table.observation;
    if (!std::ranges::all_of(before, [](float x) { return std::isfinite(x); })) before.clear();
    if (!before.empty()) add_row(observations, before);
  }
  return log;
}

}  // namespace eagerx::train::sac
