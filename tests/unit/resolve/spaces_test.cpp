// The stages of resolve that work on spaces alone, with their closed values.
#include <gtest/gtest.h>

#include <limits>

#include "generator/graph/resolve/bounds.hpp"
#include "generator/graph/resolve/partial_space.hpp"
#include "generator/graph/resolve/states.hpp"

namespace eagerx::gen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The codes of the problems of `stage`, "E0326".
template <class Stage>
std::string codes_of(Stage&& stage) {
  Diagnostics diagnostics;
  stage(diagnostics);
  std::string codes;
  for (const Diagnostic& each : diagnostics.all()) codes += each.code;
  return codes;
}

TEST(Bounds, AreOneNumberOrOneForEachElementWithRoomBetweenThem) {
  struct Row {
    Space space;
    std::string codes;
  };
  const std::vector<Row> rows = {
      {{Dtype::float32, {2}, {}, {}}, ""},
      {{Dtype::float32, {2}, {-1.0}, {1.0}}, ""},
      {{Dtype::float32, {2}, {-1.0, 0.0}, {1.0}}, ""},
      {{Dtype::float32, {2}, {-1.0, 0.0, 1.0}, {1.0}}, "E0326"},
      {{Dtype::float32, {2}, {-kInfinity}, {kInfinity}}, ""},
      {{Dtype::float32, {}, {}, {1e39}}, "E0326"},  // beyond float32
      {{Dtype::float64, {}, {}, {1e39}}, ""},
      {{Dtype::int64, {}, {0.5}, {}}, "E0326"},
      {{Dtype::int64, {}, {}, {kInfinity}}, "E0326"},
      {{Dtype::uint8, {}, {-1.0}, {}}, "E0326"},
      {{Dtype::float32, {}, {1.0}, {1.0}}, ""},
      {{Dtype::float32, {2}, {0.0, 2.0}, {1.0}}, "E0326"},
      {{Dtype::float32, {}, {0.1}, {static_cast<double>(0.1F)}}, ""},  // equal as float32
      {{Dtype::float32, {}, {static_cast<double>(0.1F)}, {0.1}}, ""},
      {{Dtype::float64, {}, {static_cast<double>(0.1F)}, {0.1}}, "E0326"},
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(codes_of([&](Diagnostics& all) { check_bounds(rows[i].space, {}, all); }),
              rows[i].codes)
        << i;
  }
}

TEST(Bounds, OfAnElement) {
  EXPECT_EQ(bound_of({}, 3, 7.0), 7.0);
  EXPECT_EQ(bound_of({2.0}, 3, 7.0), 2.0);
  EXPECT_EQ(bound_of({2.0, 4.0}, 1, 7.0), 4.0);
  EXPECT_EQ(bound_of({2.0, 4.0}, 2, 7.0), 7.0);
}

PartialSpace partial(std::optional<Dtype> dtype, std::optional<std::vector<std::uint64_t>> shape,
                     std::vector<double> low = {}, std::vector<double> high = {}) {
  PartialSpace space;
  space.dtype = dtype;
  space.shape = std::move(shape);
  space.low = std::move(low);
  space.high = std::move(high);
  return space;
}

TEST(PartialSpace, IsCompleteWithADtypeAndAShape) {
  EXPECT_FALSE(complete(partial(Dtype::float32, std::nullopt)));
  EXPECT_FALSE(complete(partial(std::nullopt, {{2}})));
  const auto space = complete(partial(Dtype::float32, {{2, 3}}, {-1.0}, {1.0}));
  ASSERT_TRUE(space);
  EXPECT_EQ(space->size(), 6U);
  EXPECT_EQ(space->low, std::vector<double>{-1.0});
  EXPECT_EQ(describe(partial_of(*space)), "float32 [2, 3]");
  EXPECT_EQ(describe(partial(std::nullopt, std::nullopt)), "any dtype, any shape");
  EXPECT_EQ(describe(partial(std::nullopt, {{}})), "any dtype []");
}

TEST(PartialSpace, WhatIsOnTopReplacesWhatItSays) {
  const PartialSpace base = partial(Dtype::float32, {{2}}, {-1.0}, {1.0});
  const PartialSpace result = overlay(base, partial(std::nullopt, std::nullopt, {}, {0.5}));
  EXPECT_EQ(result.dtype, Dtype::float32);
  EXPECT_EQ(result.low, base.low);
  EXPECT_EQ(result.high, std::vector<double>{0.5});
  EXPECT_EQ(overlay(base, partial(Dtype::int64, {{3}})).shape, (std::vector<std::uint64_t>{3}));
}

TEST(PartialSpace, NarrowsOnlyToItsOwnDtypeAndShape) {
  const PartialSpace base = partial(Dtype::float32, {{2}});
  struct Row {
    PartialSpace over;
    std::string codes;
  };
  const std::vector<Row> rows = {{partial(Dtype::float32, {{2}}, {0.0}), ""},
                                 {partial(std::nullopt, std::nullopt, {0.0}), ""},
                                 {partial(Dtype::float64, std::nullopt), "E0305"},
                                 {partial(std::nullopt, {{3}}), "E0306"}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(codes_of([&](Diagnostics& all) { narrow(base, rows[i].over, "it", all); }),
              rows[i].codes)
        << i;
  }
}

TEST(PartialSpace, FitsWhatIsNotDeclaredOtherwise) {
  const Space arriving{Dtype::float32, {2}, {}, {}};
  EXPECT_TRUE(fits(partial(std::nullopt, std::nullopt), arriving));
  EXPECT_TRUE(fits(partial(Dtype::float32, {{2}}), arriving));
  EXPECT_FALSE(fits(partial(Dtype::float64, {{2}}), arriving));
  EXPECT_FALSE(fits(partial(Dtype::float32, {{}}), arriving));
}

/// One number, or a list of them.
YamlValue numbers(const std::vector<double>& values) {
  if (values.size() == 1) return made_number(values.front(), {});
  std::vector<YamlValue> items;
  for (const double value : values) items.push_back(made_number(value, {}));
  return made_list(std::move(items), {});
}

TEST(Random, IsSampledWithinItsSpace) {
  const Space space{Dtype::float32, {2}, {-1.0}, {1.0}};
  using Kind = RandomSpec::Kind;
  struct Row {
    Kind kind;
    std::vector<double> first, second;
    std::string codes;
  };
  const std::vector<Row> rows = {
      {Kind::value, {0.5}, {}, ""},
      {Kind::value, {0.5, -0.5}, {}, ""},
      {Kind::value, {0.5, -0.5, 0.0}, {}, "E0327"},
      {Kind::value, {1.5}, {}, "E0327"},
      {Kind::uniform, {-0.5}, {0.5}, ""},
      {Kind::uniform, {0.5}, {-0.5}, "E0327"},
      {Kind::uniform, {-2.0}, {0.5}, "E0327"},
      {Kind::normal, {0.0}, {0.1}, ""},
      {Kind::normal, {0.0}, {-0.1}, "E0327"},
      {Kind::log_uniform, {0.1}, {1.0}, ""},
      {Kind::log_uniform, {0.0}, {1.0}, "E0327"},
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RandomSpec spec;
    spec.kind = rows[i].kind;
    spec.first = numbers(rows[i].first);
    if (!rows[i].second.empty()) spec.second = numbers(rows[i].second);
    EXPECT_EQ(codes_of([&](Diagnostics& all) { read_random("it", space, spec, all); }),
              rows[i].codes)
        << i;
  }
}

}  // namespace
}  // namespace eagerx::gen
