#include "generator/command_line/names.hpp"

#include <algorithm>

namespace eagerx::gen {

bool is_option(const Argument& argument) {
  return argument.names.starts_with('-');
}

std::vector<std::string> names_of_option(const Argument& argument) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= argument.names.size();) {
    const std::size_t end = std::min(argument.names.find(',', begin), argument.names.size());
    names.push_back(argument.names.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

}  // namespace eagerx::gen
