// Changes of a graph's structure, on any text: each must change what it says and nothing else, and
// undo must give the bytes back. Input: a byte for the kind of change, a byte for its place, the
// text of a file; or, from a first byte 0xff on, a request of the page and its text: JSON, a zero
// byte, the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "generator/tools/edit/structure.hpp"
#include "generator/tools/serve/edit_request.hpp"
#include "generator/tools/serve/history.hpp"
#include "generator/tools/serve/state_json.hpp"

namespace {

using namespace eagerx::gen;

/// Some place in the outline.
OutlinePath path_in(const OutlineNode& top, unsigned place) {
  OutlinePath path;
  for (const OutlineNode* node = &top; !node->entries.empty();) {
    const std::size_t index = place % node->entries.size();
    if (node->kind == OutlineNode::Kind::map) {
      path.emplace_back(node->entries[index].key);
    } else {
      path.emplace_back(index);
    }
    if (place % 5 == 4) break;
    place /= 2;
    node = &node->entries[index].value;
  }
  return path;
}

Change change_of(std::string_view text, unsigned kind, unsigned place) {
  OutlinePath path = path_in(outline_of(text), place);
  switch (kind % 8) {
    case 0:
      return set_value(text, path, "[1, {a: b}]");
    case 1:
      return remove_entry(text, path);
    case 2:
      return add_entry(text, {"nodes", "fuzzed", "Node", {{"rate", "30"}}, {{"order", "2"}}});
    case 3:
      return add_entry(text, {"observations", "fuzzed"});
    case 4:
      return connect_ports(text, "fuzzed.x", "leg[*].z", {{"window", "2"}});
    case 5:
      return rename_entry(text, path, "fuzzed");
    case 6:
      return add_entry(text, {"actions", "fuzzed", "", {{"space", "{low: 0}"}}});
    default:
      path.emplace_back("fuzzed");
      return set_value(text, path, "7");
  }
}

void check(std::string_view text, const Edit& edit) {
  std::string after = applied(text, edit.splices);
  const Edit whole = difference(edit.reason, text, after);
  if (applied(text, whole.splices) != after) std::abort();
  serve::History history;
  history.add(text, whole);
  if (history.undone(after) != text) std::abort();
  history.step_back();
  if (history.redone(text) != after) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  if (data[0] == 0xff) {
    const std::size_t end = input.find('\0', 1);
    if (end == std::string_view::npos) return 0;
    const auto json = parse_json(input.substr(1, end - 1));
    if (json) serve::edited(input.substr(end + 1), &*json, {});
    return 0;
  }
  const std::string_view text = input.substr(2);
  const Change change = change_of(text, data[0], data[1]);
  if (change.edit) check(text, *change.edit);
  if (!change.edit && change.problem.empty()) std::abort();
  serve::outline_json(text);
  serve::tree_json(text);
  return 0;
}
