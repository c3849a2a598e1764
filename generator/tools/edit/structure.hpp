// Changes of a graph's structure: objects, nodes, connections, their keys. Each is a splice that
// leaves comments, order, indentation and line ends of everything else alone. Changes work on
// incomplete files, and are rejected if they would not have the intended effect.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tools/edit/edit.hpp"

namespace eagerx::gen {

/// A change of the text, or the reason why it is impossible.
struct Change {
  std::optional<Edit> edit;
  std::string problem = {};  // if there is none
  std::string help = {};
};

/// `value` is YAML on one line: "30", "{low: -1, high: 1}".
struct KeyValue {
  std::string key, value;
};

/// An entry for `objects`, `nodes`, `actions` or `observations`.
struct NewEntry {
  std::string section, name;
  std::string type = {};                  // the id of an object or a node
  std::vector<KeyValue> keys = {};        // in addition to `type`
  std::vector<KeyValue> parameters = {};  // under `config:`
};

/// Whether a text is a single YAML value in any context, also within braces.
bool is_one_value(const std::string& value);

/// Adds an entry after the others of its section, in their style: in braces or on lines.
Change add_entry(std::string_view text, const NewEntry& entry);

/// Replaces the value at `path`, or adds the key, and those above it that are missing.
Change set_value(std::string_view text, const OutlinePath& path, const std::string& value);

/// Takes away a key with its value, or an item of a list; of an object, a node, an action or an
/// observation also its connections, and `render` if it shows a port of it.
Change remove_entry(std::string_view text, const OutlinePath& path);

/// Adds a connection with `keys` in addition to its two ports. Where the owner of a port has a list
/// of its ports, the port is added there, too.
Change connect_ports(std::string_view text, const std::string& from, const std::string& to,
                     const std::vector<KeyValue>& keys);

/// Gives an object, a node, an action or an observation another name, wherever the graph has it.
Change rename_entry(std::string_view text, const OutlinePath& path, const std::string& name);

/// The edit from `before` to `after`: one splice, as small as it can be.
Edit difference(std::string reason, std::string_view before, std::string_view after);

}  // namespace eagerx::gen
