// Messages of compilers. Inside compile/ only.
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
  /// Where functions were called that the compiler put in their callers, the innermost one first.
  struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0;
  };
  std::vector<Place> inlined_at = {};
};
std::vector<CompilerMessage> messages_in(std::string_view output);
/// "gain.hpp:12:5:   required from …": the code that instantiated the template with the error,
/// nearest first.
std::vector<CompilerMessage> instantiations_in(std::string_view output);

}  // namespace eagerx::gen
