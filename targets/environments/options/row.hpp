// Options of the programs around a library of environments, as data: a program reads its command
// line with its rows, and the command of eagerx-gen that starts it uses the same rows.
#pragma once

#include <cstdint>

namespace eagerx::options {

/// The program's use of the file, or folder, that the value names.
enum class Use : std::uint8_t { none, reads, writes, folder };

/// For whom an option is.
enum class For : std::uint8_t {
  all,
  program,  // eagerx-gen gives it itself, or has one of its own, or it is for tests
};

struct Row {
  const char* names;  // "--seed", or two, "-o,--output"
  const char* value;  // "N"; empty: an option without a value
  const char* about;
  Use use = Use::none;
  const char* otherwise = "";  // of an output: the file that is written if none is given
  const char* continues = "";  // of an input: the option whose output may be the same file
  bool repeated = false;
  For who = For::all;
  bool ends = false;  // nothing else is looked at, as after --help
};

}  // namespace eagerx::options
