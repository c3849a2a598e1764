// Memory of a recurrent network for each environment.
#pragma once

#include <algorithm>
#include <vector>

#include "targets/environments/train/network.hpp"

namespace eagerx::train {

/// States of some tiles of environments; none for a network without memory.
class States {
 public:
  States(std::size_t tiles, CellShape shape) : width_(shape.state()), simds_(tiles * width_) {}

  void clear() { std::fill(simds_.begin(), simds_.end(), Simd{}); }
  /// An episode begins.
  void forget(std::size_t environment) {
    Simd* state = of(environment / kLanes);
    for (std::size_t i = 0; i < width_; ++i) state[i].lane[environment % kLanes] = 0.0F;
  }

  /// Puts that of a tile into a row, before the step.
  void load(const Network& network, std::size_t tile, Simd* row) const {
    if (width_ > 0) std::copy_n(of(tile), width_, row + network.memory()->before());
  }
  /// Takes it from a row, after the step.
  void keep(const Network& network, std::size_t tile, const Simd* row) {
    if (width_ > 0) std::copy_n(row + network.memory()->after(), width_, of(tile));
  }

  std::size_t width() const { return width_; }
  /// Of one environment, into a lane of `to` [state].
  void copy(std::size_t environment, Simd* to, std::size_t lane) const {
    const Simd* state = of(environment / kLanes);
    for (std::size_t i = 0; i < width_; ++i) to[i].lane[lane] = state[i].lane[environment % kLanes];
  }
  /// Appends all numbers.
  void save(std::vector<float>& to) const {
    for (const Simd& simd : simds_) to.insert(to.end(), simd.lane, simd.lane + kLanes);
  }
  /// Restores the states. Returns a pointer past them.
  const float* restore(const float* from) {
    for (Simd& simd : simds_) {
      std::copy_n(from, kLanes, simd.lane);
      from += kLanes;
    }
    return from;
  }

 private:
  Simd* of(std::size_t tile) { return simds_.data() + tile * width_; }
  const Simd* of(std::size_t tile) const { return simds_.data() + tile * width_; }

  std::size_t width_;  // numbers of a state
  Simds simds_;
};

/// Begins a row with the previous state if `continues` is 1, or with zeros if it is 0.
inline void recall(const Network& network, const Simd& continues, const Simd* state, Simd* row) {
  const Cell& cell = *network.memory();
  for (std::size_t i = 0; i < cell.shape().state(); ++i) {
    for (std::size_t l = 0; l < kLanes; ++l)
      row[cell.before() + i].lane[l] = state[i].lane[l] * continues.lane[l];
  }
}

}  // namespace eagerx::train
