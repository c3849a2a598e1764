// A policy as it is deployed: observations as they are, actions in their bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/network.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

/// [action numbers] bounds of the actions.
struct Bounds {
  explicit Bounds(const Description& description);
  std::vector<float> low, high;

  /// From -1…1 to the bounds of number `j`; beyond, the bound. As generated programs do it.
  float scaled(std::size_t j, float x) const;
};

/// (x - mean) / deviation, at most eight deviations: what the networks see while they learn.
class Normaliser {
 public:
  explicit Normaliser(const Statistics& statistics);
  /// Rows [16][width] to packs [width].
  void load(const float* rows, Pack* x) const;

 private:
  std::vector<float> mean_, scale_;
};

/// The actor's network with the normalisation inside of its first layer. Without the limit of eight
/// deviations: on its own data it hardly matters, and a board does less.
std::vector<float> folded(const Network& actor, std::vector<float> parameters,
                          const Statistics& statistics);

struct Policy {
  Network network;
  std::vector<float> parameters;  // folded
  Bounds bounds;

  /// Outputs in -1…1 for sixteen observations: rows [16][inputs]. `row` [network.row()] is scratch,
  /// and has the answers at network.output().
  void answer(const Kernels& kernels, const float* rows, Pack* row) const;
};

}  // namespace eagerx::train
