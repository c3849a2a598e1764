// Code that libraries of environments share: rows of states, text, and errors of calls.
#include <gtest/gtest.h>
#include <targets/environments/eagerx_environments.h>

#include <cfenv>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <targets/environments/base/checks.hpp>
#include <targets/environments/base/columns.hpp>
#include <targets/environments/base/description.hpp>
#include <targets/environments/base/fields.hpp>
#include <targets/environments/base/place_of_reward.hpp>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/base/state_rows.hpp>
#include <vector>

namespace eagerx::environments {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The message of eagerx_error() after a call of f.
template <class F>
std::string error_of(F&& f) {
  try {
    f();
    return "";
  } catch (...) {
    EXPECT_EQ(fail_as_caught(), -1);
    return error_text();
  }
}

TEST(Problems, AreKeptAsTexts) {
  EXPECT_EQ(error_of([] { refuse("no"); }), "no");
  EXPECT_EQ(error_of([] { throw std::bad_alloc(); }), "not enough memory");
  EXPECT_EQ(error_of([] { throw 1; }), "something unknown was thrown");
  const auto again = std::make_error_code(std::errc::resource_unavailable_try_again);
  EXPECT_EQ(error_of([&] { throw std::system_error(again); }),
            "the system gives no more threads: " + again.message());
}

TEST(Options, AreInRange) {
  eagerx_options options{};
  options.size = sizeof(options);
  options.environments = 4;
  EXPECT_EQ(error_of([&] { check_options(&options); }), "");
  EXPECT_EQ(error_of([] { check_options(nullptr); }), "options is null");
  options.autoreset = 3;
  EXPECT_EQ(error_of([&] { check_options(&options); }), "autoreset is 3, not 0 to 2");
  options.environments = 0;
  EXPECT_EQ(error_of([&] { check_options(&options); }),
            "environments is 0, not 1 to " + std::to_string(EAGERX_ENVIRONMENTS_MOST));
  options.size = 1;
  EXPECT_EQ(error_of([&] { check_options(&options); }),
            "eagerx_options is of another version: its size is 1, not " +
                std::to_string(sizeof(options)));
  EXPECT_EQ(error_of([] { check_number(4, 4); }), "there is no environment 4, but 0 to 3");
  EXPECT_EQ(error_of([] { check_rows("action", nullptr, 0); }), "");
  EXPECT_EQ(error_of([] { check_rows("action", nullptr, 1); }), "action is null");
  EXPECT_EQ(error_of([] { check_side("width", 0, 16); }), "width is 0, not 1 to 16");
}

TEST(Floats, AreRightDuringACallAndAsBeforeBehindIt) {
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  {
    const RightFloats right;
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
}

TEST(Columns, AreInTheOrderOfTheirNames) {
  Columns columns;
  columns.add("speed", 2);
  columns.add("angle", 3);
  columns.arrange();
  EXPECT_EQ(columns.first(0), 3U);
  EXPECT_EQ(columns.first(1), 0U);
  EXPECT_EQ(columns.numbers(), 5U);
  EXPECT_EQ(columns.order(), (std::vector<std::size_t>{1, 0}));
}

/// [mass, position 0, position 1]: the mass is sampled and can be tuned, the position is neither.
StateRows two_states() {
  StateRows states;
  states.add({"position", {-1, -1}, {1, 1}, false, false});
  states.add({"mass", {0.5F}, {2.0F}, true, true});
  states.arrange();
  return states;
}

TEST(StateRows, AreOfTheirSpacesAndWhole) {
  const StateRows states = two_states();
  const auto error = [&](std::vector<float> row, bool tunes = false) {
    return error_of([&] {
      tunes ? states.check_tuning(1, nullptr, row.data()) : states.check(1, nullptr, row.data());
    });
  };
  EXPECT_EQ(error({1, 0, 0}), "");
  EXPECT_EQ(error({kNan, kNan, kNan}), "");
  EXPECT_EQ(error({1, 0, 1.5F}),
            "`position` is out of its space: element 1 is 1.5 (environment 0)");
  EXPECT_EQ(error({1, 0, kNan}),
            "`position` is not sampled: set all of its elements, or none (environment 0)");
  EXPECT_EQ(error({1, kNan, kNan}, true), "");
  EXPECT_EQ(error({1, 0, 0}, true),
            "`position` can be set at a reset, not while an episode runs; what can: mass "
            "(environment 0)");
  EXPECT_EQ(states.describe_tunable(), "[\"mass\"]");
}

TEST(StateRows, AreLookedAtWhereTheMaskSaysSo) {
  const StateRows states = two_states();
  const float rows[] = {9, 0, 0, 1, 0, 0};  // the first mass is too large
  const std::uint8_t second[] = {0, 1};
  EXPECT_EQ(error_of([&] { states.check(2, second, rows); }), "");
  EXPECT_EQ(error_of([&] { states.check(2, nullptr, rows); }),
            "`mass` is out of its space: element 0 is 9 (environment 0)");
}

TEST(SetRows, CountForOneEpisode) {
  const StateRows states = two_states();
  SetRows set(states);
  set.begin(0);
  EXPECT_EQ(set.row(0), nullptr);  // nothing was ever set
  const float rows[] = {1, 0, 0.5F, 2, 0, 0};
  const std::uint8_t first[] = {1, 0};
  set.set(2, first, rows);
  EXPECT_TRUE(set.row(0)[0] != set.row(0)[0]);  // not yet
  set.begin(0);
  set.begin(1);
  EXPECT_EQ(set.row(0)[2], 0.5F);
  EXPECT_TRUE(set.row(1)[0] != set.row(1)[0]);
  set.begin(0);
  EXPECT_TRUE(set.row(0)[2] != set.row(0)[2]);
  const float wrong[] = {9, 0, 0, 9, 0, 0};
  EXPECT_NE(error_of([&] { set.set(2, first, wrong); }), "");
  set.begin(0);
  EXPECT_TRUE(set.row(0)[0] != set.row(0)[0]);  // nothing has changed
}

TEST(Description, HasFieldsInTheOrderOfTheirColumns) {
  Columns columns;
  columns.add("b", 4);
  columns.add("a", 1);
  columns.arrange();
  Fields fields(columns);
  fields.add("b", {{2}, "float32"}, 2, {-0.1F, -1}, {0.1F, 1});
  fields.add("a", {{}, "bool"});
  EXPECT_EQ(
      fields.list(),
      "[{\"name\": \"a\", \"shape\": [], \"dtype\": \"bool\", \"window\": 1, \"low\": [null], "
      "\"high\": [null], \"first\": 0}, "
      "{\"name\": \"b\", \"shape\": [2, 2], \"dtype\": \"float32\", \"window\": 2, \"low\": "
      "[-0.1, -1, -0.1, -1], \"high\": [0.1, 1, 0.1, 1], \"first\": 1}]");
}

TEST(Stepping, SaysWhatMadeItSlower) {
  const UsedSimd none{0, ""}, eight{8, "avx2"}, sixteen{16, "avx512"};
  EXPECT_EQ(stepping_text(sixteen, sixteen, 64, false, ""), "vectorized: 16 lanes (avx512)");
  EXPECT_EQ(stepping_text(eight, sixteen, 4, false, ""),
            "vectorized: 8 lanes (avx2); 4 environments are too few for 16 lanes (avx512)");
  EXPECT_EQ(stepping_text(none, sixteen, 1, false, ""),
            "one by one: 1 environment is too few for SIMD lanes");
  EXPECT_EQ(stepping_text(none, sixteen, 64, true, ""), "one by one: their pictures are wanted");
  EXPECT_EQ(stepping_text(none, none, 64, false, "it is large"), "one by one: it is large");
}

TEST(Stages, ThatAreNotThere) {
  EXPECT_EQ(error_of([] { refuse_stage("far", {}); }),
            "there is no stage `far`, but none: the task has no `stages:`");
  const char* const known[] = {"near", "middle"};
  EXPECT_EQ(error_of([&] { refuse_stage("far", known); }),
            "there is no stage `far`, but near, middle");
}

TEST(Counts, AreSumsOfWhatIsNotZero) {
  Counts counts;
  EXPECT_EQ(counts.text(), "{}");
  counts.add("late", 0);
  counts.add("not finite", 2);
  counts.add("not finite", 1);
  EXPECT_EQ(counts.text(), "{\"not finite\": 3}");
}

TEST(Rewards, ThatAreNoNumbersHaveAPlace) {
  EXPECT_EQ(not_finite_text("angle", kNan, {3, 5, 7, 1, 12}),
            "`task.angle` is nan in step 13 of episode 2, both counted from 1, of environment 3 "
            "(seed 7, number 5)");
}

}  // namespace
}  // namespace eagerx::environments
