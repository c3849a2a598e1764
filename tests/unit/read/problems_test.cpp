// Every problem a text can have, with its exact place.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/read/reading.hpp"

namespace eagerx::gen {
namespace {

TEST(Problems, NotText) {
  expect_error("a: 1\nb: x\xff\n", "E0103", "2:5+1", "not UTF-8 text: byte 0xff in line 2");
  expect_error("ä: \xc3(", "E0103", "1:4+1", "byte 0xc3");
  expect_error(std::string("a: x\0y\n", 7), "E0103", "1:5+1", "control character U+0000 in line 1");
  expect_error("a: 1\r\n\rb: \x1b[0m", "E0103", "3:4+1", "U+001B in line 3");
  expect_error("a: \xc2\x9b", "E0103", "1:4+1", "U+009B");
  expect_error(std::string("\xff\xfe"
                           "a\0:\0",
                           6),
               "E0103", "0:0+0", "UTF-16");
}

TEST(Problems, DuplicateKeys) {
  const Reading reading("a: 1\nb: {c: 1, d: 2, 'c': 3}\na: 2\n");
  ASSERT_EQ(reading.diagnostics.all().size(), 2U) << reading.report();
  const Diagnostic& first = reading.diagnostics.all()[0];
  EXPECT_EQ(first.code, "E0104");
  EXPECT_EQ(place(first.span), "2:17+3");
  ASSERT_EQ(first.notes.size(), 1U);
  EXPECT_EQ(place(first.notes[0].span), "2:5+1");
  const Diagnostic& second = reading.diagnostics.all()[1];
  EXPECT_EQ(second.message, "key `a` appears twice");
  EXPECT_EQ(place(second.span), "3:1+1");
  EXPECT_EQ(place(second.notes.at(0).span), "1:1+1");
  EXPECT_TRUE(reading.root.is_null());
}

TEST(Problems, Indentation) {
  expect_error("a:\n\tb: 1\n", "E0105", "2:1+1", "a tab in the indentation");
  expect_error("a:\n  \t- 1\n", "E0105", "2:3+1", "a tab in the indentation");
  expect_error("a:\n- b: 1\n\tc: 2\n", "E0105", "3:1+1", "a tab in the indentation");
  expect_error("a:\n  b: 1\n c: 2\n", "E0105", "3:2+1", "expected another `key: value`");
  expect_error("a: 1\n  b: 2\n", "E0105", "2:4+1", "`:` is not allowed here");
  expect_error("a: 1\n- b\n", "E0105", "2:1+1", "expected another `key: value`");
  expect_error("a:\n  - b\n  c: 1\n", "E0105", "3:3+1", "expected another `key: value`");
  expect_error("- [a]\n  b\n", "E0105", "2:3+1", "expected another `- item`");
}

TEST(Problems, Colons) {
  expect_error("ä: b: c\n", "E0105", "1:5+1", "`:` is not allowed here");
  expect_error("a:1\nb: 2\n", "E0105", "2:2+1", "`:` is not allowed here");
}

TEST(Problems, Brackets) {
  expect_error("a: {x: 1", "E0105", "1:4+1", "`{` is never closed");
  expect_error("a:\n  - [1, 2\n# end\n\n", "E0105", "2:5+1", "`[` is never closed");
  expect_error("a: [x\nb: 1\n", "E0105", "2:2+1", "expected `,` or `]`");
  expect_error("a: {x: 1 y: 2}\n", "E0105", "1:11+1", "expected `,` or `}`");
  expect_error("a: {x: [1, 2}\n", "E0105", "1:13+1", "does not match");
  expect_error("a: ]\n", "E0105", "1:4+1", "does not match");
  const Reading reading("a: [x\nb: 1\n");
  ASSERT_EQ(reading.diagnostics.all().at(0).notes.size(), 1U);
  EXPECT_EQ(place(reading.diagnostics.all()[0].notes[0].span), "1:4+1");
}

TEST(Problems, Quotes) {
  expect_error("a: 1\nb: \"x\nc: 1\n", "E0105", "2:4+1", "quotation mark is never closed");
  expect_error("b: 'it''s\n", "E0105", "1:4+1", "quotation mark is never closed");
  expect_error("a: [\"x\", \"y]\nb: 1\n", "E0105", "1:10+1", "quotation mark is never closed");
  expect_error("a: \"x\n---\ny\"\n", "E0105", "2:1+3", "inside quotes");
  expect_error("a: \"\\q\"\n", "E0105", "1:5+2", "unknown escape `\\q`");
  expect_error("a: \"xx\\ä\"\n", "E0105", "1:7+2", "unknown escape `\\ä`");
  expect_error("a: \"\\xZZ\"\n", "E0105", "1:5+4", "`\\xZZ` is not a character");
  expect_error("a: \"\\ud800\"\n", "E0105", "1:5+6", "`\\ud800` is not a character");
}

TEST(Problems, Characters) {
  expect_error("a: @x\n", "E0105", "1:4+1", "a value cannot begin with `@`");
  expect_error("a: %x\n", "E0105", "1:4+1", "a value cannot begin with `%`");
  expect_error("a: - b\n", "E0105", "1:4+1", "a list item cannot begin here");
  expect_error("a: | x\n  y\n", "E0105", "1:6+1", "only a comment");
  expect_error("a: |0\n  y\n", "E0105", "1:6+1", "indentation 0");
  expect_error("a: & b\n", "E0105", "1:5+1", "a name is missing after `&`");
  expect_error("a: &x &y b\n", "E0105", "1:7+1", "a second anchor");
}

TEST(Problems, Empty) {
  for (const char* text : {"", "\n", "# only a comment\n\n", "---\n", "~\n", "\xef\xbb\xbf"}) {
    expect_error(text, "E0106", "0:0+0", "the file is empty");
  }
}

TEST(Problems, SeveralDocuments) {
  expect_error("a: 1\n---\nb: 1\n", "E0107", "2:1+3", "a second document");
  expect_error("a: 1\n...\n---\n", "E0107", "3:1+3", "a second document");
  expect_error("[1, 2] x\n", "E0105", "1:8+1", "ended before this");
  expect_error("- a\nb: 1\n", "E0105", "2:1+2", "ended before this");
}

TEST(Problems, Tags) {
  const Reading reading("a: !!python/tuple [1]\nb: !<x:y> z\nc: ! 12\nd: !!str\n");
  ASSERT_EQ(reading.diagnostics.all().size(), 4U) << reading.report();
  const char* places[] = {"1:4+14", "2:4+6", "3:4+1", "4:4+5"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(reading.diagnostics.all()[i].code, "E0108");
    EXPECT_EQ(place(reading.diagnostics.all()[i].span), places[i]);
  }
  EXPECT_NE(reading.report().find("tag `!!python/tuple`"), std::string::npos);
}

TEST(Problems, Aliases) {
  expect_error("a: &anchor 1\nb: *ancor\n", "E0109", "2:4+6", "does not exist");
  EXPECT_EQ(Reading("a: &anchor 1\nb: *ancor\n").diagnostics.all().at(0).help.text,
            "did you mean `*anchor`?");
  expect_error("a: *b\nc: &b 1\n", "E0109", "1:4+2", "does not exist before it");
  expect_error("a: &a [1, *a]\n", "E0109", "1:11+2", "refers to a value that contains it");
  expect_error("a: &a {b: 1}\nc:\n  <<: *a\n  d: 1\n", "E0109", "3:3+2", "merge keys");
  expect_error("a: &k b\n*k : 2\n", "E0111", "2:1+2", "cannot be a key");
}

TEST(Problems, Keys) {
  expect_error("[a]: 1\n", "E0111", "1:1+1", "a list or map");
  expect_error("? {a: b}\n: 1\n", "E0111", "1:3+1", "a list or map");
  expect_error("x: 1\nnull: 3\n", "E0111", "2:1+4", "`null` means nothing");
  expect_error("x: 1\n: 3\n", "E0111", "2:1+1", "a key is missing");
  expect_error("{ , }\n", "E0111", "1:3+1", "a key is missing");
  expect_error("? |\n  a\n: 1\n", "E0111", "1:3+1", "several lines");
  expect_error("? \"a\\nb\"\n: 1\n", "E0111", "1:3+6", "several lines");
}

TEST(Problems, AllInOneRun) {
  const Reading reading("a: !x 1\na: 2\n<<: {}\n~: 1\n[]: 2\nb: {b: 1, b: 2}\n");
  std::string codes;
  for (const Diagnostic& diagnostic : reading.diagnostics.all()) codes += diagnostic.code + " ";
  EXPECT_EQ(codes, "E0108 E0104 E0109 E0111 E0111 E0104 ");
}

TEST(Problems, TooManyStopEarly) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "a: 1\n";
  EXPECT_EQ(Reading(text).diagnostics.error_count(), 100U);
}

}  // namespace
}  // namespace eagerx::gen
