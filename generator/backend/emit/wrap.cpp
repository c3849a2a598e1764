#include "generator/backend/emit/wrap.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "generator/backend/emit/line_passes.hpp"
#include "generator/backend/emit/scanner.hpp"
#include "generator/backend/emit/wrap_braces.hpp"
#include "generator/backend/emit/wrap_expression.hpp"

namespace eagerx::gen {
namespace {

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
  constexpr std::string_view kReturn = "return ";  // conditions are aligned behind it
  const bool is_return = !continued && line.substr(indent).starts_with(kReturn);
  for (Scanner scan(line); scan.next() && scan.at() < kColumns;) {
    const std::size_t at = scan.at();
    if (scan.in_literal() || at <= indent || at + 2 >= line.size()) continue;
    const std::string_view rest = line.substr(at);
    const bool ends_condition =
        is_if && scan.depth() == 0 && rest.starts_with(") ") && line[at + 2] != '{';
    if ((ends_condition || ends_line(line, at)) && scan.depth() <= least) {
      least = scan.depth();
      const bool aligned = is_return && scan.depth() == 0 && line[at] != ',' && line[at] != '=';
      best = {at + 2,
              ends_condition ? indent + kBody
              : aligned      ? indent + kReturn.size()
                             : deeper,
              !ends_condition};
    } else if (line[at] == '{' && line[at + 1] != '}' && scan.depth() - 1 < least) {
      least = scan.depth() - 1;
      best = {at + 1, deeper};
    }
  }
  return best;
}

/// The mark of a comment line and the blank behind it; empty if it is none, or is indented text.
std::string_view comment_mark(std::string_view line) {
  const std::size_t indent = line.find_first_not_of(' ');
  if (indent == kNone || !line.substr(indent).starts_with("//")) return {};
  const std::size_t text = line.find_first_not_of('/', indent);
  if (text == kNone || line[text] != ' ' || text + 1 >= line.size() || line[text + 1] == ' ')
    return {};
  return line.substr(0, text + 1);
}

/// Breaks a comment between words; the last of its lines.
std::string wrapped_comment(std::string_view line, std::size_t indent, std::string& last) {
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
  last = rest;
  return result;
}

std::string wrapped_comment(std::string_view line, std::size_t indent) {
  std::string last;
  const std::string begin = wrapped_comment(line, indent, last);
  return begin + last;
}

/// The `(` or `<` that the comma before `at` is in; none if it is in another bracket.
std::optional<std::size_t> call_around(std::string_view line, std::size_t at) {
  std::vector<std::size_t> open;
  int depth = 0;
  for (Scanner scan(line); scan.next() && scan.at() < at;) {
    if (scan.depth() > depth) open.push_back(scan.at());
    if (scan.depth() < depth) open.pop_back();
    depth = scan.depth();
  }
  if (open.empty() || (line[open.back()] != '(' && line[open.back()] != '<')) return std::nullopt;
  return open.back();
}

/// Breaks the rest of a statement that is one text, between its words.
std::string wrapped_text(std::string line, std::size_t indent) {
  if (line[indent] != '"' || !line.ends_with("\";") ||
      line.find('"', indent + 1) != line.size() - 2)
    return line;
  std::string result;
  while (columns_of(line) > kColumns) {
    const std::size_t blank = line.rfind(' ', kColumns - 2);
    if (blank <= indent) break;
    result += line.substr(0, blank + 1) + "\"\n";
    line.replace(0, blank + 1, std::string(indent, ' ') + '"');
  }
  return result + line;
}

/// `a ? b : c;`, the rest of a statement, with the choices in lines of their own; empty if it is
/// something else.
std::string wrapped_choice(std::string_view line, std::size_t indent) {
  std::size_t question = kNone, colon = kNone;
  for (Scanner scan(line); scan.next();) {
    if (scan.in_literal() || scan.depth() != 0) continue;
    const std::string_view rest = line.substr(scan.at());
    if (rest.starts_with(" ? ")) question = scan.at();
    if (rest.starts_with(" : ")) colon = scan.at();
  }
  if (question == kNone || colon == kNone || colon < question ||
      columns_of(line.substr(0, question)) > kColumns)
    return {};
  const std::string deeper = '\n' + std::string(indent + 4, ' ');
  return std::string(line.substr(0, question)) + deeper +
         std::string(line.substr(question + 1, colon - question - 1)) + deeper +
         std::string(line.substr(colon + 1));
}

/// Only the beginning of a long line is looked at: some have a million numbers.
std::string wrapped_code(std::string_view line, std::size_t indent) {
  constexpr std::size_t kLong = 20 * kColumns;
  const std::size_t seen = line.size() < kLong ? kLong : 4 * kColumns;
  if (indent < line.size() && line[indent] == '{' && line.size() < seen) {
    const auto braces = braces_at(line.substr(indent), 0);
    if (braces && !braces->elements.empty() && braces->tail.find('{') == kNone)
      return wrapped_braces(*braces, indent, indent + 4);
  }
  std::string result;
  std::string_view rest = line.substr(indent);
  for (bool continued = false;;) {
    const std::string begin = std::string(indent, ' ') + std::string(rest.substr(0, seen));
    const bool is_long = columns_of(begin) > kColumns;
    const std::string choice = is_long && continued ? wrapped_choice(begin, indent) : std::string();
    if (!choice.empty()) return result + choice;
    const Break place = is_long ? find_break(begin, indent, continued) : Break{};
    if (place.at == kNone) {
      std::size_t call = kNone;
      for (Scanner scan(begin); call == kNone && scan.next();)
        if (!scan.in_literal() && begin[scan.at()] == '(') call = scan.at();
      const bool fits = call != kNone && call < kColumns && rest.size() < seen &&
                        indent + 4 + columns_of(begin.substr(call + 1)) <= kColumns;
      if (columns_of(begin) <= kColumns || !fits)
        return result + wrapped_text(std::string(indent, ' ') + std::string(rest), indent);
      return result + begin.substr(0, call + 1) + '\n' + std::string(indent + 4, ' ') +
             begin.substr(call + 1);
    }
    if (begin[place.at - 1] == '{' && rest.size() < seen) {
      const auto call = call_around(begin, place.at - 1);
      if (call && !continued && begin[*call] == '(' &&
          indent + 4 + columns_of(rest.substr(*call + 1 - indent)) <= kColumns) {
        return result + begin.substr(0, *call + 1) + '\n' + std::string(indent + 4, ' ') +
               begin.substr(*call + 1);
      }
      const auto braces = braces_at(rest, place.at - 1 - indent);
      if (braces && !braces->elements.empty())
        return result + wrapped_braces(*braces, indent, place.indent);
    }
    const auto call = !continued && begin[place.at - 2] == ',' && rest.size() < seen
                          ? call_around(begin, place.at - 1)
                          : std::nullopt;
    if (call && begin[*call] == '<') {  // not inside of `<>`, if the arguments around it fit below
      const std::size_t around = begin.find('(');
      if (around < *call && indent + 4 + columns_of(rest.substr(around + 1 - indent)) <= kColumns)
        return result + begin.substr(0, around + 1) + '\n' + std::string(indent + 4, ' ') +
               std::string(rest.substr(around + 1 - indent));
    }
    if (call) {
      const auto arguments = braces_at(rest, *call - indent);
      if (arguments && rest.starts_with("if (") && !all_fit(*arguments, *call + 1)) {
        constexpr std::size_t kInCondition = 8;
        const std::size_t below = indent + kInCondition;
        const std::string lines = in_lines(*arguments, below, false);
        if (!lines.empty())
          return result + std::string(indent, ' ') + std::string(arguments->head) + '\n' +
                 std::string(below, ' ') + lines;
      }
      const std::string lines = arguments ? in_lines(*arguments, *call + 1, false) : std::string();
      if (!lines.empty())
        return result + std::string(indent, ' ') + std::string(arguments->head) + lines;
    }
    const std::string_view head = std::string_view(begin).substr(0, place.at);
    result += head.substr(0, head.find_last_not_of(' ') + 1);
    result += '\n';
    rest.remove_prefix(place.at - indent);
    indent = place.indent;
    continued = place.continues;
  }
}

/// `= { x };` and `T<U>{ x }` without blanks inside of the braces: templates need them, for `{{{`
/// is mustache's.
std::string without_blanks(std::string_view line) {
  std::vector<std::size_t> blanks;
  std::vector<int> open;  // depths outside of such braces
  int depth = 0;
  for (Scanner scan(line); scan.next(); depth = scan.depth()) {
    const std::size_t at = scan.at();
    if (scan.in_literal() || at < 2) continue;
    if (line[at] == '{' && line.substr(at + 1).starts_with(' ') &&
        (line.substr(at - 2, 2) == "= " || line[at - 1] == '>')) {
      open.push_back(depth);
      blanks.push_back(at + 1);
    } else if (line[at] == '}' && !open.empty() && scan.depth() == open.back()) {
      open.pop_back();
      if (line[at - 1] == ' ') blanks.push_back(at - 1);
    }
  }
  std::string result(line);
  for (auto blank = blanks.rbegin(); blank != blanks.rend(); ++blank) result.erase(*blank, 1);
  return result;
}

/// `{a, b}, {c, d},`: one group a line.
std::string wrapped_groups(std::string_view line, std::size_t indent) {
  std::string result;
  std::size_t begin = indent;
  for (Scanner scan(line); scan.next();) {
    const std::size_t at = scan.at();
    if (scan.in_literal() || scan.depth() != 0 || !line.substr(at).starts_with(", {")) continue;
    result += std::string(indent, ' ') + std::string(line.substr(begin, at + 1 - begin)) + '\n';
    begin = at + 2;
  }
  return result + std::string(indent, ' ') + std::string(line.substr(begin));
}

std::string wrapped_line(std::string_view line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  constexpr std::size_t kGroups = 8 * kColumns;
  if (line.size() < kGroups && line.substr(indent).starts_with('{') && line.find("}, {") != kNone) {
    const std::string groups = wrapped_groups(line, indent);
    if (groups.find('\n') != kNone) {
      std::string result;
      for (std::size_t at = 0; at <= groups.size();) {
        const std::size_t end = std::min(groups.find('\n', at), groups.size());
        result += (at == 0 ? "" : "\n") + wrapped_line(groups.substr(at, end - at));
        at = end + 1;
      }
      return result;
    }
  }
  if (columns_of(line) <= kColumns || line.substr(indent).starts_with('#'))
    return std::string(line);
  if (line.substr(indent).starts_with("//")) return wrapped_comment(line, indent);
  if (const std::size_t comment = find_comment(line); comment != kNone) {
    const std::string above = std::string(indent, ' ') + std::string(line.substr(comment + 2));
    return wrapped_line(above) + "\n" + wrapped_line(line.substr(0, comment));
  }
  constexpr std::string_view kReturns = " { return ", kEndOfBody = "; }";
  const std::size_t body = line.find(kReturns);
  if (body != kNone && line.ends_with(kEndOfBody)) {
    const std::string in(indent, ' ');
    const std::size_t from = body + kReturns.size() - std::string_view("return ").size();
    return wrapped_line(line.substr(0, body + 2)) + "\n" +
           wrapped_line(in + "  " + std::string(line.substr(from, line.size() - 2 - from))) + "\n" +
           in + "}";
  }
  std::string result = wrapped_code(line, indent);
  const std::size_t first = result.find('\n'), last = result.rfind('\n');
  const bool behind_operator =
      first != kNone && first > 0 && std::string_view("|&").find(result[first - 1]) != kNone;
  const bool is_good = first == last && !behind_operator;
  if (is_good && columns_of(result.substr(last == kNone ? 0 : last + 1)) <= kColumns) return result;
  std::string assignment = wrapped_assignment(line, indent);
  return assignment.empty() ? result : assignment;
}

/// Whether a blank line behind `text` is one too many, or begins a block.
bool is_needless_blank(std::string_view text) {
  if (text.ends_with("\n\n")) return true;
  if (!text.ends_with(" {\n")) return false;
  const std::string_view line = text.substr(text.rfind('\n', text.size() - 2) + 1);
  return !line.starts_with("namespace ");
}

/// Whether a blank line before it is one too many.
bool closes_block(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin != kNone && line[begin] == '}' && line.find("// namespace") == kNone;
}

}  // namespace

std::string wrapped(std::string_view text) {
  std::string result;
  std::string carried;  // the rest of a comment, which continues on the next line
  bool on = true;
  for (std::size_t begin = 0; begin < text.size();) {
    if (on && text.substr(begin).starts_with("#include ")) {
      const std::size_t behind = sort_includes(text, begin, result);
      if (behind > begin) {
        begin = behind;
        continue;
      }
    }
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string joined;
    std::string_view line = text.substr(begin, end - begin);
    if (!carried.empty()) {
      joined = carried + ' ' + std::string(line.substr(comment_mark(line).size()));
      line = joined;
      carried.clear();
    }
    if (line.ends_with("// clang-format off")) on = false;
    if (line.ends_with("// clang-format on")) on = true;
    const std::string_view rest = text.substr(std::min(end + 1, text.size()));
    const std::string_view next = rest.substr(0, rest.find('\n'));
    const std::string_view mark = comment_mark(line);
    if (on && columns_of(line) > kColumns && !mark.empty() && mark == comment_mark(next)) {
      result += wrapped_comment(line, line.find('/'), carried);
    } else if (on && line.empty() && (is_needless_blank(result) || closes_block(next))) {
      // Templates leave out what is before or behind it.
    } else {
      const bool is_code = on && line.find("{ ") != kNone && !line.ends_with('}');
      result += is_code ? wrapped_line(without_blanks(line))
                : on    ? wrapped_line(line)
                        : std::string(line);
      if (end < text.size()) result += '\n';
    }
    begin = end + 1;
  }
  return with_aligned_comments(with_short_functions(result));
}

}  // namespace eagerx::gen
