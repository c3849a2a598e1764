// The summary of a training.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/evaluation.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/spent.hpp"

namespace eagerx::train {

enum class Ending : std::uint8_t { success, steps, interrupted };

struct Ended {
  const Options& options;
  const Description& description;
  const std::vector<CurvePoint>& curve;
  const char* kernels;
  std::uint64_t steps = 0;
  double seconds = 0.0;
  double evaluating_seconds = 0.0;  // of `seconds`
  Spent spent;
  Done done;
  unsigned threads = 1;
  Ending ending{};
  bool has_aim = false;  // something says when a policy is good
};

/// Lines for people. `evaluation`: of the policy that is written.
std::string summary(const Ended& ended, const Evaluation& evaluation);

}  // namespace eagerx::train
