// Foreign JSON.
#include "generator/support/json/json.hpp"

#include <gtest/gtest.h>

#include <string>

#include "generator/support/json/base64.hpp"

namespace eagerx::gen {
namespace {

TEST(Json, ComesBackAsItWas) {
  const Json json{{"text", "a\"\\\n\u00e9"},
                  {"whole", -9007199254740993},
                  {"number", 0.1},
                  {"list", Json::List{true, nullptr, Json::object()}}};
  const auto again = parse_json(dump_json(json));
  ASSERT_TRUE(again);
  EXPECT_EQ(dump_json(*again), dump_json(json));
  EXPECT_EQ(*member(&*again, "whole")->as<std::int64_t>(), -9007199254740993);
  EXPECT_EQ(number_of(member(&*again, "number")), 0.1);
}

TEST(Json, KnowsWhatPythonWrites) {
  const auto json = parse_json(R"({"a": NaN, "b": [Infinity, -Infinity], "NaN": "NaN"})");
  ASSERT_TRUE(json);
  EXPECT_TRUE(member(&*json, "a")->is<std::monostate>());
  EXPECT_EQ(text_of(member(&*json, "NaN")), "NaN") << "texts stay";
}

TEST(Json, RefusesWhatIsNone) {
  const std::string deep(65, '['), fine(64, '[');
  EXPECT_TRUE(parse_json(fine + std::string(64, ']')));
  const std::string cases[] = {
      "",         "{",         "[1,]", "{\"a\": 1, \"a\": 2}",
      "nul",      "[1] 2",     "'a'",  deep + std::string(65, ']'),
      "\"\xff\"", "{\"a\" 1}", "01",   "[" + std::string(2'000'002, ',') + "]"};
  for (const std::string& text : cases) EXPECT_FALSE(parse_json(text)) << text.substr(0, 30);
  std::string many = "[0";
  for (int i = 0; i < 1'000'000; ++i) many += ",0";
  EXPECT_FALSE(parse_json(many + "]")) << "more than a million values";
}

TEST(Json, WhatIsNoUtf8IsReplaced) {
  const std::string text = dump_json(Json{{"name",
                                           "a\xff\xfe"
                                           "b"}});
  EXPECT_NE(text.find("a\ufffd\ufffd"
                      "b"),
            std::string::npos)
      << text;
  EXPECT_TRUE(parse_json(text));
}

TEST(Json, MembersOfWhatIsNoneAreNone) {
  const Json list = Json::List{1, 2};
  EXPECT_EQ(member(&list, "a"), nullptr);
  EXPECT_EQ(member(nullptr, "a"), nullptr);
  EXPECT_EQ(text_of(nullptr), "");
  EXPECT_FALSE(number_of(nullptr));
  EXPECT_EQ(integers_of(&list), (std::vector<std::int64_t>{1, 2}));
  const Json mixed = Json::List{1, 2.5};
  EXPECT_FALSE(integers_of(&mixed));
}

TEST(Json, WholeNumbersThatDoNotFitAreDoubles) {
  const auto json = parse_json("[18446744073709551615, 9223372036854775807]");
  ASSERT_TRUE(json);
  EXPECT_TRUE(json->as<Json::List>()->at(0).is<double>());
  EXPECT_TRUE(json->as<Json::List>()->at(1).is<std::int64_t>());
}

TEST(Base64, ComesBackAsItWas) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(from_base64(base64(bytes)), bytes) << i;
    bytes += static_cast<char>(i * 7);
  }
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(from_base64("Zm9v\nYmFy\n"), "foobar") << "lines";
}

TEST(Base64, RefusesWhatIsNone) {
  for (const char* text : {"Zm9v!", "Zm=v", "Zm9v-_", "Zm	9v"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace eagerx::gen
