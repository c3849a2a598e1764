// A policy as deployed: raw observations, actions within their bounds or chosen.
#pragma once

#include <cstdint>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/network.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

/// How a network's outputs become actions: each a number within its bounds, or scores, for each
/// whole number as many as it has values, side by side.
struct Head {
  explicit Head(const Description& description);
  bool chooses = false;
  std::size_t outputs = 0;          // of the network
  std::size_t numbers = 0;          // of an action
  std::vector<float> low, high;     // [numbers] bounds
  std::vector<std::size_t> counts;  // [numbers] scores of each, if it chooses

  /// From -1…1 to the bounds of number `j`; beyond, the bound. As generated programs do it.
  float scaled(std::size_t j, float x) const;
  /// The actions [numbers] of the answers [outputs] in a lane. Of each choice the largest score,
  /// the first of equal ones, as generated programs do it.
  void act(const Simd* answers, std::size_t lane, float* action) const;
};

/// (x - mean) / deviation, clipped to eight deviations: the inputs of the networks during training.
class Normaliser {
 public:
  explicit Normaliser(const Statistics& statistics);
  /// Rows [16][width] to SIMD vectors [width].
  void load(const float* rows, Simd* x) const;

 private:
  std::vector<float> mean_, scale_;
};

/// The actor's network with the normalisation inside of its first layer. Without the limit of eight
/// deviations: on its own data it hardly matters, and a board does less.
std::vector<float> folded(const Network& actor, std::vector<float> parameters,
                          const Statistics& statistics);

/// Changes the first layer so that the network gives the same answers when its inputs are
/// normalized by `after` instead of `before`: the policy must not change with a running mean (like
/// van Hasselt et al. 2016 for outputs). Inputs after those of the statistics are unchanged.
void keep_answers(const Network& network, std::vector<float>& parameters, const Statistics& before,
                  const Statistics& after);

struct Policy {
  Network network;
  std::vector<float> parameters;  // folded
  Head head;

  /// Outputs, in -1…1 unless they choose, for sixteen observations: rows [16][inputs]. `row`
  /// [network.row()] is scratch, and has the answers at network.output(). It also contains the
  /// state of the network, which must be 0 at the start of episodes and unchanged between their
  /// steps.
  void answer(const Kernels& kernels, const float* rows, Simd* row) const;
};

}  // namespace eagerx::train
