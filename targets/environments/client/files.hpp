// Files that are there as a whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::client {

/// Writes `bytes` to another name, then renames it. Throws Problem, and leaves what was there.
void write_file(const std::string& path, std::string_view bytes);

/// Throws Problem if write_file() could not write here. Changes nothing.
void check_writable(const std::string& path);

/// Throws Problem if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace eagerx::client
