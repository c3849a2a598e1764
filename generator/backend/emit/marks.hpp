// Marks in a rendered template that assign its lines to nodes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/backend/program_map/program_map.hpp"

namespace eagerx::gen {

/// Separate lines before the first and after the last line of a node.
std::string begin_mark(const std::string& node);
std::string end_mark();

struct MarkedText {
  std::string text;  // without the marks
  std::vector<ProgramMap::Block> blocks;
};
/// Takes the marks out again. None may be open when another begins.
MarkedText take_marks(std::string_view text);

}  // namespace eagerx::gen
