// Files that are written completely or not at all, and the standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::client {

/// Writes `bytes` like runtime/host/base/files.hpp. Throws Problem, and then leaves the old file.
void write_file(const std::string& path, std::string_view bytes);

/// The same for files that belong together: renames them only after all are written.
struct NewFile {
  std::string path, bytes;
};
void write_files(const std::vector<NewFile>& files);

/// To the standard output, all of it, now. Throws Problem if that is not possible.
void print(std::string_view text);

/// Throws Problem if write_file() could not write here. Changes nothing.
void check_writable(const std::string& path);

/// The same if another program writes the file. No other one claims it until this process ends.
void claim_output(const std::string& path);

/// Throws Problem if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace eagerx::client
