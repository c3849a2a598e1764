// Registers the files that a run reads and writes, so that no output ever overwrites an input or
// another output. Readers register inputs here, the table of commands registers outputs, and
// driver/build/write, the only place that opens outputs, checks before it opens one.
//
// One list for the process: a command line is one run, and a reader far from the commands cannot
// be forgotten by a new one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

/// Registers that `path` is read. `name`: its name in messages (default: the path).
void remember_input(const std::string& path, const std::string& name = {});

/// Remembers that `path` is going to be written, whether by this program or by one that it becomes.
void remember_output(const std::string& path, const std::string& name);

/// Two names of one file: an output, and an input or another output.
struct OneFile {
  std::string output, other;
};

/// The first remembered output that is an input or another output, by any name or link, or one of
/// `written`: files that are about to be written. Nothing: all are different.
std::optional<OneFile> find_one_file(const std::vector<std::string>& written = {});

/// The name in messages of the input at `path`, by any name or link; nullopt if it is not an input.
std::optional<std::string> input_at(const std::string& path);

/// Forgets all of it: a test is many runs.
void forget_files();

}  // namespace eagerx::gen
