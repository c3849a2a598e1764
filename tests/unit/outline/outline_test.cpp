#include "generator/frontend/outline/outline.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

/// The outline as JSON without quotes, which is easy to compare. `~`: nothing.
std::string shown(const OutlineNode& node) {
  if (node.kind == OutlineNode::Kind::nothing) return "~";
  if (node.kind == OutlineNode::Kind::scalar) return node.text;
  const bool is_map = node.kind == OutlineNode::Kind::map;
  std::string text(1, is_map ? '{' : '[');
  for (const OutlineEntry& entry : node.entries) {
    if (text.size() > 1) text += ", ";
    if (is_map) text += entry.key + (entry.has_colon ? ": " : "");
    if (!is_map || entry.has_colon) text += shown(entry.value);
  }
  return text + (is_map ? '}' : ']');
}
std::string outline(std::string_view text) {
  return shown(outline_of(text));
}

TEST(Outline, HasWhatAFileHas) {
  EXPECT_EQ(outline("a: 1\nb:\n  c: x y # no\n  d: [1, {e: 2}]\n"),
            "{a: 1, b: {c: x y, d: [1, {e: 2}]}}");
  EXPECT_EQ(outline("---\n# c\n- a: 1\n  b: 2\n- - 3\n  - 4\n-\n  c: 5\n"),
            "[{a: 1, b: 2}, [3, 4], {c: 5}]");
  EXPECT_EQ(outline("k:\n- 1\n- 2\nl: 3\n"), "{k: [1, 2], l: 3}");
  EXPECT_EQ(outline("'a b': \"c: d\"\ne: |\n  f: g\n\n  h\ni: 1\n"), "{a b: c: d, e: , i: 1}");
  EXPECT_EQ(outline("a: {b: 1,\n    c: [x,\n  y]}\nd: 2\n"), "{a: {b: 1, c: [x, y]}, d: 2}");
  EXPECT_EQ(outline("a: http://x:1/y\nb: 1:30\n"), "{a: http://x:1/y, b: 1:30}");
  EXPECT_EQ(outline("a: &anchor {b: 1}\nc: !tag d\n"), "{a: {b: 1}, c: d}");
  EXPECT_EQ(outline(""), "~");
  EXPECT_EQ(outline("a: 1\r\nb: 2\r\n"), "{a: 1, b: 2}");
}

TEST(Outline, GoesOnBehindWhatIsWrong) {
  EXPECT_EQ(outline("a: {b: 1, c\nd: 2\n"), "{a: {b: 1, c}, d: 2}");
  EXPECT_EQ(outline("a: [1, 2\n  - x\nb: 3\n"), "{a: [1, 2, - x], b: 3}");
  EXPECT_EQ(outline("a:\n  b: 1\n  half\n  c: 2\nd\n"), "{a: {b: 1, half, c: 2}, d}");
  EXPECT_EQ(outline("a: \"open\nb: 1\n"), "{a: open, b: 1}");
  EXPECT_EQ(outline("  a: 1\nb: 2\n"), "{a: 1, b: 2}");
  EXPECT_EQ(outline("a: 1\n    b: 2\nc: 3\n"), "{a: 1, c: 3}");
  EXPECT_EQ(outline("}\na: 1\n]:\n"), "{}, a: 1, ]: ~}");
}

TEST(Outline, StaysShallow) {
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "[{a: ";
  outline_of(deep);
  deep.clear();
  for (int i = 0; i < 2000; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  outline_of(deep);
}

/// The place of `|` in a text: path, whether a key, what was typed, the word.
std::string cursor(std::string text) {
  const std::size_t at = text.find('|');
  text.erase(at, 1);
  const Cursor cursor = cursor_at(text, at);
  std::string result;
  for (const auto& step : cursor.path) {
    if (const auto* const key = std::get_if<std::string>(&step)) result += *key + "/";
    if (const auto* const place = std::get_if<std::size_t>(&step))
      result += std::to_string(*place) + "/";
  }
  return result +
         (cursor.is_key       ? " key"
          : cursor.may_be_key ? " value or key"
                              : " value") +
         " `" + cursor.typed + "` of `" +
         text.substr(cursor.word.begin, cursor.word.end - cursor.word.begin) + "`";
}

TEST(OutlineCursor, KnowsWhatIsTyped) {
  EXPECT_EQ(cursor("a: 1\nb|"), " key `b` of `b`");
  EXPECT_EQ(cursor("|"), " key `` of ``");
  EXPECT_EQ(cursor("a:\n  b: 1\n  |\nc: 2\n"), "a/ key `` of ``");
  EXPECT_EQ(cursor("a:\n  |"), "a/ value or key `` of ``");
  EXPECT_EQ(cursor("a:\n  b: 1\n|\nc: 2\n"), " key `` of ``");
  EXPECT_EQ(cursor("a: Pen|dulum # x\n"), "a/ value `Pen` of `Pendulum`");
  EXPECT_EQ(cursor("a: {type: P, con|}\n"), "a/ key `con` of `con`");
  EXPECT_EQ(cursor("a: {type: P, |\nb: 1\n"), "a/ key `` of ``");
  EXPECT_EQ(cursor("l:\n  - {from: a.b, to: |}\n"), "l/0/to/ value `` of ``");
  EXPECT_EQ(cursor("l:\n  - {from: a.b, to: c.|\nm: 1"), "l/0/to/ value `c.` of `c.`");
  EXPECT_EQ(cursor("l: [x, y|]"), "l/1/ value `y` of `y`");
  EXPECT_EQ(cursor("l:\n  - from: \"a.|b\"\n"), "l/0/from/ value `a.` of `a.b`");
  EXPECT_EQ(cursor("k|ey: 1\n"), " key `k` of `key`");
  EXPECT_EQ(cursor("# in a comm|ent\nword\n"), " value `` of ``");
  EXPECT_EQ(cursor("  \"qu|oted\" word\n"), " key `qu` of `quoted`");
}

}  // namespace
}  // namespace eagerx::gen
