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

/// What the first halves of kinds 1 and 2 have at last, if lines say this of them, and what belongs
/// to the schedule.
struct Shared {
  std::set<Address> one, two, schedule;
};
Shared shared(const std::string& f, const std::set<Address>& one, const std::set<Address>& two) {
  const Disassembled code(f);
  if (!code.image()) return {};
  Analysis analysis(*code.image());
  std::vector<SlotCode> slots = {{1, false, {{0, one}}}, {2, false, {{0, two}}}};
  const std::set<Address> schedule = share(analysis, slots);
  return {slots[0].regions[0].code, slots[1].regions[0].code, schedule};
}

using Code = std::set<Address>;

TEST(SlotCode, OfEachKindIsItsOwn) {
  const Shared found = shared(kLoop, {4, 6}, {8});
  EXPECT_EQ(found.one, (Code{4, 6}));
  EXPECT_EQ(found.two, (Code{8}));
  EXPECT_EQ(found.schedule, Code());
}

TEST(SlotCode, WhereAnotherKindGoesOnIsOfBoth) {
  const Shared end_of_one = shared(kLoop, {4, 6, 0xa}, {8});
  EXPECT_EQ(end_of_one.one, (Code{4, 6, 0xa}));
  EXPECT_EQ(end_of_one.two, (Code{8, 0xa}));
  const Shared end_of_two = shared(kLoop, {4, 6}, {8, 0xa});
  EXPECT_EQ(end_of_two.one, (Code{4, 6, 0xa}));
  EXPECT_EQ(end_of_two.two, (Code{8, 0xa}));
}

TEST(SlotCode, InFrontOfTheChoiceIsOfTheSchedule) {
  // The compiler begins both with r4, and its line is that of one.
  const std::string hoisted =
      "   0:\tmovs\tr3, #0\n   2:\tadds\tr4, #1\n   4:\tcbz\tr0, a <f+0xa>\n   6:\tadds\tr1, #1\n"
      "   8:\tb.n\tc <f+0xc>\n   a:\tadds\tr2, #1\n   c:\tadds\tr3, #1\n   e:\tcmp\tr3, #9\n"
      "  10:\tbne.n\t2 <f+0x2>\n  12:\tbx\tlr\n";
  EXPECT_TRUE(shared(hoisted, {2, 6, 8}, {0xa}).schedule.contains(2));
  EXPECT_EQ(shared(hoisted, {6, 8}, {0xa}).schedule, Code());
}

TEST(SlotCode, InFrontOfTheLoopIsOfTheScheduleToo) {
  EXPECT_EQ(shared(kLoop, {0, 4, 6}, {8}).schedule, (Code{0}));
}

TEST(SlotCode, OfAFunctionThatOnlySomeKindsHaveMayBeThatOfOthers) {
  const Disassembled code("   0:\tbx\tlr\n", " 100:\tbx\tlr\n");
  ASSERT_TRUE(code.image());
  Analysis analysis(*code.image());
  const Region whole{0x100, {}}, inlined{0, {0}};
  const auto second = [&](std::vector<SlotCode> slots) {
    share(analysis, slots);
    return slots.back().regions;
  };
  const auto of_other = second({{1, true, {whole}}, {2, true, {}}});
  ASSERT_EQ(of_other.size(), 1U);
  EXPECT_EQ(of_other[0].function, 0x100U);
  const auto own = second({{1, true, {whole}}, {2, true, {inlined}}});
  ASSERT_EQ(own.size(), 1U);
  EXPECT_EQ(own[0].function, 0U);
  EXPECT_TRUE(second({{1, true, {inlined}}, {2, true, {}}}).empty());
}

TEST(SlotCode, TurnsOnceInALoopThatOthersEnd) {
  // All but its test is of one slot, and so is what comes before it.
  const std::string led =
      "   0:\tmovs\tr3, #0\n   2:\tadds\tr1, #1\n   4:\tadds\tr1, #1\n   6:\tadds\tr1, #1\n"
      "   8:\tadds\tr3, #1\n   a:\tcmp\tr3, #9\n   c:\tbne.n\t2 <f+0x2>\n   e:\tbx\tlr\n";
  const Disassembled code(led);
  ASSERT_TRUE(code.image());
  Analysis analysis(*code.image());
  const Flow& flow = *analysis.of(0).flow;
  EXPECT_EQ(loops_around(flow, {0, 2, 4, 6, 8, 0xa}).size(), 1U);
  EXPECT_EQ(loops_around(flow, {0, 2, 4, 6, 8, 0xa, 0xc}).size(), 0U);
}

}  // namespace
}  // namespace eagerx::gen::bound
