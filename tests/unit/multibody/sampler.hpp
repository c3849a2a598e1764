// Random numbers, the equations of a two-link arm, and accelerations of the engine.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tests/unit/multibody/multibody_io.hpp"

namespace eagerx::models::testing {

/// [q1, q2, q1', q2'] by Lagrange's equations, angles from upright, the second relative.
struct LagrangeArm {
  struct Config {
    static constexpr std::array<double, 2> masses = {1.5, 1.0};
    static constexpr std::array<double, 2> lengths = {0.5, 0.4};
  };
  static constexpr double m1 = 1.5, m2 = 1.0, l1 = 0.5, l2 = 0.4, g = 9.81;
  static constexpr double c1 = l1 / 2, c2 = l2 / 2;
  static constexpr double i1 = m1 * l1 * l1 / 12, i2 = m2 * l2 * l2 / 12;

  static std::array<double, 2> acceleration(const std::array<double, 4>& x, double t1, double t2) {
    const double c = std::cos(x[1]), s = std::sin(x[1]);
    const double m11 = i1 + i2 + m1 * c1 * c1 + m2 * (l1 * l1 + c2 * c2 + 2 * l1 * c2 * c);
    const double m12 = i2 + m2 * (c2 * c2 + l1 * c2 * c);
    const double m22 = i2 + m2 * c2 * c2;
    const double h = m2 * l1 * c2 * s;
    const double second = m2 * g * c2 * std::sin(x[0] + x[1]);
    const double b1 =
        t1 + h * x[3] * (2 * x[2] + x[3]) + (m1 * c1 + m2 * l1) * g * std::sin(x[0]) + second;
    const double b2 = t2 - h * x[2] * x[2] + second;
    const double det = m11 * m22 - m12 * m12;
    return {(m22 * b1 - m12 * b2) / det, (m11 * b2 - m12 * b1) / det};
  }
  static double energy(const std::array<double, 4>& x) {
    const double c = std::cos(x[1]), w = x[2] + x[3];
    const double v2 = l1 * l1 * x[2] * x[2] + c2 * c2 * w * w + 2 * l1 * c2 * c * x[2] * w;
    const double kinetic =
        0.5 * (i1 + m1 * c1 * c1) * x[2] * x[2] + 0.5 * i2 * w * w + 0.5 * m2 * v2;
    return kinetic + m1 * g * c1 * std::cos(x[0]) +
           m2 * g * (l1 * std::cos(x[0]) + c2 * std::cos(x[0] + x[1]));
  }
};

/// Accelerations of links at a state.
template <class Model>
auto accelerations(const MultibodySimulator<Model>& simulator) {
  using Lane = LaneOf<typename Model::Real>;
  auto state = simulator.numbers();
  const multibody::ContactSettings<Lane> settings{0, 0, 1, 0, Lane(1e-3)};
  multibody::Step<Model> step(state, settings, typename Model::Real(0));
  step.set_accelerations(1);
  std::array<double, multibody::State<Model>::kLinks> result{};
  for (std::size_t j = 0; j < result.size(); ++j)
    result[j] = static_cast<double>(step.acceleration[j]);
  return result;
}

/// Random numbers that every library gives alike.
struct Sampler {
  unsigned state = 1;
  double operator()(double most) {
    state = state * 1664525U + 1013904223U;
    return most * (2.0 * (state >> 8) / 16777216.0 - 1.0);
  }
};

}  // namespace eagerx::models::testing
