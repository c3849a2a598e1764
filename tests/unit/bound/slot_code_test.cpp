// Code that several kinds of slots share, as compilers write it.
#include "generator/analysis/bound/slot_code.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bound/disassembled.hpp"

namespace eagerx::gen::bound {
namespace {

/// A loop over slots of two kinds, each `adds` and a branch back.
constexpr const char* kLoop =
    "   0:\tmovs\tr3, #0\n   2:\tcbz\tr0, 8 <f+0x8>\n   4:\tadds\tr1, #1\n"
    "   6:\tb.n\ta <f+0xa>\n   8:\tadds\tr2, #1\n   a:\tadds\tr3, #1\n   c:\tcmp\tr3, #9\n"
    "   e:\tbne.n\t2 <f+0x2>\n  10:\tbx\tlr\n";

/// Whether it is shared if the first half of kind 1 has these instructions, and that of kind 2
/// those.
bool shares(const std::string& f, const std::set<Address>& one, const std::set<Address>& two) {
  const Disassembled code(f);
  if (!code.image()) return false;
  Analysis analysis(*code.image());
  return is_shared(analysis, {{1, false, {{0, one}}}, {2, false, {{0, two}}}});
}

TEST(SlotCode, OfEachKindIsItsOwn) {
  EXPECT_FALSE(shares(kLoop, {4, 6}, {8}));
}

TEST(SlotCode, ThatGoesOnInThatOfAnotherKindIsShared) {
  EXPECT_TRUE(shares(kLoop, {4, 6, 0xa}, {8}));
  EXPECT_TRUE(shares(kLoop, {4, 6}, {8, 0xa}));
}

TEST(SlotCode, InFrontOfTheChoiceIsShared) {
  // The compiler begins both with r3, and its line is that of one.
  const std::string hoisted =
      "   0:\tmovs\tr3, #0\n   2:\tadds\tr4, #1\n   4:\tcbz\tr0, a <f+0xa>\n   6:\tadds\tr1, #1\n"
      "   8:\tb.n\tc <f+0xc>\n   a:\tadds\tr2, #1\n   c:\tadds\tr3, #1\n   e:\tcmp\tr3, #9\n"
      "  10:\tbne.n\t2 <f+0x2>\n  12:\tbx\tlr\n";
  EXPECT_TRUE(shares(hoisted, {2, 6, 8}, {0xa}));
  EXPECT_FALSE(shares(hoisted, {6, 8}, {0xa}));
}

TEST(SlotCode, OfAFunctionThatOnlySomeKindsHaveIsSharedPerhaps) {
  const Disassembled code("   0:\tbx\tlr\n", " 100:\tbx\tlr\n");
  ASSERT_TRUE(code.image());
  Analysis analysis(*code.image());
  const Region whole{0x100, {}}, inlined{0, {0}};
  EXPECT_TRUE(is_shared(analysis, {{1, true, {whole}}, {2, true, {}}}));
  EXPECT_FALSE(is_shared(analysis, {{1, true, {whole}}, {2, true, {inlined}}}));
  EXPECT_FALSE(is_shared(analysis, {{1, true, {inlined}}, {2, true, {}}}));
}

}  // namespace
}  // namespace eagerx::gen::bound
