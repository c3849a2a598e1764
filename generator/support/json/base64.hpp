// Base64 (RFC 4648): bytes as text, as JSON, YAML and pages hold them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen {

std::string base64(std::string_view bytes);

/// The bytes of such text, which may be broken into lines; nothing if there is anything else in it.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace eagerx::gen
