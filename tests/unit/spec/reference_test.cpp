#include "generator/frontend/spec/reference.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

TEST(Reference, IsReadAndWritten) {
  const std::pair<const char*, Reference> cases[] = {
      {"$(rate)", {"rate"}},
      {"$(config limit)", {"config", "limit"}},
      {"$(config limit 0)", {"config", "limit", "0"}},
      {"$(sensors theta rate)", {"sensors", "theta", "rate"}},
  };
  for (const auto& [text, reference] : cases) {
    EXPECT_EQ(parse_reference(text), reference) << text;
    EXPECT_EQ(in_dollars(reference), text);
  }
}

TEST(Reference, OtherTextsAreNone) {
  for (const char* text : {"", "$()", "$( config x)", "$(config  x)", "$(config x )", "config x",
                           "$(config x", "$(config x)-$(config y)", "$(sensors theta rate 1)"})
    EXPECT_FALSE(parse_reference(text)) << text;
}

TEST(Reference, IsNotReadAgainIfItWasMade) {
  YamlValue value = made_reference({"size", "gains"}, {});
  value.text = "as messages show it";
  EXPECT_TRUE(is_expression(value));
  EXPECT_EQ(reference_in(value), (Reference{"size", "gains"}));
}

TEST(Reference, WhatIsQuotedIsAText) {
  YamlValue value = made_scalar("$(config x)", {});
  EXPECT_TRUE(reference_in(value));
  EXPECT_TRUE(is_expression(value));
  value.quoted = true;
  EXPECT_FALSE(reference_in(value));
  EXPECT_FALSE(is_expression(value));
}

}  // namespace
}  // namespace eagerx::gen
