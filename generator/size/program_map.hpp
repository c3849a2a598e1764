// Which lines and members of a generated program.hpp belong to which node.
#pragma once

#include <map>
#include <string>

namespace eagerx::gen {

struct ProgramMap {
  std::map<int, std::string> node_of_line;
  std::map<std::string, std::string> node_of_member;  // `smooth_` → `smooth`
  std::map<std::string, std::string> type_of_node;    // `smooth` → `ButterworthFilter`
  std::map<std::string, bool> is_ring;                // members in the block of messages

  /// The owner of a member: a node, `rings`, `simulators` or `schedule`.
  [[nodiscard]] std::string owner_of_member(const std::string& member) const;
};

/// Reads a program.hpp as eagerx-gen writes it: `// name: Type, file:line:column` before the block
/// of a node. Empty if there is no such file.
ProgramMap read_program_map(const std::string& path);

}  // namespace eagerx::gen
