// Masses and inertia that are physically impossible.
#pragma once

#include <vector>

#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {

/// Bodies without mass, such as frames on a joint, get a little of it. Problems: E0856.
void give_masses(std::vector<Body>& bodies, gen::Diagnostics& diagnostics);
/// An inertia that is not positive definite becomes that of a ball of water. Problems: E0856.
void check_inertia(Body& body, gen::Diagnostics& diagnostics);
/// Reports values that overflow to infinity (E0853).
void check_finite(const Robot& robot, gen::Span place, gen::Diagnostics& diagnostics);

}  // namespace eagerx::urdf
