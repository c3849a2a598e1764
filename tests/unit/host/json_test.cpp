// runtime/host/base: JSON that somebody else has written.
#include <gtest/gtest.h>

#include <runtime/host/base/json.hpp>
#include <runtime/host/base/json_reader.hpp>
#include <string>

namespace eagerx::host {
namespace {

TEST(Json, IsCompactOrSpaced) {
  for (const auto& [style, text] :
       {std::pair(Json::Style::spaced, R"({"a": [1, 2, 3], "b": [], "c": "x"})"),
        {Json::Style::compact, R"({"a":[1,2, 3],"b":[],"c":"x"})"}}) {
    Json json(style);
    json.begin_object().key("a").begin_list().whole(1).written("2, 3").end_list();
    json.key("b").begin_list().written("").end_list().key("c").text("x").end_object();
    EXPECT_EQ(json.str(), text);
  }
}

TEST(JsonReader, ReadsWhatRfc8259Says) {
  const auto value = read_json(
      " {\"a\" : [1, -0.5e+2, true, null, \"\\u00e9\\ud83d\\ude00\\n\\\"\"], \"b\":{}, \"a\":2} ");
  ASSERT_TRUE(value);
  const JsonValue* const a = value->find("a");
  ASSERT_TRUE(a != nullptr && a->items.size() == 5);
  EXPECT_EQ(a->items[1].number, -50.0);
  EXPECT_TRUE(a->items[2].boolean);
  EXPECT_EQ(a->items[3].kind, JsonValue::Kind::null);
  EXPECT_EQ(a->items[4].text, "\xc3\xa9\xf0\x9f\x98\x80\n\"");
  EXPECT_EQ(value->find("b")->kind, JsonValue::Kind::object);
  EXPECT_EQ(value->find("c"), nullptr);
}

TEST(JsonReader, RefusesAllElse) {
  for (const char* wrong : {"",
                            " ",
                            "{",
                            "[1,]",
                            "[1 2]",
                            "{\"a\"}",
                            "{\"a\":}",
                            "{a:1}",
                            "01",
                            "-",
                            ".5",
                            "5.",
                            "1e",
                            "+1",
                            "inf",
                            "nan",
                            "NaN",
                            "1e999",
                            "tru",
                            "nullx",
                            "\"",
                            "\"\n\"",
                            "\"\\x\"",
                            "\"\\u12\"",
                            "\"\\u12g4\"",
                            "\"\\ud800\"",
                            "\"\\ud800\\u0041\"",
                            "\"\\udc00\"",
                            "1 1",
                            "'a'",
                            "[1]]"})
    EXPECT_FALSE(read_json(wrong)) << wrong;
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_TRUE(read_json(nested(kDeepestJson + 1)));
  EXPECT_FALSE(read_json(nested(kDeepestJson + 2)));
  std::string many = "[0";
  for (std::size_t i = 2; i < kMostJsonValues; ++i) many += ",0";
  EXPECT_TRUE(read_json(many + "]"));
  EXPECT_FALSE(read_json(many + ",0]"));
  EXPECT_TRUE(read_json(many + ",0]", kMostJsonValues + 1));
}

}  // namespace
}  // namespace eagerx::host
