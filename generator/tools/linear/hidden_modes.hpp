// Modes that a regulator neither has to move nor sees. Inside linear/ only.
#pragma once

#include <vector>

#include "generator/tools/linear/periodic.hpp"

namespace eagerx::gen {

/// The modes before the first phase that neither grow nor decay, never cost anything and never
/// reach C·x, as orthonormal columns [n][k]: such as the position of a robot whose wheels measure
/// its speed, and its integral. Modes that decay need no regulator and are not among them.
///
/// Integrators are the largest number of poles nearest to 1 whose mean is 1: those of a chain of k
/// scatter around it as the k-th root of rounding, while their mean hardly moves (Wilkinson: The
/// Algebraic Eigenvalue Problem, 1965, chapter 2). Of other modes, |z| is within 1e-6 of 1.
Eigen::MatrixXd hidden_modes(const PeriodicProblem& problem);

/// Sets them to 0 once each hyperperiod. That changes neither the cost nor C·x, and lets the cost
/// have a regulator. Returns a state for each of them: those that tell them apart best.
std::vector<Eigen::Index> settle_hidden(PeriodicProblem& problem);

}  // namespace eagerx::gen
