// The settings of a training and their defaults.
#pragma once

#include <string_view>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// `text`: "layers 64,64; activation tanh; …", as checkpoints, policies and records have it. A list
/// of {name, value, default, about}, of all algorithms and of this one; `default` is null for
/// settings that this eagerx-gen does not know.
Json settings_json(std::string_view text, std::string_view algorithm);

}  // namespace eagerx::gen
