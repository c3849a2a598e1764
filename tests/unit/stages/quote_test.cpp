// Foreign text in other languages: what reads the language gets the text back.
#include "generator/support/quote/quote.hpp"

#include <gtest/gtest.h>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/json/json.hpp"
#include "generator/support/process/process.hpp"
#include "generator/support/quote/language.hpp"

namespace eagerx::gen {
namespace {

const std::vector<std::string> kTexts = {
    "plain",        "",     " ",    "a b",    "\"",        "'",    "\\",          "a\\nb",
    "$(id)",        "${X}", "`id`", "#",      "# no",      "a: b", "- x",         "{a}",
    "[1]",          "null", "1e-3", "yes",    "0x10",      "~",    "*",           "?",
    "%s",           "*/",   "//",   "]]",     ";",         "&&",   "line\nbreak", "tab\tstop",
    "\u00e9\u4e2d", "@a@",  "!x",   "a\x01z", "trailing\\"};

TEST(Quote, AShellReadsAWordAsItWas) {
  for (const std::string& text : kTexts) {
    const auto result = run_process(
        {"sh", "-c",
         "printf %s " + shell_word(text) + "; printf %s \"|" + in_shell_string(text) + "\""});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->output, text + "|" + text);
  }
}

TEST(Quote, YamlReadsAStringAsItWas) {
  for (const std::string& text : kTexts) {
    for (const std::string& written : {yaml_string(text), yaml_text(text)}) {
      SourceMap sources;
      Diagnostics diagnostics;
      const YamlValue tree = read_yaml_text("a.yaml", "a: " + written + "\n", sources, diagnostics);
      ASSERT_TRUE(diagnostics.all().empty()) << written;
      const YamlValue* value = tree.find("a");
      ASSERT_NE(value, nullptr) << written;
      EXPECT_EQ(value->text, text) << written;
    }
  }
}

TEST(Quote, JsonReadsAStringAsItWas) {
  for (const std::string& text : kTexts) {
    const auto json = parse_json("\"" + in_json_string(text) + "\"");
    ASSERT_TRUE(json) << text;
    EXPECT_EQ(text_of(&*json), text);
  }
}

TEST(Quote, CppEscapesWhatWouldEndTheLiteral) {
  EXPECT_EQ(cpp_string("a\"b\\c\nd"), "\"a\\\"b\\\\c\\012d\"");
  for (const std::string& text : kTexts) {
    const std::string literal = cpp_string(text);
    EXPECT_EQ(literal.find('\n'), std::string::npos) << text;
  }
}

TEST(Quote, ACommentStaysOnItsLineAndEndsNone) {
  for (const std::string& text : kTexts) {
    const std::string comment = in_comment(text);
    EXPECT_EQ(comment.find('\n'), std::string::npos) << text;
    EXPECT_EQ(comment.find("*/"), std::string::npos) << text;
    EXPECT_FALSE(comment.ends_with('\\')) << text;
  }
  EXPECT_NE(in_comment("a\u202e"
                       "b")
                .find("202e"),
            std::string::npos)
      << "what turns the line around is seen";
}

TEST(Quote, XmlHasNoForeignMarkup) {
  EXPECT_EQ(xml_text("<a b=\"c\">&'"), "&lt;a b=&quot;c&quot;&gt;&amp;&#39;");
}

TEST(Quote, MakeCannotWriteEveryPath) {
  EXPECT_EQ(make_path("a b$c#d"), "a\\ b$$c\\#d");
  EXPECT_TRUE(is_make_path("a b"));
  EXPECT_FALSE(is_make_path("a\nb"));
}

TEST(Quote, PlainWordsNeedNoQuotesAnywhere) {
  EXPECT_TRUE(is_plain_word("a/b-c.d+e_1"));
  for (const char* text : {"", "a b", "a$b", "a\n", "\u00e9", "a;b"})
    EXPECT_FALSE(is_plain_word(text)) << text;
  EXPECT_TRUE(is_plain_path("a/b.c"));
  for (const char* text : {"", "/a", "a//b", "../a", "a/..", "a/./b", "a/"})
    EXPECT_FALSE(is_plain_path(text)) << text;
}

/// A template of a language with a value between its halves; nothing if the value may not stand
/// there.
std::optional<std::string> put(const char* path, std::string_view before, std::string_view value,
                               std::string_view after) {
  Quoter quoter(language_of(path));
  quoter.add(before);
  if (!quoter.add_value(value)) return std::nullopt;
  quoter.add(after);
  return quoter.take();
}

TEST(Quote, AValueIsWhatItsPlaceMakesOfIt) {
  EXPECT_EQ(put("a.cpp", "x = \"", "say \"hi\"", "\";"), "x = \"say \\\"hi\\\"\";");
  EXPECT_EQ(put("a.cpp", "f(", "1 + 2", ");"), "f(1 + 2);");
  EXPECT_EQ(put("a.cpp", "f(", "\"open", ");"), std::nullopt)
      << "opens a string and does not close it";
  EXPECT_EQ(put("a.cpp", "f(", "1 // ", ");"), std::nullopt) << "begins a comment";
  EXPECT_EQ(put("a.cpp", "auto x = R\"(", ")\" + y", ")\";"), std::nullopt)
      << "nothing can be escaped there";
  EXPECT_EQ(put("CMakeLists.txt", "set(x ", "a b", ")"), "set(x \"a b\")");
}

}  // namespace
}  // namespace eagerx::gen
