// Gains of a linear-quadratic regulator, of the numbers that its node receives.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/linear/design.hpp"
#include "generator/tools/linear/hidden_modes.hpp"
#include "generator/tools/linear/node_plant.hpp"
#include "generator/tools/linear/periodic.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kNothing = 1e-12;
constexpr double kDetermined = 1e-6;  // of the regulator's output: what is no more is rounding

class LqrDesigner {
 public:
  LqrDesigner(NodePlant plant, const std::string& input, const LqrRequest& request)
      : plant_(std::move(plant)), request_(request) {
    for (std::size_t i = 0; i < plant_.received.size(); ++i) {
      if (plant_.received[i].input == input) rows_.push_back(static_cast<Index>(i));
    }
  }

  LqrDesign run() {
    result_.losing = plant_.losing;
    result_.smoothing = plant_.smoothing;
    reduce_to_what_costs();
    if (!result_.problem.empty()) return std::move(result_);
    make_problem();
    settle();
    const auto regulator = solve_periodic(problem_);
    if (!regulator) {
      explain();
      return std::move(result_);
    }
    solve(*regulator);
    return std::move(result_);
  }

 private:
  /// Weights in C of what is received and in E of other ports; states that are weighted are rows of
  /// E, too.
  void reduce_to_what_costs() {
    for (const Deviation& each : request_.deviations) {
      if (each.of == Deviation::Of::state) add_state(each);
    }
    if (!result_.problem.empty()) return;
    reduce(plant_, Kept::reached);
    if (plant_.state.empty() || plant_.inputs() == 0) {
      result_.problem = "nothing that the node receives depends on what it sends";
      result_.help =
          "connect its output to the plant, and choose a point at which no limit holds "
          "it: `--at`";
    }
  }
  void add_state(const Deviation& each) {
    const auto found = std::ranges::find(plant_.state, each.name);
    if (found == plant_.state.end()) {
      result_.problem =
          fmt::format("neither a port nor a number of the state is called `{}`", each.name);
      result_.help = "numbers of the state are " + join(plant_.state, ", ");
      return;
    }
    const Index at = found - plant_.state.begin();
    for (PlantPhase& phase : plant_.phases) {
      phase.e.conservativeResize(phase.e.rows() + 1, Eigen::NoChange);
      phase.e.bottomRows(1).setZero();
      phase.e(phase.e.rows() - 1, at) = 1.0 / each.value;
      phase.f.conservativeResize(phase.f.rows() + 1, Eigen::NoChange);
      phase.f.bottomRows(1).setZero();
    }
  }

  /// Squares of 1/deviation of the rows of C.
  VectorXd received_weights() const {
    VectorXd weights = VectorXd::Zero(static_cast<Index>(plant_.received.size()));
    for (const Deviation& each : request_.deviations) {
      if (each.of != Deviation::Of::received) continue;
      for (std::size_t i = 0; i < plant_.received.size(); ++i) {
        if (plant_.received[i].input == each.name && plant_.received[i].element == each.element)
          weights[static_cast<Index>(i)] += 1.0 / (each.value * each.value);
      }
    }
    return weights;
  }
  /// Of the rows of E: of several messages between two ticks, their mean counts.
  VectorXd port_weights(const PlantPhase& phase) const {
    VectorXd weights = VectorXd::Zero(phase.e.rows());
    std::size_t states = 0;
    for (const Deviation& each : request_.deviations) states += each.of == Deviation::Of::state;
    weights.tail(static_cast<Index>(states)).setOnes();
    for (const Deviation& each : request_.deviations) {
      if (each.of != Deviation::Of::port) continue;
      Index row = 0;
      for (std::size_t p = 0; p < each.port; ++p) row += size_of_port(p) * count(phase, p);
      for (Index message = 0; message < count(phase, each.port); ++message)
        weights[row + message * size_of_port(each.port) + static_cast<Index>(each.element)] +=
            mean_weight(each.port) / (each.value * each.value);
    }
    return weights;
  }
  static Index count(const PlantPhase& phase, std::size_t port) {
    return static_cast<Index>(phase.messages[port]);
  }
  Index size_of_port(std::size_t port) const {
    return static_cast<Index>(request_.port_sizes[port]);
  }
  /// Of each message, so that all messages of a port count as much as those of the node.
  double mean_weight(std::size_t port) const {
    std::size_t all = 0;
    for (const PlantPhase& phase : plant_.phases) all += phase.messages[port];
    return static_cast<double>(plant_.phases.size()) /
           static_cast<double>(std::max<std::size_t>(all, 1));
  }

  /// In units of efforts, so that R is 1.
  void make_problem() {
    const Index m = plant_.inputs();
    VectorXd effort(m);
    for (Index i = 0; i < m; ++i) effort[i] = request_.efforts[static_cast<std::size_t>(i)];
    const VectorXd weights = received_weights();
    for (const PlantPhase& phase : plant_.phases) {
      const MatrixXd b = phase.b * effort.asDiagonal(), f = phase.f * effort.asDiagonal();
      const VectorXd we = port_weights(phase);
      PeriodicPhase here;
      here.cost.a = phase.a;
      here.cost.b = b;
      here.cost.q = phase.c.transpose() * weights.asDiagonal() * phase.c +
                    phase.e.transpose() * we.asDiagonal() * phase.e;
      here.cost.s = phase.e.transpose() * we.asDiagonal() * f;
      here.cost.r = MatrixXd::Identity(m, m) + f.transpose() * we.asDiagonal() * f;
      here.c.resize(static_cast<Index>(rows_.size()), phase.c.cols());
      for (std::size_t i = 0; i < rows_.size(); ++i)
        here.c.row(static_cast<Index>(i)) = phase.c.row(rows_[i]);
      problem_.push_back(std::move(here));
    }
    effort_ = effort;
  }

  void settle() {
    for (const Index state : settle_hidden(problem_))
      result_.free.push_back(plant_.state[static_cast<std::size_t>(state)]);
  }

  void solve(const PeriodicRegulator& regulator) {
    std::vector<MatrixXd> closed;
    double least = 0.0;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const LinearQuadratic& here = problem_[i].cost;
      closed.emplace_back(here.a - here.b * regulator.gain[i]);
      least += (here.b.transpose() * regulator.p[i + 1] * here.b).trace();
    }
    covariance_ = covariances(problem_, closed);
    scale_received();
    const MatrixXd estimate = best_estimate(regulator);
    find_unknown(regulator, estimate);
    MatrixXd gain = estimate;
    if (result_.unknown > kDetermined) {
      const auto found = least_output_feedback(problem_, {estimate, present_gain()});
      if (!found) return explain_missing();
      gain = *found;
      result_.cost = output_feedback(problem_, gain).cost / least;
    }
    const MatrixXd natural = effort_.asDiagonal() * gain * scale_.cwiseInverse().asDiagonal();
    for (Index i = 0; i < natural.rows(); ++i) {
      auto& row = result_.gain.emplace_back();
      for (Index k = 0; k < natural.cols(); ++k) row.push_back(natural(i, k));
    }
  }

  /// Elements in units of how much they move under the regulator; one that does not move counts as
  /// none.
  void scale_received() {
    VectorXd squares = VectorXd::Zero(problem_.front().c.rows());
    for (std::size_t i = 0; i < problem_.size(); ++i)
      squares += (problem_[i].c * covariance_[i] * problem_[i].c.transpose()).diagonal();
    scale_ = (squares / static_cast<double>(problem_.size())).cwiseMax(0.0).cwiseSqrt();
    moves_ = (scale_.array() > 0.0).cast<double>();
    for (double& each : scale_) each = each > 0.0 ? each : 1.0;
    for (PeriodicPhase& phase : problem_)
      phase.c = (scale_.cwiseInverse().cwiseProduct(moves_).asDiagonal() * phase.c).eval();
  }

  /// K with the least mean square of K_full·x - K·C·x.
  MatrixXd best_estimate(const PeriodicRegulator& regulator) const {
    const Index p = problem_.front().c.rows();
    MatrixXd cross = MatrixXd::Zero(effort_.size(), p), square = MatrixXd::Zero(p, p);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const MatrixXd of_c = covariance_[i] * problem_[i].c.transpose();
      cross += regulator.gain[i] * of_c;
      square += problem_[i].c * of_c;
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(square);
    const double most = eigen.eigenvalues().cwiseAbs().maxCoeff();
    VectorXd inverse = eigen.eigenvalues();
    for (double& each : inverse) each = each > kNothing * most ? 1.0 / each : 0.0;
    return cross * eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  }

  /// How much of the regulator's output the received numbers leave unknown, and which numbers of
  /// the state would say more.
  void find_unknown(const PeriodicRegulator& regulator, const MatrixXd& estimate) {
    const Index n = problem_.front().cost.a.rows();
    double whole = 0.0, rest = 0.0;
    MatrixXd rest_with_x = MatrixXd::Zero(effort_.size(), n);
    VectorXd variance = VectorXd::Zero(n);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const MatrixXd& full = regulator.gain[i];
      const MatrixXd r = full - estimate * problem_[i].c;
      whole += (full * covariance_[i] * full.transpose()).trace();
      rest += (r * covariance_[i] * r.transpose()).trace();
      rest_with_x += r * covariance_[i];
      variance += covariance_[i].diagonal() - known_part(i);
    }
    result_.unknown = whole > 0.0 ? std::sqrt(std::max(0.0, rest) / whole) : 0.0;
    if (!(result_.unknown > kDetermined)) return;
    for (Index k = 0; k < n; ++k) {
      if (!(variance[k] > 0.0)) continue;
      const double share = rest_with_x.col(k).squaredNorm() / (variance[k] * rest);
      if (share > 0.01)
        result_.missing.push_back(
            {plant_.state[static_cast<std::size_t>(k)], std::min(1.0, share)});
    }
    std::ranges::stable_sort(result_.missing, std::greater<>(), &MissingState::share);
    if (result_.missing.size() > 5) result_.missing.resize(5);
  }
  /// The variance of each number of the state that the received ones determine.
  VectorXd known_part(std::size_t i) const {
    const MatrixXd& c = problem_[i].c;
    const MatrixXd of_c = covariance_[i] * c.transpose();
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> square(c * of_c);
    const MatrixXd share = square.solve(of_c.transpose());
    return (of_c * share).diagonal();
  }

  MatrixXd present_gain() const {
    MatrixXd gain = MatrixXd::Zero(effort_.size(), scale_.size());
    for (Index i = 0; i < gain.rows(); ++i) {
      for (Index k = 0; k < gain.cols(); ++k) {
        const auto at = static_cast<std::size_t>(i * gain.cols() + k);
        if (at < request_.gain.size()) gain(i, k) = request_.gain[at] * scale_[k] / effort_[i];
      }
    }
    return gain;
  }

  void explain_missing() {
    std::vector<std::string> names;
    for (const MissingState& each : result_.missing) names.push_back("`" + each.name + "`");
    result_.problem = fmt::format(
        "no constant gains of what the node receives that are stable were found: it does not "
        "receive {}",
        names.empty() ? "enough" : join(names, ", "));
    result_.help = "connect a sensor of it, or an Observer or KalmanFilter that estimates it";
  }

  /// Which mode has no solution: the one on or outside the unit circle that costs least, or that
  /// the output moves least (Popov, Belevitch, Hautus).
  void explain() {
    const Suspect costless = least_costly(), unmoved = least_moved();
    const bool costs_nothing = costless.share <= unmoved.share;
    const Suspect& worst = costs_nothing ? costless : unmoved;
    if (!(worst.share < kOnCircle)) {
      result_.problem = "there is no regulator to within rounding";
      result_.help = "choose deviations and efforts that are closer to what moves";
      return;
    }
    result_.problem =
        fmt::format("there is no regulator: a mode with |z| = {:.6g}, of `{}` above all, {}",
                    worst.size, plant_.state[static_cast<std::size_t>(worst.state)],
                    costs_nothing ? "costs nothing" : "does not move with the output");
    result_.help = costs_nothing
                       ? "state which deviation of it is tolerable: `--deviation`"
                       : "close the loop that stabilizes it first, or design a node that moves it";
  }
  struct Suspect {
    double share = std::numeric_limits<double>::infinity();  // of what it could cost, or move
    double size = 0.0;                                       // |z|
    Index state = 0;
  };
  template <class Share>
  static Suspect least_of(const MatrixXd& map, Share share) {
    const Eigen::EigenSolver<MatrixXd> modes(map);
    Suspect least;
    for (Index k = 0; k < map.rows(); ++k) {
      const double size = std::abs(modes.eigenvalues()[k]);
      if (size < 1.0 - kOnCircle) continue;
      const double here = share(Eigen::VectorXcd(modes.eigenvectors().col(k)));
      if (here >= least.share) continue;
      least = {here, size, 0};
      modes.eigenvectors().col(k).cwiseAbs().maxCoeff(&least.state);
    }
    return least;
  }
  Suspect least_costly() const {
    return least_of(map_of(problem_), [this](Eigen::VectorXcd x) {
      double cost = 0.0, most = 0.0;
      for (const PeriodicPhase& phase : problem_) {
        cost += (phase.cost.q * x).norm();
        most += phase.cost.q.norm() * x.norm();
        x = (phase.cost.a * x).eval();
      }
      return most > 0.0 ? cost / most : 0.0;
    });
  }
  /// Of left eigenvectors; the state is the one in which the output would have to be.
  Suspect least_moved() const {
    return least_of(map_of(problem_).transpose(), [this](Eigen::VectorXcd x) {
      double moved = 0.0, most = 0.0;
      for (std::size_t i = problem_.size(); i-- > 0;) {
        const LinearQuadratic& here = problem_[i].cost;
        moved += (here.b.transpose() * x).norm();
        most += here.b.norm() * x.norm();
        x = (here.a.transpose() * x).eval();
      }
      return most > 0.0 ? moved / most : 0.0;
    });
  }

  NodePlant plant_;
  const LqrRequest& request_;
  std::vector<Index> rows_;  // of what is received: those with gains
  PeriodicProblem problem_;
  VectorXd effort_, scale_, moves_;
  std::vector<MatrixXd> covariance_;
  LqrDesign result_;
};

}  // namespace

LqrDesign design_lqr(std::string_view printed, const Plan& plan, const std::string& input,
                     const LqrRequest& request) {
  auto plant = read_plant(printed, plan);
  if (!plant) {
    LqrDesign result;
    result.problem = kNoMatrices;
    return result;
  }
  return LqrDesigner(std::move(*plant), input, request).run();
}

}  // namespace eagerx::gen
