#include "generator/analysis/size/pattern.hpp"

#include <cstdlib>

namespace eagerx::gen {

Pattern::Pattern(const char* expression) {
  if (regcomp(&compiled_, expression, REG_EXTENDED) != 0) std::abort();
}

std::vector<std::string> Pattern::groups(const std::string& text) const {
  std::vector<regmatch_t> places(compiled_.re_nsub + 1);
  if (regexec(&compiled_, text.c_str(), places.size(), places.data(), 0) != 0) return {};
  std::vector<std::string> found;
  found.reserve(places.size());
  for (const auto& [from, to] : places)
    found.push_back(from < 0 ? std::string()
                             : text.substr(std::size_t(from), std::size_t(to - from)));
  return found;
}

}  // namespace eagerx::gen
