// Ground on which the walker learns to walk without cameras.
#pragma once

#include <cstddef>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace walking {

/// Heights [m] of the ground around a level place of 0.6 m x 0.6 m: in each quadrant another kind.
/// GroundRoughness scales them.
struct Terrain {
  static constexpr double kSpacing = 0.1;      // of the grid [m]
  static constexpr std::size_t kPoints = 151;  // along x and y: 15 m, what Clang computes
  static constexpr double kSlope = 0.36397;    // tangent of 20 degrees
  static constexpr double kStep = 0.08;        // height of a step [m]
  static constexpr double kTread = 0.25;       // depth of a step [m]
  static constexpr double kStones = 0.04;      // height of gravel [m]
  static constexpr std::size_t kCells = 4;     // of the grid in a side of a block
  static constexpr double kPyramid = 2.0;      // side of a pyramid [m]
  static constexpr double kLevel = 0.3;        // from the axes [m]

  /// From the nearest edge of a pyramid that `s` is above, up to its middle [m].
  static constexpr double inside(double s) {
    double rest = (s < 0.0 ? -s : s) - kLevel;
    if (rest <= 0.0) return 0.0;
    while (rest >= kPyramid) rest -= kPyramid;
    return rest < 0.5 * kPyramid ? rest : kPyramid - rest;
  }
  /// A number from 0 to 1 that looks random.
  static constexpr double random(std::size_t i, std::size_t k) {
    unsigned mixed = static_cast<unsigned>(i) * 2654435761U ^ static_cast<unsigned>(k) * 40503U;
    mixed = (mixed ^ (mixed >> 15U)) * 2246822519U;
    return static_cast<double>(mixed >> 16U) / 65535.0;
  }
  /// Of point (i, k) of the grid, which is at x, y.
  static constexpr double height(std::size_t i, std::size_t k, double x, double y) {
    const double along_x = inside(x), along_y = inside(y);
    const double nearest = along_x < along_y ? along_x : along_y;
    if (nearest == 0.0) return 0.0;
    if (x > 0.0 && y > 0.0) return kSlope * nearest;
    if (x > 0.0) return kStep * static_cast<double>(static_cast<int>(nearest / kTread + 0.5));
    if (y > 0.0) return kStones * random(i, k);
    return kStep * random(i / kCells, k / kCells);
  }
  static constexpr auto field() {
    eagerx::models::HeightField<kPoints, kPoints> result;
    const double first = -0.5 * kSpacing * static_cast<double>(kPoints - 1);
    result.corner[0] = result.corner[1] = first;
    result.spacing = kSpacing;
    for (std::size_t i = 0; i < kPoints; ++i) {
      for (std::size_t k = 0; k < kPoints; ++k)
        result.height[i][k] =
            static_cast<float>(height(i, k, first + kSpacing * static_cast<double>(i),
                                      first + kSpacing * static_cast<double>(k)));
    }
    return result;
  }
};

/// The ground of a walker: a level plane, or the terrain.
template <class Real, bool IsRough>
struct Floor {};
template <class Real>  // so that only a model with terrain computes it
struct Floor<Real, true> {
  static constexpr auto kHeights = Terrain::field();
};

}  // namespace walking
