// Named settings of options/train_presets.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/client/description.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// Sets what the preset of this name sets and the user has not (`options.given`), and its
/// algorithm. Throws Problem with kUsage if there is none, or the user chose another algorithm.
void apply_preset(Options& options);

/// Which preset may suit a graph whose training has not succeeded; empty: nothing says so.
std::string preset_advice(const Options& options, const client::Description& description,
                          const std::vector<CurvePoint>& curve);

}  // namespace eagerx::train
