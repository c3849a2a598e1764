// program.map: which lines and members of a generated program.hpp belong to which node. `emit`
// writes it next to program.hpp, and `size` reads it. Only this file knows its format.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The parts that nodes share, listed after them in reports and budgets.
inline constexpr std::array<std::string_view, 7> kSharedParts = {
    "board", "other", "policy", "rings", "runtime", "schedule", "simulators"};

struct ProgramMap {
  /// The lines of a node, from 1, both included.
  struct Block {
    std::uint32_t first = 0, last = 0;
    std::string node;
  };
  /// The owner of a member: a node, or a part of the program that nodes share.
  struct Owner {
    bool is_node = false;
    std::string name;
  };

  /// Where an element of the graph is written.
  struct Place {
    std::uint32_t line = 0, column = 0;
    std::string element;  // `smooth`, `actions.voltage`, `task.reward.upright`
  };

  std::uint64_t program_hash = 0;                   // of the text of program.hpp
  std::map<std::string, std::string> type_of_node;  // `smooth` → `ButterworthFilter`
  std::vector<Block> blocks;                        // in the order of their lines, none in another
  std::map<std::string, Owner> owner_of_member;     // those of the schedule are left out
  std::map<std::string, std::string> shares;  // nodes without lines and members: whose theirs are
  std::string graph_file;                     // of the places; its name alone
  std::vector<Place> places;                  // in the order of the graph

  /// Whose line this is; nullptr if it is no node's.
  [[nodiscard]] const std::string* node_of_line(std::uint32_t line) const;
  [[nodiscard]] Owner owner(const std::string& member) const;
};

std::string to_text(const ProgramMap& map);

/// Reads the text of the file `path`. Problems: E0911, with the line.
std::optional<ProgramMap> parse_program_map(std::string_view text, const std::string& path,
                                            Diagnostics& diagnostics);

}  // namespace eagerx::gen
