// Compares two logs of a program message by message.
#pragma once

#include <string>

namespace eagerx::gen {

struct Comparison {
  std::string text;       // what came out, in lines
  bool readable = false;  // false: one cannot be read, or they are not of the same messages
  bool equal = false;
};

/// Compares the logs in these files: the channels that both have, in the order of the second file.
Comparison compare_logs(const std::string& first, const std::string& second);

}  // namespace eagerx::gen
