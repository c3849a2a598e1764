#include "generator/backend/emit/marks.hpp"

#include <algorithm>

namespace eagerx::gen {
namespace {

// No generated text has these.
constexpr char kBegin = '\x02';
constexpr char kEnd = '\x03';

}  // namespace

std::string begin_mark(const std::string& node) {
  return kBegin + node;
}

std::string end_mark() {
  return {kEnd};
}

MarkedText take_marks(std::string_view text) {
  MarkedText result;
  std::uint32_t lines = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t mark = std::min(line.find_first_not_of(' '), line.size() - 1);
    if (line[mark] == kBegin || line[mark] == kEnd) line.remove_prefix(mark);
    if (line.front() == kBegin) {
      result.blocks.push_back({lines + 1, 0, std::string(line.substr(1, line.size() - 2))});
    } else if (line.front() == kEnd) {
      result.blocks.back().last = lines;
    } else {
      result.text += line;
      ++lines;
    }
  }
  return result;
}

}  // namespace eagerx::gen
