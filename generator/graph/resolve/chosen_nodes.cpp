#include "generator/graph/resolve/chosen_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <runtime/host/base/nearest.hpp>

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

std::string node_meant(const std::string& name, const std::vector<std::string>& known, Span span,
                       Diagnostics& diagnostics) {
  const auto is_called_so = [&](const std::string& wanted) {
    return std::ranges::any_of(
        known, [&](const std::string& node) { return is_called(node, wanted) != Called::no; });
  };
  if (is_called_so(name)) return name;
  std::string meant = name;
  std::ranges::replace(meant, '.', '/');
  if (!is_called_so(meant)) {
    const std::string* const found = host::name_meant(meant, known);
    if (found == nullptr) return name;
    meant = *found;
  }
  diagnostics.note(span, fmt::format("`{}` is `{}` here", name, meant));
  return meant;
}

}  // namespace eagerx::gen
