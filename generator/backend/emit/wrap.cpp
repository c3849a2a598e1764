#include "generator/backend/emit/wrap.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

namespace eagerx::gen {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kNone = std::string_view::npos;

/// In letters: names in comments may have any.
std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

/// Walks through code: where brackets are open, and what is inside of a literal.
class Scanner {
 public:
  explicit Scanner(std::string_view line) : line_(line) {}

  /// Takes the next character; false at the end.
  bool next() {
    if (at_ + 1 >= line_.size() && started_) return false;
    if (started_) ++at_;
    started_ = true;
    if (at_ >= line_.size()) return false;
    const char c = line_[at_];
    if (quote_ != '\0') {
      if (c == '\\')
        ++at_;
      else if (c == quote_)
        quote_ = '\0';
      return true;
    }
    const char before = at_ > 0 ? line_[at_ - 1] : ' ';
    const bool digit_separator = std::isalnum(static_cast<unsigned char>(before)) != 0;
    if (c == '"' || (c == '\'' && !digit_separator)) quote_ = c;
    if (c == '(' || c == '[' || c == '{' || opens_template(c, before)) ++depth_;
    if (c == ')' || c == ']' || c == '}' || (c == '>' && before != '-' && before != ' ')) --depth_;
    return true;
  }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] bool in_literal() const { return quote_ != '\0'; }

 private:
  static bool opens_template(char c, char before) {
    return c == '<' && (std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '_');
  }

  std::string_view line_;
  std::size_t at_ = 0;
  int depth_ = 0;
  char quote_ = '\0';
  bool started_ = false;
};

/// Where the comment behind code begins, with the blanks before it.
std::size_t find_comment(std::string_view line) {
  for (Scanner scan(line); scan.next();) {
    if (!scan.in_literal() && line.substr(scan.at()).starts_with("  // ")) return scan.at();
  }
  return kNone;
}

struct Break {
  std::size_t at = kNone;  // what follows goes to the next line
  std::size_t indent = 0;
  bool continues = true;  // the same statement
};

/// Whether a line may end behind the two characters at `at`: `, `, `= `, `& ` or `| `, where they
/// are no comparison and no bits.
bool ends_line(std::string_view line, std::size_t at) {
  const char before = line[at - 1];
  if (line[at + 1] != ' ') return false;
  switch (line[at]) {
    case ',':
      return true;
    case '=':
      // An initializer breaks behind its brace.
      return before != '=' && before != '!' && before != '<' && before != '>' &&
             line.substr(at + 1, 2) != " {";
    case '&':
    case '|':
      return before == line[at];
    default:
      return false;
  }
}

/// The last place with the fewest brackets open, behind a comma, `=`, `&&`, `||`, `{` or the
/// condition of an `if`. `continued`: the line is the rest of one that was broken.
Break find_break(std::string_view line, std::size_t indent, bool continued) {
  const std::size_t deeper = indent + (continued ? 0 : 4);
  constexpr std::size_t kBody = 2;
  Break best;
  int least = std::numeric_limits<int>::max();
  const bool is_if = !continued && line.substr(indent).starts_with("if (");
  for (Scanner scan(line); scan.next() && scan.at() < kColumns;) {
    const std::size_t at = scan.at();
    if (scan.in_literal() || at <= indent || at + 2 >= line.size()) continue;
    const std::string_view rest = line.substr(at);
    const bool ends_condition =
        is_if && scan.depth() == 0 && rest.starts_with(") ") && line[at + 2] != '{';
    if ((ends_condition || ends_line(line, at)) && scan.depth() <= least) {
      least = scan.depth();
      best = {at + 2, ends_condition ? indent + kBody : deeper, !ends_condition};
    } else if (line[at] == '{' && line[at + 1] != '}' && scan.depth() - 1 < least) {
      least = scan.depth() - 1;
      best = {at + 1, deeper};
    }
  }
  return best;
}

std::string wrapped_comment(std::string_view line, std::size_t indent) {
  const std::string_view text = line.substr(indent);
  const std::string mark = std::string(line.substr(0, indent)) +
                           std::string(text.substr(0, text.find_first_not_of('/'))) + " ";
  std::string result;
  std::string rest(line);
  while (columns_of(rest) > kColumns) {
    const std::size_t blank = rest.rfind(' ', kColumns);
    if (blank == kNone || blank < mark.size()) break;
    result += rest.substr(0, blank) + "\n";
    rest.replace(0, blank + 1, mark);
  }
  return result + rest;
}

/// Only the beginning of a line is looked at: some have a million numbers.
std::string wrapped_code(std::string_view line, std::size_t indent) {
  constexpr std::size_t kSeen = 4 * kColumns;
  std::string result;
  std::string_view rest = line.substr(indent);
  for (bool continued = false;;) {
    const std::string begin = std::string(indent, ' ') + std::string(rest.substr(0, kSeen));
    const Break place =
        columns_of(begin) > kColumns ? find_break(begin, indent, continued) : Break{};
    if (place.at == kNone) return result + std::string(indent, ' ') + std::string(rest);
    const std::string_view head = std::string_view(begin).substr(0, place.at);
    result += head.substr(0, head.find_last_not_of(' ') + 1);
    result += '\n';
    rest.remove_prefix(place.at - indent);
    indent = place.indent;
    continued = place.continues;
  }
}

std::string wrapped_line(std::string_view line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  if (columns_of(line) <= kColumns || line.substr(indent).starts_with('#'))
    return std::string(line);
  if (line.substr(indent).starts_with("//")) return wrapped_comment(line, indent);
  if (const std::size_t comment = find_comment(line); comment != kNone) {
    const std::string above = std::string(indent, ' ') + std::string(line.substr(comment + 2));
    return wrapped_line(above) + "\n" + wrapped_line(line.substr(0, comment));
  }
  return wrapped_code(line, indent);
}

}  // namespace

std::string wrapped(std::string_view text) {
  std::string result;
  bool on = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with("// clang-format off")) on = false;
    if (line.ends_with("// clang-format on")) on = true;
    result += on ? wrapped_line(line) : std::string(line);
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

}  // namespace eagerx::gen
