// Positions as LSP counts them: lines and UTF-16 code units from 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen::lsp {

struct Position {
  std::uint32_t line = 0, character = 0;
};

/// The byte at a position. Positions after the end of a line give that end; positions after the
/// last line give the end of the text.
std::size_t byte_at(std::string_view text, Position position);
Position position_at(std::string_view text, std::size_t byte);

/// The same for many places of one text, whose lines are counted once.
class Lines {
 public:
  explicit Lines(std::string_view text);
  [[nodiscard]] Position position(std::size_t byte) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> starts_ = {0};
};

}  // namespace eagerx::gen::lsp
