// Folding ranges.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/outline.hpp"

namespace eagerx::gen::lsp {

/// Lines from 0, both ends in it.
struct Fold {
  std::uint32_t first = 0, last = 0;
  bool is_comment = false;
};

/// Keys and items of several lines, and comments of several lines.
std::vector<Fold> folds_of(std::string_view text);

}  // namespace eagerx::gen::lsp
