#include "generator/backend/emit/namer.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace eagerx::gen {
namespace {

TEST(Names, AreGivenOnce) {
  Names names;
  EXPECT_EQ(names.unique("a_b"), "a_b");
  EXPECT_EQ(names.unique("a_b"), "a_b_2");
  EXPECT_EQ(names.unique("a_b_2"), "a_b_2_2");
  EXPECT_EQ(names.unique("a_b"), "a_b_3");
  EXPECT_TRUE(names.has("a_b_3"));
  EXPECT_FALSE(names.has("a_b_4"));
  EXPECT_EQ(names.unique("ring_"), "ring_");
  EXPECT_EQ(names.unique("ring_"), "ring_2_");
}

TEST(Names, NeverCollideWhateverIsAskedFor) {
  std::mt19937 random(3);
  Names names;
  std::set<std::string> given;
  for (int i = 0; i < 5000; ++i) {
    std::string wanted = "a";
    for (int k = static_cast<int>(random() % 4); k > 0; --k)
      wanted += random() % 2 == 0 ? "_2" : "_b";
    if (random() % 3 == 0) wanted += "_";
    const std::string name = names.unique(wanted);
    ASSERT_TRUE(given.insert(name).second) << name;
    ASSERT_TRUE(is_identifier(name) || name.ends_with('_')) << name;
  }
}

TEST(Namer, Casing) {
  EXPECT_EQ(camel("pendulum/u_applied"), "PendulumUApplied");
  EXPECT_EQ(snake("pendulum/u_applied"), "pendulum_u_applied");
  EXPECT_EQ(rate_suffix(Rational::parse("29.97").value()), "29p97Hz");
  EXPECT_EQ(rate_suffix(Rational::parse("30/7").value()), "30over7Hz");
  EXPECT_EQ(rate_type(Rational(30)), "eagerx::Rate<30>");
  EXPECT_EQ(rate_type(Rational::parse("12.5").value()), "eagerx::Rate<25, 2>");
}

}  // namespace
}  // namespace eagerx::gen
