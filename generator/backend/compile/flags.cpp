#include "generator/backend/compile/flags.hpp"

namespace eagerx::gen {

std::string compiler_id(std::string_view version) {
  if (version.find("clang version") != std::string_view::npos) return "Clang";
  if (version.find("Free Software Foundation") != std::string_view::npos) return "GNU";
  return {};
}

std::vector<std::string> runtime_flags(std::istream& list, std::string_view compiler_id) {
  constexpr std::string_view kSeparator = ": ";
  std::vector<std::string> flags;
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t colon = line.find(kSeparator);
    if (colon == std::string::npos)
      flags.push_back(line);
    else if (compiler_id == line.substr(0, colon))
      flags.push_back(line.substr(colon + kSeparator.size()));
  }
  return flags;
}

}  // namespace eagerx::gen
