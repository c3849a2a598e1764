// Values of manifests that `check` has accepted.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {

/// The text under a key; empty without the key.
std::string text_at(const YamlValue& yaml, const char* key);
/// Those of a list.
std::vector<std::string> texts_at(const YamlValue& yaml, const char* key);
/// `mine::Gain`, which generated code contains unchanged: E0205 if it is not the name of a class.
void check_class(const YamlValue& name, Diagnostics& diagnostics);

}  // namespace eagerx::gen
