// Masses and inertia that no body has.
#pragma once

#include <vector>

#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {

/// Bodies without mass, such as frames on a joint, get a little of it. Problems: E0856.
void give_masses(std::vector<Body>& bodies, gen::Diagnostics& diagnostics);
/// An inertia that is not positive definite becomes that of a ball of water. Problems: E0856.
void check_inertia(Body& body, gen::Diagnostics& diagnostics);
/// What numbers that are too large make infinite is an error (E0853).
void check_finite(const Robot& robot, gen::Span place, gen::Diagnostics& diagnostics);

}  // namespace eagerx::urdf
