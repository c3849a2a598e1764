// What a training depends on, besides the library: the same settings give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "targets/environments/train/sac/settings.hpp"

namespace eagerx::train {

/// Of proximal policy optimisation (Schulman et al. 2017), unless SAC has its own.
struct Settings {
  std::string algorithm = "ppo";  // or "sac"
  sac::Settings sac;
  std::uint64_t seed = 1;
  std::vector<std::size_t> hidden = {64, 64};  // widths of the layers, of actor and critic
  float discount = 0.99F;                      // γ
  float trace_decay = 0.95F;                   // λ of generalised advantage estimation
  /// It does not end before the mean return of 100 episodes is this, whatever `success:` says.
  double until_return = -std::numeric_limits<double>::infinity();

  std::size_t environments = 256;  // a multiple of kParts * kLanes
  std::size_t horizon = 32;        // steps of each between two updates
  std::size_t epochs = 4;
  std::size_t minibatches = 8;

  float entropy = 0.01F;          // weight of a choice's entropy; actions have a least deviation
  float clip = 0.2F;              // of the ratio of probabilities
  float divergence = 0.01F;       // Kullback-Leibler; the step size is adapted to keep it
  float first_step_size = 1e-3F;  // of Adam
  float least_step_size = 1e-5F;
  float most_step_size = 3e-3F;
  float least_log_deviation = -1.0F;  // of the actions, whose range is -1…1
  float most_log_deviation = 1.0F;
};

/// A training is cut into so many parts, whatever the number of threads: sums are made within
/// parts, then over them in order.
inline constexpr std::size_t kParts = 8;

}  // namespace eagerx::train
