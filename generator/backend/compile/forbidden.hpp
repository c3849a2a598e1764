// Calls in an object file to functions that no board has, and its static data. Inside compile/
// only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// A call, or a use of a static variable, that may not be, and the lines that led to it: the
/// innermost first.
struct ForbiddenCall {
  struct Place {
    std::string file;
    std::uint32_t line = 0;
  };
  std::string what;  // "takes memory from a heap (`operator new`)"
  std::string fix;
  std::vector<Place> places;
  std::string variable;  // its symbol, or its section where it has none; empty: a call
};

/// Of an object file with line numbers, calls before variables; nothing if it or the tools cannot
/// be read.
std::vector<ForbiddenCall> forbidden_calls(const std::string& object);

}  // namespace eagerx::gen
