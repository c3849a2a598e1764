#include "generator/graph/resolve/chosen_nodes.hpp"

#include <algorithm>
#include <cctype>

namespace eagerx::gen {
namespace {

/// Takes the digits that `text` begins with; false if there are none.
bool take_index(std::string_view& text) {
  const auto end = std::ranges::find_if_not(
      text, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  const auto digits = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(digits);
  return digits > 0;
}

}  // namespace

Called is_called(std::string_view node, std::string_view name) {
  if (name.empty()) return Called::no;
  while (!name.empty()) {
    if (name.front() == '*') {
      if (!take_index(node)) return Called::no;
    } else if (node.empty() || node.front() != name.front()) {
      return Called::no;
    } else {
      node.remove_prefix(1);
    }
    name.remove_prefix(1);
  }
  if (node.starts_with('[')) {  // an element of the array
    node.remove_prefix(1);
    if (!take_index(node) || !node.starts_with(']')) return Called::no;
    node.remove_prefix(1);
  }
  if (node.empty()) return Called::itself;
  return node.front() == '/' ? Called::inside : Called::no;
}

}  // namespace eagerx::gen
