// Positions as LSP counts them: lines and UTF-16 code units from 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::gen::lsp {

struct Position {
  std::uint32_t line = 0, character = 0;
};

/// The byte at a position. Behind the end of its line: that end; behind the last line: the end.
std::size_t byte_at(std::string_view text, Position position);
Position position_at(std::string_view text, std::size_t byte);

}  // namespace eagerx::gen::lsp
