// Files as browsers and editors name them.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::gen {

/// The path of a `file:` URI (RFC 8089), or nothing ("untitled:" and the like have none).
std::string path_of_uri(std::string_view uri);
/// Escapes characters with a meaning in a URI as `%20` and the like.
std::string uri_of_path(std::string_view path);

}  // namespace eagerx::gen
