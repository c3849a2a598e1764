// What compilers say. Inside compile/ only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// A line that compilers write: "gain.hpp:12:5: error: text [-Wname]".
struct CompilerMessage {
  std::string file;
  std::uint32_t line = 0, column = 0;
  bool error = false;
  std::string text;
};
std::vector<CompilerMessage> messages_in(std::string_view output);

}  // namespace eagerx::gen
