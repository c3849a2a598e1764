#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <runtime/host/base/number.hpp>
#include <utility>

#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/training/tables.hpp"

namespace eagerx::gen {

const std::string_view kSweepHeader =
    "training,settings,seed,succeeds,steps,successes,episodes,return,processor_s,problem";

namespace {

constexpr std::size_t kCells = 10;
constexpr std::size_t kMostRows = 100'000;
constexpr std::size_t kMostNames = 100;  // settings; there are fewer

/// A training of a sweep.
struct SweptTraining {
  std::vector<std::string> values;  // of each setting
  std::string problem;              // why it broke; then there are no numbers
  double succeeds = 0.0, steps = 0.0, successes = 0.0, episodes = 0.0;
  double mean_return = 0.0, processor_s = 0.0;
};

/// All trainings with the same settings.
struct Case {
  std::vector<std::string> values;
  std::vector<const SweptTraining*> rows;  // without those that broke
  std::vector<std::string> problems;

  [[nodiscard]] double sum(double SweptTraining::*which) const {
    double sum = 0.0;
    for (const SweptTraining* row : rows) sum += row->*which;
    return sum;
  }
  [[nodiscard]] double mean(double SweptTraining::*which) const {
    return rows.empty() ? 0.0 : sum(which) / static_cast<double>(rows.size());
  }
  [[nodiscard]] double share() const {
    const double episodes = sum(&SweptTraining::episodes);
    return episodes > 0.0 ? sum(&SweptTraining::successes) / episodes : 0.0;
  }
  /// As the table of the trainer has them.
  [[nodiscard]] bool is_better_than(const Case& other) const {
    if (rows.empty() != other.rows.empty()) return other.rows.empty();
    const double mine = sum(&SweptTraining::succeeds), theirs = other.sum(&SweptTraining::succeeds);
    if (mine != theirs) return mine > theirs;
    if (share() != other.share()) return share() > other.share();
    return mean(&SweptTraining::mean_return) > other.mean(&SweptTraining::mean_return);
  }
};

class SweepReader {
 public:
  explicit SweepReader(TrainingLines& lines) : lines_(lines) {}

  std::optional<TrainingRecord> read() {
    while (const auto line = lines_.next()) {
      if (!read_row(cells_of(*line))) return std::nullopt;
    }
    if (lines_.has_failed()) return std::nullopt;
    TrainingRecord record;
    record.page = Json{{"kind", "sweep"},
                       {"names", Json(names_)},
                       {"cases", cases_json()},
                       {"charts", charts_json()}};
    return record;
  }

 private:
  bool read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != kCells)
      return lines_.fail(
          fmt::format("it has {} instead of {}", counted(cells.size(), "cell"), kCells));
    if (rows_.size() >= kMostRows) return lines_.fail("there are more trainings than may be");
    SweptTraining row;
    if (!read_settings(cells[1], row)) return false;
    row.problem = std::string(cells[9]);
    const std::pair<std::size_t, double*> numbers[] = {
        {3, &row.succeeds}, {4, &row.steps},       {5, &row.successes},
        {6, &row.episodes}, {7, &row.mean_return}, {8, &row.processor_s}};
    for (const auto& [place, number] : numbers) {
      if (!host::read_number(cells[place], *number) || !std::isfinite(*number))
        return lines_.fail(fmt::format("`{}` is not a number", cells_of(kSweepHeader)[place]));
    }
    rows_.push_back(std::move(row));
    return true;
  }

  /// "learning_rate=0.001 layers=64,64": all rows of a file have the same names, or it is of
  /// several sweeps.
  bool read_settings(std::string_view text, SweptTraining& row) {
    std::vector<std::string> names;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(' '), text.size());
      const std::string_view word = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::size_t equals = word.find('=');
      if (equals == std::string_view::npos) return lines_.fail("`settings` are not NAME=VALUE");
      names.emplace_back(word.substr(0, equals));
      row.values.emplace_back(word.substr(equals + 1));
    }
    if (names.size() > kMostNames) return lines_.fail("there are more settings than may be");
    if (rows_.empty()) names_ = names;
    if (names != names_) return lines_.fail("it is of another sweep: it has other settings");
    return true;
  }

  [[nodiscard]] Json cases_json() const {
    std::vector<Case> cases;
    std::map<std::vector<std::string>, std::size_t> places;
    for (const SweptTraining& row : rows_) {
      const auto [place, is_new] = places.emplace(row.values, cases.size());
      if (is_new) cases.push_back(Case{row.values, {}, {}});
      Case& found = cases[place->second];
      if (row.problem.empty()) {
        found.rows.push_back(&row);
      } else {
        found.problems.push_back(row.problem);
      }
    }
    std::ranges::stable_sort(cases,
                             [](const Case& a, const Case& b) { return a.is_better_than(b); });
    Json list = Json::list();
    for (const Case& one : cases)
      list.push_back(
          Json{{"values", Json(one.values)},
               {"seeds", one.rows.size() + one.problems.size()},
               {"succeed", one.sum(&SweptTraining::succeeds)},
               {"successes", one.sum(&SweptTraining::successes)},
               {"episodes", one.sum(&SweptTraining::episodes)},
               {"return",
                one.rows.empty() ? Json(nullptr) : Json(one.mean(&SweptTraining::mean_return))},
               {"steps", one.mean(&SweptTraining::steps)},
               {"processor_s", one.mean(&SweptTraining::processor_s)},
               {"problems", Json(one.problems)}});
    return list;
  }

  /// The different values of a setting: numbers in their order, before words in theirs.
  [[nodiscard]] std::vector<std::string> values_of(std::size_t setting) const {
    std::vector<std::string> values;
    for (const SweptTraining& row : rows_) values.push_back(row.values[setting]);
    std::ranges::sort(values, [](const std::string& a, const std::string& b) {
      double x = 0.0, y = 0.0;
      const bool first = host::read_number(a, x) && !std::isnan(x);
      const bool second = host::read_number(b, y) && !std::isnan(y);
      if (first != second) return first;
      return first && x != y ? x < y : a < b;
    });
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  /// Of each setting with several values a chart whose x are their places in `labels`.
  [[nodiscard]] Json charts_json() const {
    Json charts = Json::list();
    for (std::size_t setting = 0; setting < names_.size(); ++setting) {
      const std::vector<std::string> labels = values_of(setting);
      if (labels.size() < 2) continue;
      std::map<std::string_view, std::size_t> places;
      for (const std::string& label : labels) places.emplace(label, places.size());
      Json x = Json::list(), y = Json::list();
      for (const SweptTraining& row : rows_) {
        if (!row.problem.empty()) continue;
        x.push_back(places.at(row.values[setting]));
        y.push_back(row.mean_return);
      }
      Json line{{"name", "a training"}, {"x", std::move(x)}, {"y", std::move(y)}, {"dots", true}};
      Json lines = Json::list();
      lines.push_back(std::move(line));
      charts.push_back(Json{{"name", "Return over " + names_[setting]},
                            {"unit", ""},
                            {"labels", Json(labels)},
                            {"lines", std::move(lines)}});
    }
    return charts;
  }

  TrainingLines& lines_;
  std::vector<std::string> names_;  // of the settings
  std::vector<SweptTraining> rows_;
};

}  // namespace

std::optional<TrainingRecord> read_sweep(TrainingLines& lines) {
  return SweepReader(lines).read();
}

}  // namespace eagerx::gen
