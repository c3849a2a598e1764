// Reads telemetry.json, which the generator writes next to a program. Its contents are not trusted.
#pragma once

#include <optional>
#include <runtime/host/telemetry/layout.hpp>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// nullopt: see `problem`, which does not contain the name of the file.
std::optional<telemetry::Layout> read_telemetry_layout(std::string_view text, std::string& problem);

}  // namespace eagerx::gen
