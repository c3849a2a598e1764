#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <runtime/host/base/cells.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/renamed.hpp>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/training/curves.hpp"
#include "generator/tools/training/tables.hpp"

namespace eagerx::gen {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells = host::cells_of(line);
  for (std::string_view& cell : cells) {
    if (cell.size() >= 2 && cell.starts_with('"') && cell.ends_with('"'))
      cell = cell.substr(1, cell.size() - 2);
  }
  return cells;
}

namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

class CurveReader {
 public:
  CurveReader(std::string_view header, TrainingLines& lines)
      : names_(with_new_names(cells_of(header))), lines_(lines) {}

  std::optional<TrainingRecord> read() {
    while (const auto line = lines_.next()) {
      if (!read_row(cells_of(*line))) return std::nullopt;
    }
    if (lines_.has_failed()) return std::nullopt;
    TrainingRecord record;
    Json trainings = Json::list();
    for (const LearningCurve& curve : curves_)
      trainings.push_back(Json{{"seed", has_seeds() ? Json(curve.seed) : Json(nullptr)},
                               {"steps", curve.steps.back()}});
    record.page = Json{{"kind", "curve"},
                       {"charts", curve_charts(curves_, {})},
                       {"trainings", std::move(trainings)}};
    return record;
  }

 private:
  static std::vector<std::string_view> with_new_names(std::vector<std::string_view> names) {
    for (std::string_view& name : names) {
      const std::string_view now = host::new_name(host::kCurveColumns, name);
      if (!now.empty()) name = now;
    }
    return names;
  }
  [[nodiscard]] std::size_t place_of(std::string_view name) const {
    const auto found = ranges::find(names_, name);
    return found == names_.end() ? kNowhere : static_cast<std::size_t>(found - names_.begin());
  }
  [[nodiscard]] bool has_seeds() const { return place_of("seed") != kNowhere; }

  bool read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != names_.size())
      return lines_.fail(fmt::format("it has {}, and the first line has {}",
                                     counted(cells.size(), "cell"), names_.size()));
    std::uint64_t seed = 0;
    if (has_seeds() && !host::read_number(cells[place_of("seed")], seed))
      return lines_.fail("`seed` is not a whole number");
    LearningCurve* const curve = curve_of(seed);
    if (curve == nullptr) return lines_.fail("there are more trainings than may be");
    double steps = 0.0;
    if (!read(cells[place_of("steps")], steps) || steps < 0.0)
      return lines_.fail("`steps` is not a number");
    if (!curve->steps.empty() && steps <= curve->steps.back())
      return lines_.fail("its steps are not more than those before");
    numbers_ += 1 + curve->columns.size();
    if (numbers_ > kMostNumbers) return lines_.fail("there are more numbers than may be");
    curve->steps.push_back(steps);
    for (std::size_t i = 0; i < kCurveColumns.size(); ++i) {
      double value = std::numeric_limits<double>::quiet_NaN();
      const std::size_t place = place_of(kCurveColumns.at(i));
      if (place != kNowhere && !cells[place].empty() && !read(cells[place], value))
        return lines_.fail(fmt::format("`{}` is not a number", kCurveColumns.at(i)));
      curve->columns.at(i).push_back(value);
    }
    return true;
  }

  static bool read(std::string_view cell, double& value) {
    return host::read_number(cell, value) && std::isfinite(value);
  }

  LearningCurve* curve_of(std::uint64_t seed) {
    const auto found = ranges::find(curves_, seed, &LearningCurve::seed);
    if (found != curves_.end()) return &*found;
    if (curves_.size() >= kMostTrainings) return nullptr;
    curves_.emplace_back();
    curves_.back().seed = seed;
    return &curves_.back();
  }

  const std::vector<std::string_view> names_;
  TrainingLines& lines_;
  std::vector<LearningCurve> curves_;
  std::size_t numbers_ = 0;  // of all of them
};

}  // namespace

std::optional<TrainingRecord> read_curves(std::string_view header, TrainingLines& lines) {
  return CurveReader(header, lines).read();
}

}  // namespace eagerx::gen
