// What an object file calls that no board has. Inside compile/ only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// A call that may not be, and the lines that led to it: the innermost first.
struct ForbiddenCall {
  struct Place {
    std::string file;
    std::uint32_t line = 0;
  };
  std::string what;  // "takes memory from a heap (`operator new`)"
  std::string mend;
  std::vector<Place> places;
};

/// Of an object file with line numbers; nothing if it or the tools cannot be read.
std::vector<ForbiddenCall> forbidden_calls(const std::string& object);

}  // namespace eagerx::gen
