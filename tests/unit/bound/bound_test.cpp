// Instructions, control flow, turns of loops and longest paths, of disassemblies as objdump prints
// them.
#include "generator/analysis/bound/bound.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bound/disassembled.hpp"

namespace eagerx::gen::bound {
namespace {

using Result = Disassembled::Result;

Result bound_of(const std::string& f, const std::string& g = "") {
  return Disassembled(f, g).bound();
}

Result only(std::uint64_t most) {
  return {most, {}};
}

TEST(Path, TheLongerSideOfABranchCounts) {
  EXPECT_EQ(bound_of("   0:\tcmp\tr0, #3\n   2:\tbeq.n\t8 <f+0x8>\n   4:\tadds\tr0, #1\n"
                     "   6:\tadds\tr0, #2\n   8:\tbx\tlr\n"),
            only(5));
}

TEST(Path, AConditionalReturnIsOneOfTwoEnds) {
  EXPECT_EQ(
      bound_of("   0:\tcmp\tr0, #3\n   2:\tit\teq\n   4:\tbxeq\tlr\n   6:\tnop\n   8:\tbx\tlr\n"),
      only(5));
}

TEST(Path, WhatNeverReturnsIsNoPath) {
  EXPECT_EQ(bound_of("   0:\tcbz\tr0, 6 <f+0x6>\n   2:\tbl\t100 <g>\n   6:\tbx\tlr\n",
                     " 100:\tnop\n 102:\tb.n\t102 <g+0x2>\n"),
            only(2));
}

TEST(Path, ACalleeCountsWithWhatItIsGiven) {
  const std::string g =
      " 100:\tmovs\tr3, #0\n 102:\tadds\tr3, #1\n 104:\tcmp\tr3, r0\n 106:\tbne.n\t102 <g+0x2>\n"
      " 108:\tbx\tlr\n";
  EXPECT_EQ(bound_of("   0:\tpush\t{lr}\n   2:\tmovs\tr0, #7\n   4:\tbl\t100 <g>\n"
                     "   8:\tmovs\tr0, #2\n   a:\tbl\t100 <g>\n   e:\tpop\t{pc}\n",
                     g),
            only(6 + (1 + 7 * 3 + 1) + (1 + 2 * 3 + 1)));
  EXPECT_EQ(bound_of("   0:\tpush\t{lr}\n   2:\tbl\t100 <g>\n   6:\tpop\t{pc}\n", g).why,
            std::set{Reason::loop});
}

TEST(Loops, CountUpTo) {
  const auto counted = [](const char* test, const char* branch) {
    return bound_of(std::string("   0:\tmovs\tr3, #0\n   2:\tadds\tr3, #2\n   4:\t") + test +
                    "\n   6:\t" + branch + "\t2 <f+0x2>\n   8:\tbx\tlr\n");
  };
  EXPECT_EQ(counted("cmp\tr3, #10", "bne.n"), only(1 + 5 * 3 + 1));
  EXPECT_EQ(counted("cmp\tr3, #10", "blt.n"), only(1 + 5 * 3 + 1));
  EXPECT_EQ(counted("cmp\tr3, #10", "bls.n"), only(1 + 6 * 3 + 1));
  EXPECT_EQ(counted("cmp\tr3, #11", "bcc.n"), only(1 + 6 * 3 + 1));
  // Steps of two never meet 11.
  EXPECT_EQ(counted("cmp\tr3, #11", "bne.n").why, std::set{Reason::loop});
  EXPECT_EQ(counted("cmp\tr3, r7", "bne.n").why, std::set{Reason::loop});
}

TEST(Loops, CountDown) {
  EXPECT_EQ(bound_of("   0:\tmovs\tr3, #9\n   2:\tsubs\tr3, #1\n   4:\tbne.n\t2 <f+0x2>\n"
                     "   6:\tbx\tlr\n"),
            only(1 + 9 * 2 + 1));
  // Without a sign, 0 is not below 0.
  EXPECT_EQ(bound_of("   0:\tmovs\tr3, #9\n   2:\tsubs\tr3, #1\n   4:\tcmp\tr3, #0\n"
                     "   6:\tbcs.n\t2 <f+0x2>\n   8:\tbx\tlr\n")
                .why,
            std::set{Reason::loop});
}

TEST(Loops, InLoopsWhoseBeginAndEndAreLeftByInnerOnes) {
  // Rows of a triangle of scalar products: the inner loop's end r3 and the middle one's r4 make the
  // next row's.
  EXPECT_EQ(
      bound_of(
          "   0:\tmovs\tr1, #24\n   2:\tmovs\tr6, #0\n   4:\tmovs\tr5, #0\n   6:\tmovs\tr7, #4\n"
          "   8:\tmov\tr4, r5\n   a:\tmov\tr3, r6\n   c:\tadds\tr3, #4\n   e:\tcmp\tr3, r1\n"
          "  10:\tbne.n\tc <f+0xc>\n  12:\tadds\tr4, #4\n  14:\tcmp\tr4, r7\n  16:\tbne.n\ta "
          "<f+0xa>\n"
          "  18:\tadd.w\tr7, r4, #28\n  1c:\tadds\tr6, #28\n  1e:\tadd.w\tr1, r3, #28\n"
          "  22:\tadds\tr5, #24\n  24:\tcmp\tr7, #172\n  26:\tbne.n\t8 <f+0x8>\n  28:\tbx\tlr\n"),
      only(4 + 6 * (1 + 6 * (1 + 6 * 3 + 3) + 6) + 1));
}

TEST(Loops, BeginAtWhatMemcpyReturns) {
  const std::string f =
      "   0:\tpush\t{r4, lr}\n   2:\tadd.w\tr4, r0, #12\n   6:\tbl\t100 <memcpy>\n"
      "   a:\tldr.w\tr3, [r0], #4\n   e:\tcmp\tr0, r4\n  10:\tbne.n\ta <f+0xa>\n  12:\tpop\t{r4, "
      "pc}\n";
  const auto with = [&](const char* name) {
    return Disassembled(f, " 100:\tbx\tlr\n", name).bound();
  };
  EXPECT_EQ(with("memcpy"), only(3 + 1 + 3 * 3 + 1));
  EXPECT_EQ(with("other").why, std::set{Reason::loop});
}

TEST(Loops, CountersWrap) {
  EXPECT_EQ(bound_of("   0:\tmov.w\tr7, #2654435769\t@ 0x9e3779b9\n"
                     "   4:\tmov.w\tr4, #774553914\t@ 0x2e2ac13a\n   8:\tmovs\tr2, #0\n"
                     "   a:\tadds\tr2, r2, r7\n   c:\tcmp\tr2, r4\n   e:\tbne.n\ta <f+0xa>\n"
                     "  10:\tbx\tlr\n"),
            only(3 + 10 * 3 + 1));
}

TEST(Loops, CountersThatWrapMayBeginAnywhere) {
  const auto until = [](const char* end, const char* step) {
    return bound_of(std::string("   0:\tldr\tr2, [r0, #0]\n   2:\tmov.w\tr7, #") + step +
                    "\n   6:\tmov.w\tr4, #" + end +
                    "\n   a:\tadd\tr4, r2\n   c:\tadds\tr2, r2, r7\n   e:\tcmp\tr4, r2\n"
                    "  10:\tbne.n\tc <f+0xc>\n  12:\tbx\tlr\n");
  };
  EXPECT_EQ(until("774553914", "2654435769"), only(4 + 10 * 3 + 1));
  EXPECT_EQ(until("4294967256", "4294967292"), only(4 + 10 * 3 + 1));
  // Steps of 6 meet 3 never, and one of 3 after a third of all numbers.
  EXPECT_EQ(until("3", "6").why, std::set{Reason::loop});
  EXPECT_EQ(until("1", "3").why, std::set{Reason::loop});
}

TEST(Loops, StartBelowAnEndThatWasExcluded) {
  EXPECT_EQ(bound_of("   0:\tldr\tr6, [r0, #0]\n   2:\tcmp\tr6, #11\n   4:\tbhi.n\t14 <f+0x14>\n"
                     "   6:\tcmp\tr6, #11\n   8:\tbeq.n\t14 <f+0x14>\n   a:\tadds\tr3, r6, #1\n"
                     "   c:\tadds\tr3, #1\n   e:\tcmp\tr3, #12\n  10:\tbne.n\tc <f+0xc>\n"
                     "  12:\tnop\n  14:\tbx\tlr\n"),
            only(6 + 11 * 3 + 2));
}

TEST(Loops, PointersWithAnUnknownIndexMeetAnEndWithTheSame) {
  EXPECT_EQ(bound_of("   0:\tadd.w\tr2, r0, #176\t@ 0xb0\n   4:\tadd.w\tr3, r0, #188\t@ 0xbc\n"
                     "   8:\tadd\tr3, r1\n   a:\tadd\tr2, r1\n   c:\tvldmia\tr2!, {s15}\n"
                     "  10:\tcmp\tr3, r2\n  12:\tbne.n\tc <f+0xc>\n  14:\tbx\tlr\n"),
            only(4 + 3 * 3 + 1));
  EXPECT_EQ(bound_of("   0:\tadd.w\tr3, r0, #12\n   4:\tadd\tr3, r1\n   6:\tadds\tr2, r0, r4\n"
                     "   8:\tvldmia\tr2!, {s15}\n   c:\tcmp\tr3, r2\n   e:\tbne.n\t8 <f+0x8>\n"
                     "  10:\tbx\tlr\n")
                .why,
            std::set{Reason::loop});
}

TEST(Loops, PointersThatGrowTogetherStayAsFarApart) {
  EXPECT_EQ(bound_of("   0:\tmov\tr4, r0\n   2:\tadd.w\tr5, r0, #16\n   6:\tmovs\tr6, #3\n"
                     "   8:\tmov\tr2, r4\n   a:\tvldmia\tr2!, {s15}\n   e:\tcmp\tr2, r5\n"
                     "  10:\tbne.n\ta <f+0xa>\n  12:\tadds\tr4, #16\n  14:\tadds\tr5, #16\n"
                     "  16:\tsubs\tr6, #1\n  18:\tbne.n\t8 <f+0x8>\n  1a:\tbx\tlr\n"),
            only(3 + 3 * (1 + 4 * 3 + 4) + 1));
  // One of them grows by less, and the outer loop turns too often to be followed.
  EXPECT_EQ(bound_of("   0:\tmov\tr4, r0\n   2:\tadd.w\tr5, r0, #16\n   6:\tmovs\tr6, #100\n"
                     "   8:\tmov\tr2, r4\n   a:\tvldmia\tr2!, {s15}\n   e:\tcmp\tr2, r5\n"
                     "  10:\tbne.n\ta <f+0xa>\n  12:\tadds\tr4, #16\n  14:\tadds\tr5, #12\n"
                     "  16:\tsubs\tr6, #1\n  18:\tbne.n\t8 <f+0x8>\n  1a:\tbx\tlr\n")
                .why,
            std::set{Reason::loop});
}

TEST(Loops, DependOnWhatAnOuterLoopHalves) {
  EXPECT_EQ(bound_of("   0:\tmovs\tr4, #4\n   2:\tmovs\tr0, #8\n   4:\tmovs\tr3, #0\n"
                     "   6:\tadds\tr3, #1\n   8:\tcmp\tr3, r0\n   a:\tbne.n\t6 <f+0x6>\n"
                     "   c:\tsubs\tr4, #1\n   e:\tmov.w\tr0, r0, lsr #1\n  12:\tbne.n\t4 <f+0x4>\n"
                     "  14:\tbx\tlr\n"),
            only(2 + 4 * (1 + 8 * 3 + 3) + 1));
}

TEST(Loops, CountAnArgumentThatTheCallerHasPutOnTheStack) {
  const auto called = [](const char* taken) {
    return bound_of(
        "   0:\tpush\t{lr}\n   2:\tsub\tsp, #4\n   4:\tmovs\tr3, #6\n   6:\tstr\tr3, [sp, #0]\n"
        "   8:\tbl\t100 <g>\n   c:\tadd\tsp, #4\n   e:\tpop\t{pc}\n",
        std::string(" 100:\tpush\t{r4, lr}\n 102:\tsub\tsp, #8\n 104:\tadd\tr1, sp, ") + taken +
            "\n 106:\tstr\tr2, [r0, #0]\n 108:\tldr\tr3, [sp, #16]\n 10a:\tsubs\tr3, #1\n"
            " 10c:\tbne.n\t10a <g+0xa>\n 10e:\tadd\tsp, #8\n 110:\tpop\t{r4, pc}\n");
  };
  EXPECT_EQ(called("#4"), only(7 + 5 + 6 * 2 + 2));
  // Its own address is taken: the write may change it.
  EXPECT_EQ(called("#16").why, std::set{Reason::loop});
}

TEST(Loops, PointersMeetAnEndThatIsAsFarAsTheyStart) {
  EXPECT_EQ(bound_of("   0:\tadd.w\tr1, r0, #48\t@ 0x30\n   4:\tvldmia\tr0!, {s15}\n"
                     "   8:\tcmp\tr0, r1\n   a:\tbne.n\t4 <f+0x4>\n   c:\tbx\tlr\n"),
            only(1 + 12 * 3 + 1));
}

TEST(Loops, ACounterMayLieOnTheStack) {
  const std::string loop =
      "   4:\tldr\tr3, [sp, #4]\n   6:\tadds\tr3, #1\n   8:\tstr\tr3, [sp, #4]\n"
      "   a:\tcmp\tr3, #4\n   c:\tbne.n\t4 <f+0x4>\n   e:\tadd\tsp, #8\n  10:\tbx\tlr\n";
  EXPECT_EQ(bound_of("   0:\tmovs\tr3, #0\n   1:\tsub\tsp, #8\n   2:\tstr\tr3, [sp, #4]\n" + loop),
            only(3 + 4 * 5 + 2));
  // Its address is known, and a pointer that is not may lead there.
  EXPECT_EQ(bound_of("   0:\tsub\tsp, #8\n   2:\tmov\tr1, sp\n   4:\tmovs\tr3, #0\n"
                     "   6:\tstr\tr3, [sp, #4]\n   8:\tldr\tr3, [sp, #4]\n   a:\tadds\tr3, #1\n"
                     "   c:\tstr\tr3, [sp, #4]\n   e:\tstr\tr2, [r7, #0]\n  10:\tcmp\tr3, #4\n"
                     "  12:\tbne.n\t8 <f+0x8>\n  14:\tadd\tsp, #8\n  16:\tbx\tlr\n")
                .why,
            std::set{Reason::loop});
}

TEST(Loops, InnerOnesStartWhereOuterOnesAre) {
  // for (r4 = 0; r4 < 3; ++r4) for (r5 = r4; r5 < 8; ++r5): at most 8 turns of the inner one.
  EXPECT_EQ(bound_of("   0:\tmovs\tr4, #0\n   2:\tmov\tr5, r4\n   4:\tadds\tr5, #1\n"
                     "   6:\tcmp\tr5, #8\n   8:\tblt.n\t4 <f+0x4>\n   a:\tadds\tr4, #1\n"
                     "   c:\tcmp\tr4, #3\n   e:\tblt.n\t2 <f+0x2>\n  10:\tbx\tlr\n"),
            only(1 + 3 * (1 + 8 * 3 + 3) + 1));
}

TEST(Loops, FlagsAndShiftsAreFollowedTurnByTurn) {
  EXPECT_EQ(bound_of("   0:\tmovs\tr5, #2\n   2:\tcmp\tr5, #1\n   4:\tbeq.n\ta <f+0xa>\n"
                     "   6:\tmovs\tr5, #1\n   8:\tb.n\t2 <f+0x2>\n   a:\tbx\tlr\n"),
            only(1 + 4 + 2 + 1));
  EXPECT_EQ(bound_of("   0:\tmov.w\tip, #524288\t@ 0x80000\n   4:\tnop\n"
                     "   6:\tmovs.w\tip, ip, lsr #4\n   a:\tbne.n\t4 <f+0x4>\n   c:\tbx\tlr\n"),
            only(1 + 5 * 3 + 1));
}

TEST(Loops, ALimitCheckedBeforeHoldsBehind) {
  // if (r0 > 11) return; for (; r0 != 12; ++r0)
  EXPECT_EQ(bound_of("   0:\tldr\tr0, [r1, #0]\n   2:\tcmp\tr0, #11\n   4:\tbhi.n\tc <f+0xc>\n"
                     "   6:\tadds\tr0, #1\n   8:\tcmp\tr0, #12\n   a:\tbne.n\t6 <f+0x6>\n"
                     "   c:\tbx\tlr\n"),
            only(3 + 12 * 3 + 1));
}

TEST(Loops, ALimitMayBeTheSmallerOfTwoNumbers) {
  // if (r0 >= 5) r0 = 5; for (r3 = 0; r3 != r0; ++r3), as a conditional instruction and as a
  // branch.
  const std::string loop =
      "   8:\tmovs\tr3, #0\n   a:\tcmp\tr3, r0\n   c:\tbeq.n\t12 <f+0x12>\n   e:\tadds\tr3, #1\n"
      "  10:\tb.n\ta <f+0xa>\n  12:\tbx\tlr\n";
  EXPECT_EQ(bound_of("   0:\tldr\tr0, [r1, #0]\n   2:\tcmp\tr0, #5\n   4:\tit\tcs\n"
                     "   6:\tmovcs\tr0, #5\n" +
                     loop),
            only(5 + 5 * 4 + 2 + 1));
  EXPECT_EQ(bound_of("   0:\tldr\tr0, [r1, #0]\n   2:\tcmp\tr0, #5\n   4:\tbcc.n\t8 <f+0x8>\n"
                     "   6:\tmovs\tr0, #5\n" +
                     loop),
            only(5 + 5 * 4 + 2 + 1));
}

TEST(Loops, AnEndMayBeOneOfTwoNumbers) {
  // From 0 or 1 up to 2 or 3, whatever r7 was; the flags decide both.
  const auto ends = [](const std::string& between) {
    return bound_of(
        "   0:\tldr\tr4, [r0, #0]\n   2:\tcmp\tr4, #1\n   4:\tbhi.n\t18 <f+0x18>\n"
        "   6:\tcmp\tr4, #0\n   8:\tit\teq\n   a:\tmoveq\tr7, #2\n" +
        between +
        "   e:\tit\tne\n  10:\tmovne\tr7, #3\n  12:\tadds\tr4, #1\n"
        "  14:\tcmp\tr4, r7\n  16:\tbne.n\t12 <f+0x12>\n  18:\tbx\tlr\n");
  };
  EXPECT_EQ(ends("   c:\tnop\n"), only(9 + 3 * 3 + 1));
  EXPECT_EQ(ends("   c:\tcmp\tr5, #0\n").why, std::set{Reason::loop});
}

TEST(Loops, WhatHasNoBoundSaysWhy) {
  EXPECT_EQ(
      bound_of("   0:\tldr\tr3, [r0, #0]\n   2:\tcmp\tr3, #0\n   4:\tbne.n\t0 <f>\n   6:\tbx\tlr\n")
          .why,
      std::set{Reason::loop});
  EXPECT_EQ(bound_of("   0:\tpush\t{lr}\n   2:\tbl\t100 <g>\n   6:\tpop\t{pc}\n",
                     " 100:\tpush\t{lr}\n 102:\tcbz\tr0, 108 <g+0x8>\n 104:\tbl\t0 <f>\n"
                     " 108:\tpop\t{pc}\n")
                .why,
            std::set{Reason::recursion});
  EXPECT_EQ(bound_of("   0:\tpush\t{lr}\n   2:\tblx\tr3\n   4:\tpop\t{pc}\n").why,
            std::set{Reason::pointer_call});
  EXPECT_EQ(bound_of("   0:\tbx\tr3\n").why, std::set{Reason::lost});
  // A loop with two entries.
  EXPECT_EQ(bound_of("   0:\tcbz\tr0, 4 <f+0x4>\n   2:\tnop\n   4:\tnop\n   6:\tcmp\tr1, #0\n"
                     "   8:\tbne.n\t2 <f+0x2>\n   a:\tbx\tlr\n")
                .why,
            std::set{Reason::several_entries});
}

TEST(Loops, OneThatIsNotCountedInNeedsNoBound) {
  Tools tools;
  tools.file("image.elf", empty_elf());
  tools.says("objdump",
             "00000000 <f>:\n   0:\tnop\n   2:\tldr\tr3, [r0, #0]\n   4:\tcmp\tr3, #0\n"
             "   6:\tbne.n\t2 <f+0x2>\n   8:\tnop\n   a:\tbx\tlr\n");
  tools.says("nm", "00000001 T f\n");
  const auto image = Image::read(tools.image(), "arm-none-eabi-");
  ASSERT_TRUE(image);
  Analysis analysis(*image);
  LongestPath path({[](const Instruction& i, bool) { return i.name == "nop"; },
                    [](const Instruction&, bool) { return Weight::Callee::nothing; }});
  EXPECT_EQ(path.of(analysis.of(0)), 2U);
  EXPECT_TRUE(path.obstacles().empty());
}

TEST(Loops, OneThatAConditionExcludesIsOnNoPath) {
  // 2: one instruction and back to it, 9 times; past it: a branch, 2 instructions.
  const Disassembled code(
      "   0:\tcbz\tr0, 10 <f+0x10>\n   2:\tmovs\tr3, #0\n   4:\tadds\tr3, #1\n   6:\tcmp\tr3, #9\n"
      "   8:\tbne.n\t4 <f+0x4>\n   a:\tbx\tlr\n  10:\tnop\n  12:\tbx\tlr\n");
  ASSERT_TRUE(code.image());
  Analysis analysis(*code.image());
  Weight weight = Weight::all();
  EXPECT_EQ(LongestPath(weight).of(analysis.of(0)), 1U + 1 + 9 * 3 + 1);
  weight.never = {4};
  EXPECT_EQ(LongestPath(weight).of(analysis.of(0)), 1U + 2);
}

TEST(Bound, IsAnErrorForWhatIsNoImage) {
  Tools tools;
  Diagnostics diagnostics;
  EXPECT_FALSE(bound_instructions(tools.file("x.txt", "no image"), {}, nullptr, diagnostics));
  EXPECT_FALSE(bound_instructions(tools.image(), {}, nullptr, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 2U);
  for (const auto& problem : diagnostics.all()) EXPECT_EQ(problem.code, "E0911");
}

TEST(Bound, NonsenseOfTheToolsIsNoCrash) {
  for (const std::string text :
       {"0:\t\n", "   0:\tb\n   2:\tbl\n",
        "   0:\tldr\n   2:\tstr\tr0, [\n   4:\tldm\n   6:\tpop\n",
        "   0:\tvpush\t{d\n   2:\tmov\n   4:\tcbz\n   6:\ttbb\n   8:\tbx\n",
        "   0:\tadd\tr0, r1, lsl #99\n"}) {
    Tools tools;
    tools.file("image.elf", empty_elf());
    tools.says("objdump", text);
    tools.says("nm", "00000001 T f\n00000003 T g\n");
    const auto image = Image::read(tools.image(), "arm-none-eabi-");
    if (!image) continue;
    Analysis analysis(*image);
    for (const auto& [at, name] : image->functions()) {
      LongestPath path(Weight::all());
      path.of(analysis.of(at));
    }
  }
}

}  // namespace
}  // namespace eagerx::gen::bound
