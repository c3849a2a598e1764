#include <gtest/gtest.h>

#include <eagerx/safe_output.hpp>

namespace eagerx {
namespace {

using OneFloat = Array<float, 1>;

TEST(SafeOutput, ASlowRampArrivesInItsTime) {
  // 0.01 a second at 1 kHz: less than half a unit in the last place of 300.
  const SafeOutput<OneFloat> safe{{{310.0F}}, {}, 0, 1e-5F};
  OutputKeeper<OneFloat> keeper;
  keeper.reset(safe);
  keeper.leave({{300.0F}}, safe);
  for (int n = 0; n < 500'000; ++n) keeper.be_safe(safe, false);
  EXPECT_NEAR(keeper.message()[0], 305.0F, 1e-3F);
  for (int n = 0; n < 510'000; ++n) keeper.be_safe(safe, false);
  EXPECT_EQ(keeper.message()[0], 310.0F);
}

TEST(SafeOutput, ABeginningRampKeepsNothingOfTheLastOne) {
  const SafeOutput<OneFloat> safe{{{0.0F}}, {}, 0, 0.1F};
  OutputKeeper<OneFloat> keeper;
  for (int episode = 0; episode < 2; ++episode) {
    keeper.reset(safe);
    keeper.leave({{1.0F}}, safe);
    keeper.be_safe(safe, false);
    EXPECT_EQ(keeper.message()[0], 1.0F - 0.1F);
    keeper.leave({{1.0F}}, safe);
    EXPECT_EQ(keeper.message()[0], 1.0F);
  }
}

}  // namespace
}  // namespace eagerx
