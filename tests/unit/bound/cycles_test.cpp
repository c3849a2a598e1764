// Cycles of instructions by Arm's tables, and of paths.
#include "generator/analysis/bound/cycles.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "generator/analysis/bound/bound.hpp"
#include "generator/analysis/bound/path.hpp"
#include "tests/unit/size/tools.hpp"

namespace eagerx::gen::bound {
namespace {

/// An image of one function f at 0.
class Program {
 public:
  explicit Program(const std::string& f) {
    std::string elf = Tools::elf(Tools::kArm);
    elf.resize(64, '\0');
    tools_.file("image.elf", elf);
    tools_.says("objdump", "00000000 <f>:\n" + f);
    tools_.says("nm", "00000001 T f\n");
    image_ = Image::read(tools_.image(), "arm-none-eabi-");
  }
  const Image& image() const { return *image_; }
  std::uint64_t path(Core core, unsigned wait_states) const {
    Analysis analysis(image());
    const Cycles cycles(image(), core, wait_states);
    LongestPath path(Weight::all(cycles));
    return path.of(analysis.of(0));
  }

 private:
  Tools tools_;
  std::optional<Image> image_;
};

/// Of the first instruction, with a `nop` behind it.
std::uint64_t cycles_of(const std::string& text, Core core = Core::cortex_m4, unsigned waits = 0,
                        const std::string& next = "nop") {
  const Program program("   0:\t" + text + "\n   4:\t" + next + "\n   8:\tbx\tlr\n");
  return Cycles(program.image(), core, waits).of(*program.image().instruction(0), nullptr);
}

TEST(Cycles, AreThoseOfArmsTables) {
  EXPECT_EQ(cycles_of("adds\tr0, r1, #2"), 1U);
  EXPECT_EQ(cycles_of("ldr\tr0, [r1, #4]"), 2U);
  EXPECT_EQ(cycles_of("ldrd\tr0, r2, [r1, #4]"), 3U);
  EXPECT_EQ(cycles_of("strb\tr0, [r1, #4]"), 2U);
  EXPECT_EQ(cycles_of("push\t{r4, r5, r6, lr}"), 5U);
  EXPECT_EQ(cycles_of("ldmia.w\tr0!, {r4-r7}"), 5U);
  EXPECT_EQ(cycles_of("pop\t{r4, pc}"), 6U);
  EXPECT_EQ(cycles_of("bx\tlr"), 4U);
  EXPECT_EQ(cycles_of("bl\t100 <g>"), 4U);
  EXPECT_EQ(cycles_of("udiv\tr0, r1, r2"), 12U);
  EXPECT_EQ(cycles_of("it\teq"), 1U);
  EXPECT_EQ(cycles_of("mrs\tr0, PRIMASK"), 2U);
  // An instruction in no table counts as the slowest.
  EXPECT_EQ(cycles_of("brandnew\tr0, r1"), 12U);
  EXPECT_EQ(cycles_of("vbrandnew.f32\ts0, s1"), 14U);
}

TEST(Cycles, OfMultiplicationsDependOnTheCore) {
  for (const char* text : {"mul\tr0, r1, r2", "muls\tr0, r1"}) {
    EXPECT_EQ(cycles_of(text, Core::cortex_m3), 1U);
    EXPECT_EQ(cycles_of(text, Core::cortex_m4), 1U);
  }
  EXPECT_EQ(cycles_of("mla\tr0, r1, r2, r3", Core::cortex_m3), 2U);
  EXPECT_EQ(cycles_of("umull\tr0, r1, r2, r3", Core::cortex_m3), 5U);
  EXPECT_EQ(cycles_of("smlal\tr0, r1, r2, r3", Core::cortex_m3), 7U);
  for (const char* text : {"mla\tr0, r1, r2, r3", "umull\tr0, r1, r2, r3", "smlal\tr0, r1, r2, r3"})
    EXPECT_EQ(cycles_of(text, Core::cortex_m4), 1U) << text;
}

TEST(Cycles, OfTheFloatingPointUnit) {
  EXPECT_EQ(cycles_of("vadd.f32\ts0, s1, s2"), 1U);
  EXPECT_EQ(cycles_of("vdiv.f32\ts0, s1, s2"), 14U);
  EXPECT_EQ(cycles_of("vsqrt.f32\ts0, s1"), 14U);
  EXPECT_EQ(cycles_of("vmla.f32\ts0, s1, s2"), 3U);
  EXPECT_EQ(cycles_of("vldr\ts0, [r1]"), 2U);
  EXPECT_EQ(cycles_of("vldr\td0, [r1]"), 3U);
  EXPECT_EQ(cycles_of("vpush\t{d8-d11}"), 9U);
  EXPECT_EQ(cycles_of("vldmia\tr0!, {s12-s15}"), 5U);
  EXPECT_EQ(cycles_of("vmov\tr0, r1, d4"), 2U);
  EXPECT_EQ(cycles_of("vmov\ts0, r1"), 2U);
  EXPECT_EQ(cycles_of("vmov.f32\ts0, s1"), 1U);
}

TEST(Cycles, AResultThatIsUsedAtOnceTakesOneMore) {
  const auto before = [](const char* next, const char* text = "vadd.f32\ts0, s1, s2") {
    return cycles_of(text, Core::cortex_m4, 0, next);
  };
  EXPECT_EQ(before("vmul.f32\ts3, s0, s4"), 2U);
  EXPECT_EQ(before("vmul.f32\ts3, s5, s4"), 1U);
  EXPECT_EQ(before("vstr\ts0, [r1]"), 2U);
  EXPECT_EQ(before("vpush\t{d8}"), 2U);
  EXPECT_EQ(before("b.n\t0 <f>"), 2U);  // the target may use it
  EXPECT_EQ(before("vmrs\tAPSR_nzcv, fpscr", "vcmp.f32\ts0, s1"), 2U);
}

TEST(Cycles, EachWordOfCodeAndOfConstantsWaits) {
  constexpr unsigned kWaits = 5;
  const auto waits = [](const char* text) {
    return cycles_of(text, Core::cortex_m4, kWaits) - cycles_of(text, Core::cortex_m4, 0);
  };
  EXPECT_EQ(waits("add.w\tr0, r1, #2"), kWaits);
  EXPECT_EQ(waits("ldr\tr0, [r1, #4]"), 2 * kWaits);
  EXPECT_EQ(waits("ldrd\tr0, r2, [r1, #4]"), 3 * kWaits);
  EXPECT_EQ(waits("ldr\tr0, [sp, #4]"), kWaits);  // the stack is in RAM
  EXPECT_EQ(waits("str\tr0, [r1, #4]"), kWaits);
  // Two short instructions are in one word; the second pays only where it is jumped to.
  const Program pair("   0:\tnop\n   2:\tnop\n   4:\tbx\tlr\n");
  const Cycles cycles(pair.image(), Core::cortex_m4, kWaits);
  const Instruction& first = *pair.image().instruction(0);
  const Instruction& second = *pair.image().instruction(2);
  EXPECT_EQ(cycles.of(second, &first), 1U);
  EXPECT_EQ(cycles.of(second, nullptr), 1U + kWaits);
}

TEST(Cycles, OnlyATakenBranchFillsThePipelineAgain) {
  // Falls through: cmp, beq, bx. Taken: the same with 3 more.
  const Program branch("   0:\tcmp\tr0, #3\n   2:\tbeq.n\t6 <f+0x6>\n   4:\tnop\n   6:\tbx\tlr\n");
  EXPECT_EQ(branch.path(Core::cortex_m4, 0), 1U + 1U + 3U + 4U);
  // Three turns: two of them go back.
  const Program loop(
      "   0:\tmovs\tr3, #3\n   2:\tsubs\tr3, #1\n   4:\tbne.n\t2 <f+0x2>\n"
      "   6:\tbx\tlr\n");
  EXPECT_EQ(loop.path(Core::cortex_m4, 0), 1U + 3 * 2U + 2 * 3U + 4U);
}

TEST(Cycles, AreKnownOfTwoCores) {
  EXPECT_EQ(core_of("Cortex-M3"), Core::cortex_m3);
  EXPECT_EQ(core_of("Cortex-M4"), Core::cortex_m4);
  EXPECT_EQ(core_of("Cortex-M4F"), Core::cortex_m4);
  for (const char* other : {"Cortex-M7", "Cortex-M55", "RV32IMAFC", "", "FILL_IN"})
    EXPECT_EQ(core_of(other), std::nullopt) << other;
}

TEST(Cycles, InterruptsComeOnTop) {
  TimeModel time{"board", "Cortex-M4F", 1'000'000, 0, {}};
  EXPECT_DOUBLE_EQ(time.seconds(500), 500e-6);
  // One at the beginning and one after 1000 cycles.
  time.interrupts = {{"Tick", 100, 1000.0}};
  EXPECT_DOUBLE_EQ(time.seconds(500), 600e-6);
  EXPECT_DOUBLE_EQ(time.seconds(950), 1150e-6);
  time.interrupts = {{"Always", 1000, 1000.0}};
  EXPECT_EQ(time.seconds(1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace eagerx::gen::bound
