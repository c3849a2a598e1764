#include "generator/tools/linear/trim.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "generator/tools/linear/matrices.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
constexpr std::size_t kMostEvaluations = 200;
constexpr double kTolerance = 1e-9;  // of a residual, of the scale of its number

/// A residual or a variable: a word, an input, or an output that is wanted.
struct Place {
  enum class Kind { word, input, output } kind;
  std::size_t index;
};

/// Where the search is.
struct TrimPoint {
  std::vector<double> words, inputs;
  Hyperperiod there;
};

class TrimSearch {
 public:
  /// `apart`: words that keep their values.
  TrimSearch(const TrimQuestion& question, const Evaluate& evaluate, std::vector<bool> apart)
      : question_(question),
        evaluate_(evaluate),
        apart_(std::move(apart)),
        moves_(question.words.size()) {
    for (std::size_t i = 0; i < moves_.size(); ++i) moves_[i] = question.words[i].moving;
  }

  std::optional<TrimAnswer> run() {
    std::vector<double> words, inputs;
    for (const TrimNumber& each : question_.words) words.push_back(each.value);
    for (const TrimNumber& each : question_.inputs) inputs.push_back(within(each, each.value));
    auto begin = at(std::move(words), std::move(inputs));
    if (!begin) return std::nullopt;
    point_ = std::move(*begin);
    constexpr int kMostSteps = 100;
    for (int i = 0; i < kMostSteps && improve(); ++i) {
    }
    return answer();
  }

 private:
  static double within(const TrimNumber& number, double value) {
    return number.fixed ? value : std::clamp(value, number.low, number.high);
  }
  static double scale_of(const TrimNumber& number) {
    const double size = std::max(1.0, std::abs(number.value)),
                 half = (number.high - number.low) / 2;
    return half > 0.0 ? std::min(size, half) : size;
  }
  const TrimNumber& number_at(const Place& place) const {
    return place.kind == Place::Kind::input ? question_.inputs[place.index]
                                            : question_.words[place.index];
  }
  double scale_at(const Place& place) const {
    if (place.kind != Place::Kind::output) return scale_of(number_at(place));
    return std::max(1.0, std::abs(question_.wanted[place.index].value));
  }
  double value_at(const TrimPoint& point, const Place& place) const {
    return (place.kind == Place::Kind::input ? point.inputs : point.words)[place.index];
  }

  std::optional<TrimPoint> at(std::vector<double> words, std::vector<double> inputs) {
    if (evaluations_ >= kMostEvaluations) return std::nullopt;
    ++evaluations_;
    auto there = evaluate_(words, inputs);
    if (!there) return std::nullopt;
    return TrimPoint{std::move(words), std::move(inputs), std::move(*there)};
  }

  /// What depends on a number that moves, moves.
  void spread() {
    const Rows& a = point_.there.system.a;
    for (bool again = true; again;) {
      again = false;
      for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; !moves_[i] && k < a.size(); ++k) {
          if (!moves_[k] || a[i][k] == 0.0) continue;
          moves_[i] = again = true;
        }
      }
    }
  }
  /// Nothing depends on it: it may have any value, and gets that of the next hyperperiod.
  bool is_unread(std::size_t i) const {
    const SampledSystem& s = point_.there.system;
    const auto is_zero = [i](const std::vector<double>& row) { return row[i] == 0.0; };
    return std::ranges::all_of(s.a, is_zero) && std::ranges::all_of(s.c, is_zero);
  }

  /// Residuals and variables for the derivatives where the search is.
  void choose() {
    spread();
    rows_.clear();
    variables_.clear();
    unread_.clear();
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      if (moves_[i] || apart_[i]) continue;
      const bool fixed = question_.words[i].fixed;
      if (!fixed && is_unread(i)) {
        unread_.push_back(i);
        continue;
      }
      rows_.push_back({Place::Kind::word, i});
      if (!fixed && !is_constant(point_.there.system, i))
        variables_.push_back({Place::Kind::word, i});
    }
    for (std::size_t i = 0; i < question_.wanted.size(); ++i)
      rows_.push_back({Place::Kind::output, i});
    for (std::size_t i = 0; i < question_.inputs.size(); ++i) {
      if (!question_.inputs[i].fixed) variables_.push_back({Place::Kind::input, i});
    }
  }

  /// [rows], of their scales.
  Eigen::VectorXd residual_of(const TrimPoint& point) const {
    Eigen::VectorXd residual(static_cast<Index>(rows_.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const std::size_t i = rows_[r].index;
      double value = 0.0;
      if (rows_[r].kind == Place::Kind::word) {
        value = point.there.next[i] - point.words[i];
      } else {
        const WantedOutput& wanted = question_.wanted[i];
        value = point.there.observed[wanted.output] - wanted.value;
      }
      residual[static_cast<Index>(r)] = value / scale_at(rows_[r]);
    }
    return residual;
  }
  double derivative(const Place& row, const Place& variable) const {
    const SampledSystem& s = point_.there.system;
    const bool of_word = variable.kind == Place::Kind::word;
    if (row.kind == Place::Kind::output) {
      const std::size_t output = question_.wanted[row.index].output;
      return (of_word ? s.c : s.d)[output][variable.index];
    }
    const double value = (of_word ? s.a : s.b)[row.index][variable.index];
    return value - (of_word && row.index == variable.index ? 1.0 : 0.0);
  }
  /// [rows][variables], of their scales.
  Eigen::MatrixXd jacobian() const {
    Eigen::MatrixXd j(static_cast<Index>(rows_.size()), static_cast<Index>(variables_.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t v = 0; v < variables_.size(); ++v)
        j(static_cast<Index>(r), static_cast<Index>(v)) =
            derivative(rows_[r], variables_[v]) * scale_at(variables_[v]) / scale_at(rows_[r]);
    }
    return j;
  }

  /// The step of least squares with this damping that stays within bounds: a variable that would
  /// leave goes to its bound, and the others do without it.
  Eigen::VectorXd step(const Eigen::MatrixXd& j, const Eigen::VectorXd& residual,
                       double damping) const {
    const Index n = j.cols();
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(n), rest = residual;
    std::vector<Index> open(static_cast<std::size_t>(n));
    for (Index v = 0; v < n; ++v) open[static_cast<std::size_t>(v)] = v;
    while (!open.empty()) {
      const Eigen::VectorXd some = solve(j, rest, open, damping);
      std::vector<Index> inside;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const Place& place = variables_[static_cast<std::size_t>(open[k])];
        const TrimNumber& number = number_at(place);
        const double from = value_at(point_, place), scale = scale_at(place);
        const double to = from + some[static_cast<Index>(k)] * scale;
        if (to >= number.low && to <= number.high) {
          inside.push_back(open[k]);
          continue;
        }
        whole[open[k]] = (std::clamp(to, number.low, number.high) - from) / scale;
        rest += j.col(open[k]) * whole[open[k]];
      }
      if (inside.size() == open.size()) {
        for (std::size_t k = 0; k < open.size(); ++k) whole[open[k]] = some[static_cast<Index>(k)];
        break;
      }
      open = std::move(inside);
    }
    return whole;
  }
  static Eigen::VectorXd solve(const Eigen::MatrixXd& j, const Eigen::VectorXd& residual,
                               const std::vector<Index>& open, double damping) {
    const auto n = static_cast<Index>(open.size());
    Eigen::MatrixXd part(j.rows() + (damping > 0.0 ? n : 0), n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(part.rows());
    right.head(j.rows()) = -residual;
    for (Index k = 0; k < n; ++k)
      part.col(k).head(j.rows()) = j.col(open[static_cast<std::size_t>(k)]);
    if (damping > 0.0) part.bottomRows(n) = std::sqrt(damping) * Eigen::MatrixXd::Identity(n, n);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(1e-12);
    decomposition.compute(part);
    return decomposition.solve(right);
  }

  std::optional<TrimPoint> moved_by(const Eigen::VectorXd& step) {
    std::vector<double> words = point_.words, inputs = point_.inputs;
    for (const std::size_t i : unread_) words[i] = point_.there.next[i];
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      const Place& place = variables_[v];
      double& value = (place.kind == Place::Kind::input ? inputs : words)[place.index];
      value = within(number_at(place), value + step[static_cast<Index>(v)] * scale_at(place));
    }
    return at(std::move(words), std::move(inputs));
  }

  /// Takes a step that reduces the residual; false if there is none.
  bool improve() {
    choose();
    const Eigen::VectorXd residual = residual_of(point_);
    if (variables_.empty() || residual.size() == 0) return false;
    const Eigen::MatrixXd j = jacobian();
    const double before = residual.norm(),
                 unit = std::max(j.colwise().squaredNorm().maxCoeff(), 1e-300);
    // Gauss and Newton first; then ever more damping.
    constexpr int kTries = 9;
    double damping = damping_ <= kLeastDamping ? 0.0 : damping_;
    for (int i = 0; i < kTries; ++i) {
      auto next = moved_by(step(j, residual, damping * unit));
      if (next && residual_of(*next).norm() < (1.0 - 1e-4) * before) {
        point_ = std::move(*next);
        damping_ = damping / 100.0;
        return true;
      }
      if (before <= kTolerance) return false;  // rounding
      damping = damping == 0.0 ? kLeastDamping : damping * 20.0;
    }
    return false;
  }

  TrimAnswer answer() {
    choose();
    const Eigen::VectorXd residual = residual_of(point_);
    TrimAnswer answer;
    answer.found = residual.size() == 0 || residual.cwiseAbs().maxCoeff() <= kTolerance;
    answer.depends_on_time = answer.found && changes_later();
    answer.found = answer.found && !answer.depends_on_time && settled_rest();
    answer.evaluations = evaluations_;
    const Eigen::MatrixXd j = jacobian();
    if (!answer.found) add_bounds(j.transpose() * residual, answer);
    if (answer.found) add_freedoms(j, answer);
    answer.moves = moves_;
    const Hyperperiod& there = point_.there;
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      const double change =
          answer.depends_on_time ? there.later[i] - there.next[i] : there.next[i] - point_.words[i];
      answer.residual.push_back(moves_[i] ? 0.0 : change);
    }
    for (const std::size_t i : unread_) answer.residual[i] = 0.0;
    for (const std::size_t i : unread_) point_.words[i] = point_.there.next[i];
    answer.words = std::move(point_.words);
    answer.inputs = std::move(point_.inputs);
    answer.there = std::move(point_.there);
    // What quadratic convergence leaves of a zero.
    constexpr double kNothing = 1e-30;
    for (auto* const numbers :
         {&answer.words, &answer.inputs, &answer.residual, &answer.there.observed}) {
      for (double& x : *numbers) x = std::abs(x) < kNothing ? 0.0 : x;
    }
    return answer;
  }
  /// Numbers that settled before the search rest after it: they depend on nothing else, but
  /// derivatives tell that only of where it began.
  bool settled_rest() const {
    for (std::size_t i = 0; i < apart_.size(); ++i) {
      const double change = point_.there.next[i] - point_.words[i];
      if (apart_[i] && !(std::abs(change) <= kTolerance * scale_of(question_.words[i])))
        return false;
    }
    return true;
  }
  /// What rests now does not in the next hyperperiod, even though this one ends where it began.
  bool changes_later() const {
    constexpr double kGrown = 1e-6;  // rounding, at an unstable point
    return std::ranges::any_of(rows_, [&](const Place& row) {
      if (row.kind != Place::Kind::word) return false;
      const double change = point_.there.later[row.index] - point_.there.next[row.index];
      return !(std::abs(change) <= kGrown * scale_at(row));
    });
  }
  void add_bounds(const Eigen::VectorXd& gradient, TrimAnswer& answer) const {
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      const TrimNumber& number = number_at(variables_[v]);
      const double value = value_at(point_, variables_[v]), slope = gradient[static_cast<Index>(v)];
      const bool stops =
          (value <= number.low && slope > 0.0) || (value >= number.high && slope < 0.0);
      if (stops)
        answer.bounds.push_back(
            {variables_[v].kind == Place::Kind::input, variables_[v].index, value});
    }
  }
  void add_freedoms(const Eigen::MatrixXd& j, TrimAnswer& answer) const {
    if (j.size() == 0) return;
    Eigen::FullPivLU<Eigen::MatrixXd> lu;
    lu.setThreshold(1e-9);
    lu.compute(j);
    answer.freedoms = static_cast<std::size_t>(lu.dimensionOfKernel());
    if (answer.freedoms == 0) return;
    const Eigen::MatrixXd kernel = lu.kernel();
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      if (kernel.row(static_cast<Index>(v)).cwiseAbs().maxCoeff() <
          1e-6 * kernel.cwiseAbs().maxCoeff())
        continue;
      (variables_[v].kind == Place::Kind::input ? answer.free_inputs : answer.free_words)
          .push_back(variables_[v].index);
    }
  }

  static constexpr double kLeastDamping = 1e-8;
  const TrimQuestion& question_;
  const Evaluate& evaluate_;
  TrimPoint point_;
  std::vector<bool> apart_, moves_;
  std::vector<Place> rows_, variables_;
  std::vector<std::size_t> unread_;
  std::size_t evaluations_ = 0;
  double damping_ = 0.0;
};

}  // namespace

std::optional<TrimAnswer> find_operating_point(const TrimQuestion& question,
                                               const Evaluate& evaluate) {
  std::vector<bool> settled, none(question.words.size());
  for (const TrimNumber& word : question.words) settled.push_back(word.settled);
  auto first = TrimSearch(question, evaluate, settled).run();
  if (settled == none || !first || first->found) return first;
  auto second = TrimSearch(question, evaluate, none).run();
  return second && second->found ? second : first;
}

}  // namespace eagerx::gen
