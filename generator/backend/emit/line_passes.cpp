#include "generator/backend/emit/line_passes.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "generator/backend/emit/scanner.hpp"

namespace eagerx::gen {
namespace {

struct NextLine {
  std::string_view text;  // without the end
  std::size_t next;       // where the one behind it begins
};

NextLine line_at(std::string_view text, std::size_t begin) {
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  return {text.substr(begin, end - begin), std::min(end + 1, text.size())};
}

/// Whether a line of a class is the head of a function: `T f(U u) const {`.
bool opens_function(std::string_view line, std::size_t indent) {
  constexpr std::array<std::string_view, 7> kOthers = {"if ", "for ", "while ", "switch ",
                                                       "}",   "else", "do "};
  const std::string_view code = line.substr(indent);
  if (indent < 2 || !code.ends_with(" {") || code.find('(') == kNone) return false;
  for (const std::string_view other : kOthers)
    if (code.starts_with(other)) return false;
  int depth = 0;
  for (Scanner scan(line); scan.next();) {
    depth = scan.depth();
    if (depth < 0) return false;  // the rest of a head
  }
  return depth == 1;
}

/// Headers of which templates do not know whether they are needed, and names of what is in them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kNamesOf = {
    {{"<array>", "std::array"},
     {"<cstddef>", "std::size_t"},
     {"<cstdint>", "std::int"},
     {"<cstdint>", "std::uint"},
     {"<limits>", "std::numeric_limits"},
     {"<optional>", "std::optional"},
     {"<optional>", "std::nullopt"},
     {"<eagerx/delay.hpp>", "DelayQuanta"},
     {"<eagerx/sample.hpp>", "eagerx::sample_"},
     {"<eagerx/cursor.hpp>", "DelayCursor"},
     {"<eagerx/cursor.hpp>", "SkipCursor"},
     {"<eagerx/cursor.hpp>", "NewMessages"},
     {"<eagerx/cursor.hpp>", "eagerx::Received"}}};

bool is_needed(std::string_view include, std::string_view text) {
  bool known = false;
  for (const auto& [header, name] : kNamesOf) {
    if (include.find(header) == kNone) continue;
    known = true;
    if (text.find(name) != kNone) return true;
  }
  return !known;
}

}  // namespace

std::size_t sort_includes(std::string_view text, std::size_t begin, std::string& result) {
  std::vector<std::string_view> angled, quoted;
  std::size_t end = begin;
  for (std::size_t at = begin; at < text.size();) {
    const std::size_t next = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, next - at);
    const bool is_include = line.starts_with("#include ");
    if (!is_include && line != "\n") break;
    if (line.ends_with(".h>\n") || line.ends_with(".h\"\n")) return begin;
    at = next;
    if (!is_include) continue;
    end = next;
    if (!is_needed(line, text)) continue;
    (line.starts_with("#include <") ? angled : quoted).push_back(line);
  }
  for (auto* lines : {&angled, &quoted}) {
    std::ranges::sort(*lines);
    // Clang 14 does not know std::ranges::unique of libstdc++ 12.
    lines->erase(std::unique(lines->begin(), lines->end()), lines->end());
    if (lines == &quoted && !angled.empty() && !quoted.empty()) result += '\n';
    for (const auto& line : *lines) result += line;
  }
  return end;
}

std::string with_aligned_comments(std::string_view text) {
  struct Line {
    std::string_view code, comment;
  };
  std::string result;
  std::vector<Line> lines;
  std::size_t code = 0, comment = 0;  // the longest
  bool on = true;
  const auto flush = [&] {
    for (const auto& line : lines) {
      result += line.code;
      result += std::string(code - columns_of(line.code), ' ');
      result += line.comment;
    }
    lines.clear();
    code = comment = 0;
  };
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view line = text.substr(begin, end - begin);
    begin = end;
    if (line.ends_with("// clang-format off\n")) on = false;
    if (line.ends_with("// clang-format on\n")) on = true;
    const bool is_code =
        on && !line.substr(std::min(line.find_first_not_of(' '), line.size())).starts_with("//");
    const std::size_t at = is_code && line.size() < 2 * kColumns ? find_comment(line) : kNone;
    if (at == kNone) {
      flush();
      result += line;
      continue;
    }
    const Line split{line.substr(0, at), line.substr(at)};
    const std::size_t longest_code = std::max(code, columns_of(split.code));
    const std::size_t longest_comment = std::max(comment, columns_of(split.comment) - 1);
    if (longest_code + longest_comment > kColumns) flush();
    code = std::max(code, columns_of(split.code));
    comment = std::max(comment, columns_of(split.comment) - 1);
    lines.push_back(split);
  }
  flush();
  return result;
}

std::string with_short_functions(std::string_view text) {
  std::string result;
  std::string_view before;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto [head, second] = line_at(text, begin);
    const std::size_t indent = std::min(head.find_first_not_of(' '), head.size());
    const bool is_template =
        before.substr(std::min(indent, before.size())).starts_with("template <");
    before = head;
    if (!opens_function(head, indent)) {
      result += text.substr(begin, second - begin);
      begin = second;
      continue;
    }
    const std::string in(indent, ' ');
    const auto [body, third] = line_at(text, second);
    const auto [end, behind] = line_at(text, third);
    const std::string_view statement = body.substr(std::min(indent + 2, body.size()));
    if (body == in + "}") {
      result += std::string(head) + "}\n";
      begin = third;
    } else if (!is_template && end == in + "}" && body.starts_with(in + "  ") &&
               statement.ends_with(';') && !statement.starts_with(' ') &&
               columns_of(head) + columns_of(statement) + 3 <= kColumns) {
      result += std::string(head) + ' ' + std::string(statement) + " }\n";
      begin = behind;
    } else {
      result += text.substr(begin, second - begin);
      begin = second;
    }
  }
  return result;
}

}  // namespace eagerx::gen
