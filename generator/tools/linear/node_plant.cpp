#include "generator/tools/linear/node_plant.hpp"

#include <algorithm>
#include <cmath>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

const Json::List& list_of(const Json* value) {
  static const Json::List kNone;
  const Json::List* const list = value != nullptr ? value->as<Json::List>() : nullptr;
  return list != nullptr ? *list : kNone;
}

MatrixXd matrix_in(const Json& phase, std::string_view name, std::size_t columns) {
  const Json::List& rows = list_of(member(&phase, name));
  MatrixXd matrix(rows.size(), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Json::List& row = list_of(&rows[i]);
    for (std::size_t k = 0; k < columns; ++k)
      matrix(static_cast<Index>(i), static_cast<Index>(k)) =
          k < row.size() ? number_of(&row[k]).value_or(0.0) : 0.0;
  }
  return matrix;
}

std::vector<std::string> ports_in(const Json* channels, const Plan& plan) {
  std::vector<std::string> ports;
  for (const std::int64_t channel : integers_of(channels).value_or(std::vector<std::int64_t>()))
    ports.push_back(plan.channels[static_cast<std::size_t>(channel)].port);
  return ports;
}

PlantPhase phase_in(const Json& json, std::size_t states) {
  PlantPhase phase;
  phase.input_messages = static_cast<std::size_t>(number_of(member(&json, "cut")).value_or(0.0));
  for (const std::int64_t count :
       integers_of(member(&json, "messages")).value_or(std::vector<std::int64_t>()))
    phase.messages.push_back(static_cast<std::size_t>(count));
  const Json::List& b = list_of(member(&json, "B"));
  const std::size_t inputs = b.empty() ? 0 : list_of(b.data()).size();
  phase.a = matrix_in(json, "A", states);
  phase.b = MatrixXd::Zero(static_cast<Index>(states), static_cast<Index>(inputs));
  if (!b.empty()) phase.b = matrix_in(json, "B", inputs);
  phase.c = matrix_in(json, "C", states);
  phase.e = matrix_in(json, "E", states);
  phase.f = matrix_in(json, "F", inputs);
  if (phase.f.rows() != phase.e.rows())
    phase.f = MatrixXd::Zero(phase.e.rows(), static_cast<Index>(inputs));
  return phase;
}

/// Derivatives that are rounding alone, of compensated sums for example, are none: those 1e-13
/// times as large as others by the same number.
void drop_rounding(MatrixXd& matrix) {
  constexpr double kRounding = 1e-13;
  for (Index k = 0; k < matrix.cols(); ++k) {
    const double least = kRounding * matrix.col(k).cwiseAbs().maxCoeff();
    for (Index i = 0; i < matrix.rows(); ++i) {
      double& each = matrix(i, k);
      each = std::abs(each) > least ? each : 0.0;
    }
  }
}

/// Which numbers of the state depend on each other, in any phase.
class StateGraph {
 public:
  explicit StateGraph(const NodePlant& plant) : plant_(plant), n_(plant.state.size()) {}

  std::vector<bool> kept(Kept what) const {
    std::vector<bool> keeps(n_, true);
    leave_out_constants(keeps);
    const std::vector<bool> seen = spread(
        keeps, [&](std::size_t i) { return is_seen(i); }, false);
    for (std::size_t i = 0; i < n_; ++i) keeps[i] = keeps[i] && seen[i];
    if (what == Kept::seen) return keeps;
    const std::vector<bool> hit = spread(
        keeps, [&](std::size_t i) { return is_hit(i); }, true);
    for (std::size_t i = 0; i < n_; ++i) keeps[i] = keeps[i] && hit[i];
    return keeps;
  }

 private:
  /// Whether `to` depends on `from` in a phase.
  [[nodiscard]] bool depends(std::size_t to, std::size_t from) const {
    return std::ranges::any_of(plant_.phases, [&](const PlantPhase& phase) {
      return phase.a(static_cast<Index>(to), static_cast<Index>(from)) != 0.0;
    });
  }
  [[nodiscard]] bool is_seen(std::size_t i) const {
    return std::ranges::any_of(plant_.phases, [&](const PlantPhase& phase) {
      const auto k = static_cast<Index>(i);
      return !phase.c.col(k).isZero(0.0) || !phase.e.col(k).isZero(0.0);
    });
  }
  [[nodiscard]] bool is_hit(std::size_t i) const {
    return std::ranges::any_of(plant_.phases, [&](const PlantPhase& phase) {
      return !phase.b.row(static_cast<Index>(i)).isZero(0.0);
    });
  }
  /// Parameters, and what is never set.
  void leave_out_constants(std::vector<bool>& keeps) const {
    for (bool any = true; any;) {
      any = false;
      for (std::size_t i = 0; i < n_; ++i) {
        if (!keeps[i] || !is_constant(i, keeps)) continue;
        keeps[i] = false;
        any = true;
      }
    }
  }
  /// x[i]' = x[i] or 0, whatever the others are.
  [[nodiscard]] bool is_constant(std::size_t i, const std::vector<bool>& keeps) const {
    if (is_hit(i)) return false;
    const auto row = static_cast<Index>(i);
    const auto is_all = [&](double own) {
      return std::ranges::all_of(plant_.phases, [&](const PlantPhase& phase) {
        for (std::size_t k = 0; k < n_; ++k) {
          if (keeps[k] && phase.a(row, static_cast<Index>(k)) != (k == i ? own : 0.0)) return false;
        }
        return true;
      });
    };
    return is_all(1.0) || is_all(0.0);
  }
  /// All that `begins` is spread to: forward in time, or backward.
  template <class F>
  [[nodiscard]] std::vector<bool> spread(const std::vector<bool>& keeps, F begins,
                                         bool forward) const {
    std::vector<bool> has(n_);
    std::vector<std::size_t> next;
    const auto take = [&](std::size_t i) {
      if (!keeps[i] || has[i]) return;
      has[i] = true;
      next.push_back(i);
    };
    for (std::size_t i = 0; i < n_; ++i) {
      if (begins(i)) take(i);
    }
    while (!next.empty()) {
      const std::size_t from = next.back();
      next.pop_back();
      for (std::size_t i = 0; i < n_; ++i) {
        if (forward ? depends(i, from) : depends(from, i)) take(i);
      }
    }
    return has;
  }

  const NodePlant& plant_;
  std::size_t n_;
};

MatrixXd rows_at(const MatrixXd& all, const std::vector<Index>& at) {
  MatrixXd result(static_cast<Index>(at.size()), all.cols());
  for (std::size_t i = 0; i < at.size(); ++i) result.row(static_cast<Index>(i)) = all.row(at[i]);
  return result;
}
MatrixXd columns_at(const MatrixXd& all, const std::vector<Index>& at) {
  MatrixXd result(all.rows(), static_cast<Index>(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) result.col(static_cast<Index>(i)) = all.col(at[i]);
  return result;
}

}  // namespace

std::optional<NodePlant> read_plant(std::string_view text, const Plan& plan) {
  const auto json = parse_json(text);
  const Json* const phases = json ? member(&*json, "phases") : nullptr;
  if (phases == nullptr || list_of(phases).empty()) return std::nullopt;
  NodePlant plant;
  plant.period_s = number_of(member(&*json, "period_s")).value_or(0.0);
  for (const Json& word : list_of(member(&*json, "state"))) {
    const Json::List& parts = list_of(&word);
    if (parts.size() < 2) return std::nullopt;
    plant.state.push_back(text_of(parts.data()));
    plant.values.push_back(number_of(&parts[1]).value_or(0.0));
  }
  for (const Json& input : list_of(member(&*json, "received"))) {
    const Json::List& parts = list_of(&input);
    if (parts.size() < 2) return std::nullopt;
    const auto elements = static_cast<std::size_t>(number_of(&parts[1]).value_or(0.0));
    for (std::size_t i = 0; i < elements; ++i) plant.received.push_back({text_of(parts.data()), i});
  }
  plant.losing = ports_in(member(&*json, "losing"), plan);
  plant.smoothing = ports_in(member(&*json, "smoothing"), plan);
  for (const Json& phase : list_of(phases)) {
    PlantPhase& read = plant.phases.emplace_back(phase_in(phase, plant.state.size()));
    drop_rounding(read.a);
    drop_rounding(read.b);
  }
  return plant;
}

void reduce(NodePlant& plant, Kept kept) {
  keep(plant, StateGraph(plant).kept(kept));
}

void keep(NodePlant& plant, const std::vector<bool>& keeps) {
  std::vector<Index> at;
  std::vector<std::string> names;
  std::vector<double> values;
  for (std::size_t i = 0; i < keeps.size(); ++i) {
    if (!keeps[i]) continue;
    at.push_back(static_cast<Index>(i));
    names.push_back(plant.state[i]);
    values.push_back(plant.values[i]);
  }
  plant.state = std::move(names);
  plant.values = std::move(values);
  for (PlantPhase& phase : plant.phases) {
    phase.a = columns_at(rows_at(phase.a, at), at);
    phase.b = rows_at(phase.b, at);
    phase.c = columns_at(phase.c, at);
    phase.e = columns_at(phase.e, at);
  }
}

MatrixXd monodromy(const std::vector<MatrixXd>& a) {
  MatrixXd product = MatrixXd::Identity(a.front().rows(), a.front().rows());
  for (const MatrixXd& each : a) product = (each * product).eval();
  return product;
}

}  // namespace eagerx::gen
