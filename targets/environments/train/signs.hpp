// Diagnoses why a training does not succeed, in words.
#pragma once

#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/evaluation.hpp"

namespace eagerx::train {

/// The symptoms in `curve` and in the last evaluation, the most telling first; empty: none.
std::vector<std::string> signs_of(const std::vector<CurvePoint>& curve,
                                  const Evaluation& evaluation, const Description& description);

}  // namespace eagerx::train
