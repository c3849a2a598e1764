// Linear-quadratic control of a system whose maps repeat after some phases. Inside linear/ only.
#pragma once

#include <optional>
#include <vector>

#include "generator/tools/linear/riccati.hpp"

namespace eagerx::gen {

/// A phase: x' = A·x + B·u with the cost of LinearQuadratic, and what is received, C·x.
struct PeriodicPhase {
  LinearQuadratic cost;
  Eigen::MatrixXd c;
};
using PeriodicProblem = std::vector<PeriodicPhase>;

/// A mode this close to the unit circle neither grows nor decays: of |z| from 1, as for margins.
inline constexpr double kOnCircle = 1e-6;

/// Of the state, over all phases without an input.
Eigen::MatrixXd map_of(const PeriodicProblem& problem);

/// The regulator of the whole state: a gain and a cost x'·P·x for each phase, before it.
struct PeriodicRegulator {
  std::vector<Eigen::MatrixXd> p, gain;
};
/// By lifting: the phases are one step with all of their inputs (Bittanti, Colaneri: Periodic
/// Systems, 2009, 6.2). Nothing if there is none, as of solve_riccati().
std::optional<PeriodicRegulator> solve_periodic(const PeriodicProblem& problem);

/// The covariance of the state before each phase, with white noise of variance 1 on each input;
/// `closed`: the maps of the phases, stable.
std::vector<Eigen::MatrixXd> covariances(const PeriodicProblem& problem,
                                         const std::vector<Eigen::MatrixXd>& closed);

/// u = -K·C·x with the same K in all phases: the mean cost of a hyperperiod under that noise, and
/// its derivatives by K.
struct OutputFeedback {
  double spectral_radius = 0.0;  // of the closed loop, over all phases
  double cost = 0.0;             // if it is stable
  Eigen::MatrixXd slope;
};
OutputFeedback output_feedback(const PeriodicProblem& problem, const Eigen::MatrixXd& gain);

/// The K of least cost that descending finds from `starts`, or from the stable gains to which
/// stabilizing_gains() leads from them; nothing if it leads to none.
std::optional<Eigen::MatrixXd> least_output_feedback(const PeriodicProblem& problem,
                                                     const std::vector<Eigen::MatrixXd>& starts);

}  // namespace eagerx::gen
