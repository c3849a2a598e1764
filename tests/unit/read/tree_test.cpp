// Spans and values of texts that are in order.
#include <gtest/gtest.h>

#include "tests/unit/read/reading.hpp"

namespace eagerx::gen {
namespace {

TEST(Tree, ScalarsInMapsAndLists) {
  expect_tree("a: 1\nb: [x, 'y z', \"w\"]\nc:\n  - d: e\n    f: g\n  - h\n",
              "1:1+1 {1:1+1 a: 1:4+1 1, 2:1+1 b: 2:4+1 [2:5+1 x, 2:8+5 \"y z\", 2:15+3 \"w\"], "
              "3:1+1 c: 4:3+1 [4:5+1 {4:5+1 d: 4:8+1 e, 5:5+1 f: 5:8+1 g}, 6:5+1 h]}");
}

TEST(Tree, FindsKeys) {
  const Reading reading("a: 1\n\"b c\": 2\n");
  ASSERT_NE(reading.root.find("b c"), nullptr);
  EXPECT_EQ(reading.root.find("b c")->text, "2");
  EXPECT_EQ(reading.root.find("b"), nullptr);
}

TEST(Tree, ColumnsCountCodePoints) {
  expect_tree("ä: \"ö😀\" # x\nü:  wörld\n", "1:1+1 {1:1+1 ä: 1:4+4 \"ö😀\", 2:1+1 ü: 2:5+5 wörld}");
}

TEST(Tree, ColumnsAreRightFarIntoALine) {
  const std::string filler(3000, 'x');
  expect_tree("{a: ä" + filler + ", b: ü}",
              "1:1+1 {1:2+1 a: 1:5+3001 ä" + filler + ", 1:3008+1 b: 1:3011+1 ü}");
}

TEST(Tree, QuotedScalarsWithQuotesInside) {
  expect_tree("a: 'it''s' # 'c'\nb: \"x\\\"y\\\\\" # \"\n",
              "1:1+1 {1:1+1 a: 1:4+7 \"it's\", 2:1+1 b: 2:4+8 \"x\"y\\\"}");
}

TEST(Tree, ScalarsOverSeveralLinesPointAtTheFirst) {
  expect_tree("a: one # not part\nb: two\n  three\nc: \"four\n  five\"\n",
              "1:1+1 {1:1+1 a: 1:4+3 one, 2:1+1 b: 2:4+3 two three, 4:1+1 c: 4:4+5 \"four five\"}");
  expect_tree("a: |\n  one\n  two\nb: >-\n  three\n",
              "1:1+1 {1:1+1 a: 1:4+1 \"one\ntwo\n\", 4:1+1 b: 4:4+2 \"three\"}");
}

TEST(Tree, NullsPointAtTheirKeyOrDash) {
  expect_tree("a:\nb: ~\nc: null\nd: # nothing\n",
              "1:1+1 {1:1+1 a: 1:1+1 null, 2:1+1 b: 2:4+1 null, 3:1+1 c: 3:4+4 null, "
              "4:1+1 d: 4:1+1 null}");
  expect_tree("a:\n  b:\nc: 1\n", "1:1+1 {1:1+1 a: 2:3+1 {2:3+1 b: 2:3+1 null}, 3:1+1 c: 3:4+1 1}");
  expect_tree("{a, b: , c: ~}",
              "1:1+1 {1:2+1 a: 1:2+1 null, 1:5+1 b: 1:5+1 null, "
              "1:10+1 c: 1:13+1 null}");
  expect_tree("- a\n- # - x\n# - y\n- |\n  b\n-\n- \"c\n   d\"\n-\n- ~\n-\n",
              "1:1+1 [1:3+1 a, 2:1+1 null, 4:3+1 \"b\n\", 6:1+1 null, 7:3+2 \"c d\", 9:1+1 null, "
              "10:3+1 null, 11:1+1 null]");
  expect_tree("- -\n- - # x\n", "1:1+1 [1:3+1 [1:3+1 null], 2:3+1 [2:3+1 null]]");
  expect_tree("[a, , b]", "1:1+1 [1:2+1 a, 1:5+1 null, 1:7+1 b]");
}

TEST(Tree, NullLookingTextThatIsNotNull) {
  expect_tree("a: \"null\"\nb: nullx\nc: '~'\n",
              "1:1+1 {1:1+1 a: 1:4+6 \"null\", 2:1+1 b: 2:4+5 nullx, 3:1+1 c: 3:4+3 \"~\"}");
}

TEST(Tree, MarksOfOneDocumentAreFine) {
  expect_tree("%YAML 1.2\n---\na: 1\n...\n", "3:1+1 {3:1+1 a: 3:4+1 1}");
  expect_tree("--- a\n", "1:5+1 a");
}

TEST(Tree, ByteOrderMarkAndLineEnds) {
  expect_tree(
      "\xef\xbb\xbf"
      "a: 1\r\nb: 2\rc: |\r\n  x\r\n  y\r\n",
      "1:1+1 {1:1+1 a: 1:4+1 1, 2:1+1 b: 2:4+1 2, 3:1+1 c: 3:4+1 \"x\ny\n\"}");
}

TEST(Tree, AliasesAreCopiesAtTheirOwnPlace) {
  expect_tree("a: &x [1, 2]\nb: *x\nc: &y {d: *x}\ne: *y\n",
              "1:1+1 {1:1+1 a: 1:7+1 [1:8+1 1, 1:11+1 2], 2:1+1 b: 2:4+2 [1:8+1 1, 1:11+1 2], "
              "3:1+1 c: 3:7+1 {3:8+1 d: 3:11+2 [1:8+1 1, 1:11+1 2]}, "
              "4:1+1 e: 4:4+2 {3:8+1 d: 3:11+2 [1:8+1 1, 1:11+1 2]}}");
  expect_tree("- &x a\n- &x b\n- *x\n", "1:1+1 [1:6+1 a, 2:6+1 b, 3:3+2 b]");
  expect_tree("a: &x\nb: *x\n", "1:1+1 {1:1+1 a: 1:1+1 null, 2:1+1 b: 2:4+2 null}");
}

TEST(Tree, TagsAreKeptWhereAccepted) {
  expect_tree("a: !!python/tuple [1]\nb: !t x\nc: !!str\nd: !u\n  e: 1\nf: &q !!int 3\n",
              "1:1+1 {1:1+1 a: 1:19+1 <tag:yaml.org,2002:python/tuple> [1:20+1 1], "
              "2:1+1 b: 2:7+1 <!t> x, 3:1+1 c: 3:4+5 <tag:yaml.org,2002:str> , "
              "4:1+1 d: 5:3+1 <!u> {5:3+1 e: 5:6+1 1}, "
              "6:1+1 f: 6:13+1 <tag:yaml.org,2002:int> 3}",
              Tags::accept);
}

TEST(Tree, KeysMayBeQuotedAndExplicit) {
  expect_tree("\"null\": 1\n'<<': 2\n? c\n: 3\n",
              "1:1+6 {1:1+6 null: 1:9+1 1, 2:1+4 <<: 2:7+1 2, 3:3+1 c: 4:3+1 3}");
}

TEST(Tree, TabsMaySeparate) {
  expect_tree("a:\t1\t# x\nb: [\n\t2 ]\n", "1:1+1 {1:1+1 a: 1:4+1 1, 2:1+1 b: 2:4+1 [3:2+1 2]}");
}

}  // namespace
}  // namespace eagerx::gen
