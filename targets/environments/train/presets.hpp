// Named settings of options/train_presets.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/client/description.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// Sets the preset's settings that the user has not set (`options.given`), and its algorithm.
/// Throws Problem with kUsage if the name is unknown, or if the user chose another algorithm.
void apply_preset(Options& options);

/// The preset that may suit a graph whose training has not succeeded; empty if there is none.
std::string preset_advice(const Options& options, const client::Description& description,
                          const std::vector<CurvePoint>& curve);

}  // namespace eagerx::train
