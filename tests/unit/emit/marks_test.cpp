#include "generator/backend/emit/marks.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

TEST(Marks, AreTakenOutAgain) {
  const std::string text = "one\n" + begin_mark("a/b") + "\n  two\nthree\n" + end_mark() + "\n" +
                           begin_mark("c") + "\nfour\n" + end_mark() + "\n\nsix";
  const MarkedText marked = take_marks(text);
  EXPECT_EQ(marked.text, "one\n  two\nthree\nfour\n\nsix");
  ASSERT_EQ(marked.blocks.size(), 2U);
  EXPECT_EQ(marked.blocks[0].node, "a/b");
  EXPECT_EQ(marked.blocks[0].first, 2U);
  EXPECT_EQ(marked.blocks[0].last, 3U);
  EXPECT_EQ(marked.blocks[1].node, "c");
  EXPECT_EQ(marked.blocks[1].first, 4U);
  EXPECT_EQ(marked.blocks[1].last, 4U);
}

TEST(Marks, MayBeIndentedAsALoopDoes) {
  const MarkedText marked =
      take_marks("for\n  " + begin_mark("a") + "\n  one\n  " + end_mark() + "\n}\n");
  EXPECT_EQ(marked.text, "for\n  one\n}\n");
  ASSERT_EQ(marked.blocks.size(), 1U);
  EXPECT_EQ(marked.blocks[0].node, "a");
  EXPECT_EQ(marked.blocks[0].first, 2U);
  EXPECT_EQ(marked.blocks[0].last, 2U);
}

TEST(Marks, TextWithoutThemStays) {
  for (const char* text : {"", "\n", "a", "a\n\nb\n"}) EXPECT_EQ(take_marks(text).text, text);
}

}  // namespace
}  // namespace eagerx::gen
