#include "generator/frontend/read/yaml_error.hpp"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "generator/frontend/read/typos.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

/// A better wording of one of yaml-cpp's messages.
struct Wording {
  std::string_view original;  // begins with
  const char* message;
  const char* label;
  const char* help;
};

namespace Original = YAML::ErrorMsg;

const std::array<Wording, 19> kWordings = {{
    {Original::EOF_IN_SCALAR, "the file ends inside quotes", "", ""},
    {Original::END_OF_MAP_FLOW, "expected `,` or `}` here", "", ""},
    {Original::END_OF_SEQ_FLOW, "expected `,` or `]` here", "", ""},
    {Original::END_OF_MAP, "expected another `key: value` here", "does not fit in",
     "entries of one map begin in the same column, each with a `key:`"},
    {Original::END_OF_SEQ, "expected another `- item` here", "does not fit in",
     "items of one list begin in the same column, each with `- `"},
    {Original::FLOW_END, "this bracket does not match", "", "check the brackets before it"},
    {Original::BLOCK_ENTRY, "a list item cannot begin here", "",
     "begin the list on its own line, or write it as [a, b]"},
    {Original::MAP_KEY, "a key cannot begin here", "", "begin the map on its own line"},
    {Original::CHAR_IN_TAG_HANDLE, "this character cannot be part of a tag", "",
     "put a text that begins with `!` in quotes"},
    {Original::TAG_WITH_NO_SUFFIX, "the tag has no name", "",
     "put a text that begins with `!` in quotes"},
    {Original::END_OF_VERBATIM_TAG, "the tag is not closed with `>`", "", ""},
    {Original::MULTIPLE_TAGS, "a second tag for the same value", "", "remove one of them"},
    {Original::MULTIPLE_ANCHORS, "a second anchor for the same value", "", "remove one of them"},
    {Original::ALIAS_NOT_FOUND, "a name is missing after `*`", "",
     "put a text that begins with `*` in quotes"},
    {Original::ANCHOR_NOT_FOUND, "a name is missing after `&`", "",
     "put a text that begins with `&` in quotes"},
    {Original::CHAR_IN_ALIAS, "this character cannot be part of an alias", "", ""},
    {Original::CHAR_IN_ANCHOR, "this character cannot be part of an anchor", "", ""},
    {Original::ZERO_INDENT_IN_BLOCK, "a text block cannot have the indentation 0", "", ""},
    {Original::CHAR_IN_BLOCK, "only a comment can follow `|` or `>` here", "",
     "begin the text on the next line"},
}};

/// Everything a message is made from.
struct Failure {
  std::string_view message;
  std::size_t offset;
  const Locator& locator;
  const TreeBuilder& builder;
  Diagnostics& diagnostics;

  [[nodiscard]] bool is(std::string_view original) const { return message.starts_with(original); }
  [[nodiscard]] bool at_end() const {
    return locator.skip_blank(std::min(offset, locator.text().size())) >= locator.text().size();
  }
  Diagnostic& error(Extent extent, std::string text) const {
    return diagnostics.error("E0105", locator.span(extent), std::move(text));
  }
};

/// The character at `begin`, as an extent.
Extent character(const Locator& locator, std::size_t begin) {
  const std::string_view text = locator.text();
  if (begin >= text.size()) return {begin, begin};
  return {begin, begin + decode_utf8(text, begin).size};
}

/// Just behind the last thing in the file that is not blank: where a user looks for what is
/// missing.
Extent end_of_content(const Locator& locator) {
  const std::size_t last = locator.text().find_last_not_of(" \t\n");
  const std::size_t end = last == std::string_view::npos ? 0 : last + 1;
  return {end, end + 1};
}

/// A tab among the blanks and dashes in front of `offset` on its line.
std::optional<std::size_t> tab_before(const Locator& locator, std::size_t offset) {
  const std::string_view text = locator.text();
  for (std::size_t i = locator.line_begin(offset); i < std::min(offset, text.size()); ++i) {
    if (text[i] == '\t') return i;
    if (text[i] != ' ' && text[i] != '-' && text[i] != '?') break;
  }
  return std::nullopt;
}

bool report_tab(const Failure& failure) {
  const auto tab = tab_before(failure.locator, failure.offset);
  if (!tab && !failure.is(Original::TAB_IN_INDENTATION)) return false;
  const std::size_t place = tab.value_or(failure.offset);
  Diagnostic& error = failure.error({place, place + 1}, "a tab in the indentation");
  error.label = "tab";
  error.help = "YAML allows only spaces in front of keys and items";
  return true;
}

bool report_anchor(const Failure& failure) {
  if (!failure.is(Original::UNKNOWN_ANCHOR)) return false;
  const Extent extent = failure.locator.word(failure.offset);
  const std::string_view written =
      failure.locator.text().substr(extent.begin, extent.end - extent.begin);
  Diagnostic& error = failure.diagnostics.error(
      "E0109", failure.locator.span(extent),
      fmt::format("alias `{}` refers to an anchor that does not exist before it", written));
  const std::string near = nearest(written.substr(std::min<std::size_t>(1, written.size())),
                                   failure.builder.anchor_names());
  error.help =
      near.empty() ? Help("put a text that begins with `*` in quotes") : meaning("*" + near);
  return true;
}

bool report_document_mark(const Failure& failure) {
  if (!failure.is(Original::DOC_IN_SCALAR)) return false;
  failure.error(failure.locator.word(failure.offset), "a line inside quotes cannot begin like this")
      .help = "`---` and `...` end the document; is a quotation mark missing before?";
  return true;
}

bool report_unclosed(const Failure& failure) {
  const bool flow = failure.is(Original::END_OF_MAP_FLOW) || failure.is(Original::END_OF_SEQ_FLOW);
  const OpenCollection* open = failure.builder.innermost();
  if (!flow || open == nullptr || !failure.at_end()) return false;
  const char* bracket = open->map ? "{" : "[";
  failure.diagnostics.error("E0105", open->span, fmt::format("`{}` is never closed", bracket))
      .label = "opened here";
  return true;
}

/// Whether the place is the dash of a list item, or the value just behind it.
bool begins_item(const Locator& locator, std::size_t offset) {
  const std::string_view text = locator.text();
  const std::size_t first = text.find_first_not_of(' ', locator.line_begin(offset));
  if (first == std::string_view::npos || text.substr(first, 2) != "- ") return false;
  return first <= offset && text.find_first_not_of(" -", first) >= offset;
}

/// The last bracket of these lines that they do not close; texts in quotes are left out.
std::optional<std::size_t> open_bracket(const Locator& locator, std::size_t begin,
                                        std::size_t end) {
  const std::string_view text = locator.text();
  std::vector<std::size_t> open;
  char quote = '\0';
  for (std::size_t i = begin; i < end; ++i) {
    const char c = text[i];
    if (c == '\n') {
      quote = '\0';
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#' && i > begin && text[i - 1] == ' ') {
      i = locator.line_end(i) - 1;
    } else if (c == '{' || c == '[') {
      open.push_back(i);
    } else if ((c == '}' || c == ']') && !open.empty()) {
      open.pop_back();
    }
  }
  return open.empty() ? std::nullopt : std::optional(open.back());
}

/// A list item on a line of its own, while a bracket of a line before it is open. What reads YAML
/// may have gone over some items by then, as if they were texts.
bool report_unclosed_item(const Failure& failure) {
  const bool is_syntax = failure.is(Original::BLOCK_ENTRY) ||
                         failure.is(Original::END_OF_MAP_FLOW) ||
                         failure.is(Original::END_OF_SEQ_FLOW);
  if (!is_syntax || failure.at_end() || !begins_item(failure.locator, failure.offset)) return false;
  constexpr int kMostLines = 5;
  const Locator& locator = failure.locator;
  std::optional<std::size_t> bracket;
  const std::size_t end = locator.line_begin(failure.offset);
  std::size_t begin = end;
  for (int i = 0; i < kMostLines && begin > 0 && !bracket; ++i) {
    begin = locator.line_begin(begin - 1);
    bracket = open_bracket(locator, begin, end);
  }
  if (!bracket) return false;
  const bool is_map = locator.text()[*bracket] == '{';
  Diagnostic& error = failure.error(character(locator, *bracket),
                                    fmt::format("`{}` is not closed", is_map ? "{" : "["));
  error.label = "opened here";
  const std::size_t next = locator.line_end(*bracket) + 1;
  const std::size_t dash = std::min(locator.text().find('-', next), failure.offset);
  error.notes.push_back(
      {"a list item begins while it is open", locator.span(character(locator, dash)), ""});
  error.help = fmt::format("write `{}` behind its last value", is_map ? "}" : "]");
  return true;
}

bool report_character(const Failure& failure) {
  if (!failure.is(Original::UNKNOWN_TOKEN) && !failure.is(Original::CHAR_IN_SCALAR)) return false;
  const Extent extent = character(failure.locator, failure.offset);
  const std::string_view written =
      failure.locator.text().substr(extent.begin, extent.end - extent.begin);
  failure.error(extent, fmt::format("a value cannot begin with `{}`", written)).help =
      "put the text in quotes";
  return true;
}

bool report_escape(const Failure& failure) {
  const bool unknown = failure.is(Original::INVALID_ESCAPE);
  if (!unknown && !failure.is(Original::INVALID_HEX) && !failure.is(Original::INVALID_UNICODE)) {
    return false;
  }
  // The mark is behind what was read of the escape.
  const std::string_view text = failure.locator.text();
  std::size_t begin = text.rfind('\\', std::max<std::size_t>(failure.offset, 1) - 1);
  if (begin == std::string_view::npos) begin = failure.offset;
  const std::size_t end = unknown ? character(failure.locator, begin + 1).end : failure.offset;
  const std::string_view written = text.substr(begin, std::max(end, begin) - begin);
  std::string message = unknown ? fmt::format("unknown escape `{}`", written)
                                : fmt::format("`{}` is not a character", written);
  failure.error({begin, end}, std::move(message)).help =
      "write `\\\\` for a backslash itself, or use single quotes";
  return true;
}

/// A line whose key nothing separates from its value, `rate = 30`: YAML reads it as a text that
/// continues on the next line.
struct GluedLine {
  Extent separator;
  GluedKey glued;
};
std::optional<GluedLine> glued_line(const Locator& locator, std::size_t offset) {
  const std::string_view text = locator.text();
  std::size_t begin = locator.line_begin(offset);
  while (begin < text.size() && (text[begin] == ' ' || text[begin] == '-')) ++begin;
  std::size_t end = locator.line_end(begin);
  // Not the comment.
  const std::size_t comment = text.substr(begin, end - begin).find(" #");
  if (comment != std::string_view::npos) end = begin + comment;
  const std::string_view line = text.substr(begin, end - begin);
  const std::size_t at = line.find_first_of(":=");
  // With a blank behind `:` it is a key, and the mistake another one.
  if (at == std::string_view::npos || line.substr(at).starts_with(": ")) return std::nullopt;
  const auto glued = glued_key(line);
  if (!glued) return std::nullopt;
  return GluedLine{{begin + at, begin + at + 1}, *glued};
}

/// In the line of the failure, or in one before it that has no key either.
std::optional<GluedLine> find_glued(const Failure& failure) {
  const bool key = failure.is(Original::MAP_VALUE) || failure.is(Original::END_OF_MAP);
  const OpenCollection* open = failure.builder.innermost();
  if (!key || (open != nullptr && open->flow)) return std::nullopt;
  constexpr int kMostLines = 20;
  const Locator& locator = failure.locator;
  std::size_t line = locator.line_begin(std::min(failure.offset, locator.text().size()));
  for (int i = 0; i < kMostLines; ++i) {
    if (auto found = glued_line(locator, line)) return found;
    const std::string_view content = locator.text().substr(line, locator.line_end(line) - line);
    const bool has_key = i > 0 && content.find(':') != std::string_view::npos;
    if (line == 0 || has_key) return std::nullopt;
    line = locator.line_begin(line - 1);
  }
  return std::nullopt;
}

bool report_equals_sign(const Failure& failure) {
  const auto found = find_glued(failure);
  if (!found || failure.locator.text()[found->separator.begin] != '=') return false;
  failure.error(found->separator, fmt::format("`=` does not make a key of `{}`", found->glued.key))
      .help = found->glued.help;
  return true;
}

bool report_colon(const Failure& failure) {
  if (!failure.is(Original::MAP_VALUE)) return false;
  const std::string_view text = failure.locator.text();
  const std::size_t begin = failure.locator.line_begin(failure.offset);
  const std::string_view before = text.substr(begin, failure.offset - begin);
  Diagnostic& error =
      failure.error({failure.offset, failure.offset + 1}, "`:` is not allowed here");
  error.label = "would make a key of the text before it";
  error.help =
      before.find(": ") != std::string_view::npos
          ? "put a text that contains `: ` in quotes"
          : "is this line indented too far, or a space missing behind `:` in the line before?";
  if (const auto found = find_glued(failure)) {
    error.notes.push_back({fmt::format("the text begins with `{}`", found->glued.key),
                           failure.locator.span(found->separator), "no space behind it"});
    error.help = found->glued.help;
  }
  return true;
}

bool report_wording(const Failure& failure) {
  for (const Wording& wording : kWordings) {
    if (!failure.is(wording.original)) continue;
    const Extent extent = failure.at_end() ? end_of_content(failure.locator)
                                           : character(failure.locator, failure.offset);
    Diagnostic& error = failure.error(extent, wording.message);
    error.label = wording.label;
    error.help = wording.help;
    // `{value: x[0]}`
    const std::string_view text = failure.locator.text();
    if (failure.is(Original::END_OF_MAP_FLOW) && failure.offset < text.size() &&
        (text[failure.offset] == '[' || text[failure.offset] == ']'))
      error.help = "a text with brackets needs quotes within `{…}`";
    const OpenCollection* open = failure.builder.innermost();
    if (open != nullptr && open->flow)
      error.notes.push_back({"inside this bracket", open->span, "opened here"});
    return true;
  }
  return false;
}

}  // namespace

void report_yaml_error(std::string_view message, std::size_t offset, const Locator& locator,
                       const TreeBuilder& builder, Diagnostics& diagnostics) {
  const Failure failure = {message, offset, locator, builder, diagnostics};
  if (offset == std::string_view::npos) {
    diagnostics.error("E0105", locator.whole(), fmt::format("not YAML: {}", message));
    return;
  }
  const bool reported = report_tab(failure) || report_anchor(failure) ||
                        report_document_mark(failure) || report_unclosed(failure) ||
                        report_unclosed_item(failure) || report_character(failure) ||
                        report_escape(failure) || report_equals_sign(failure) ||
                        report_colon(failure) || report_wording(failure);
  if (!reported) failure.error(character(locator, offset), fmt::format("not YAML: {}", message));
}

}  // namespace eagerx::gen
