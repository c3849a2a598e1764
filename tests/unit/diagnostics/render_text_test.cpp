#include <gtest/gtest.h>

#include <string>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {
namespace {

/// A file of `lines` empty lines with `text` as the last one.
std::string at_line(std::size_t line, const std::string& text) {
  return std::string(line - 1, '\n') + text;
}

TEST(RenderText, LooksLikeTheSampleOfTheDesign) {
  SourceMap sources;
  const FileId file =
      sources.add("graph.yaml", at_line(41, "      - {from: pid.u, to: motor.u}\n"));
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error(
      "E0312", {file, 41, 16, 5}, "connection `pid.u -> motor.u` closes a cycle without a delay");
  error.label = "needs `motor.u` of the same tick";
  error.notes.push_back({"the cycle continues here", {file, 36, 9, 1}, ""});
  error.help = "add `skip: true` to one of these connections";
  EXPECT_EQ(render_text(diagnostics, sources, false),
            "error[E0312]: connection `pid.u -> motor.u` closes a cycle without a delay\n"
            "  --> graph.yaml:41:16\n"
            "   |\n"
            "41 |       - {from: pid.u, to: motor.u}\n"
            "   |                ^^^^^ needs `motor.u` of the same tick\n"
            "note: the cycle continues here\n"
            "  --> graph.yaml:36:9\n"
            "help: add `skip: true` to one of these connections\n"
            "\n"
            "1 error\n");
}

TEST(RenderText, ShowsTheFirstHundredOfEachSeverity) {
  Diagnostics diagnostics;
  for (int i = 0; i < 300'000; ++i) diagnostics.warning("W0001", {}, "odd");
  for (int i = 0; i < 101; ++i) diagnostics.error("E0001", {}, "wrong");
  const std::string text = render_text(diagnostics, {}, false);
  const auto count = [&](const std::string& word) {
    int found = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("warning[W0001]"), 100);
  EXPECT_EQ(count("error[E0001]"), 100);
  EXPECT_TRUE(text.ends_with("and 299901 more\n\n101 errors, 300000 warnings\n")) << text;
}

TEST(RenderText, NoteWithLabelShowsItsLineAndSharesTheGutter) {
  SourceMap sources;
  const FileId file = sources.add("a.yaml", "first: 1\n" + at_line(119, "second: 2"));
  Diagnostics diagnostics;
  Diagnostic& warning = diagnostics.warning("E0001", {file, 1, 1, 5}, "message");
  warning.notes.push_back({"other", {file, 120, 1, 6}, "here"});
  EXPECT_EQ(render_text(diagnostics, sources, false),
            "warning[E0001]: message\n"
            "   --> a.yaml:1:1\n"
            "    |\n"
            "  1 | first: 1\n"
            "    | ^^^^^\n"
            "note: other\n"
            "   --> a.yaml:120:1\n"
            "    |\n"
            "120 | second: 2\n"
            "    | ^^^^^^ here\n"
            "\n"
            "1 warning\n");
}

TEST(RenderText, CountsErrorsAndWarnings) {
  const SourceMap sources;
  Diagnostics diagnostics;
  EXPECT_EQ(render_text(diagnostics, sources, false), "");
  diagnostics.error("E1", {}, "a");
  diagnostics.io_error("E2", {}, "b");
  diagnostics.warning("E3", {}, "c");
  EXPECT_EQ(render_text(diagnostics, sources, false),
            "error[E1]: a\n\nerror[E2]: b\n\nwarning[E3]: c\n\n2 errors, 1 warning\n");
  EXPECT_EQ(diagnostics.error_count(), 2U);
  EXPECT_TRUE(diagnostics.has_io_errors());
  EXPECT_TRUE(diagnostics.all()[1].io);
}

TEST(RenderText, WholeFileHasNoLine) {
  SourceMap sources;
  const FileId file = sources.add("a.yaml", "x: 1\n");
  Diagnostics diagnostics;
  diagnostics.error("E1", {file, 0, 0, 0}, "empty");
  EXPECT_EQ(render_text(diagnostics, sources, false), "error[E1]: empty\n --> a.yaml\n\n1 error\n");
}

/// The two lines that show the span.
std::string excerpt(const std::string& line, std::uint32_t column, std::uint32_t length) {
  SourceMap sources;
  const FileId file = sources.add("a", line);
  Diagnostics diagnostics;
  diagnostics.error("E", {file, 1, column, length}, "m").label = "here";
  const std::string text = render_text(diagnostics, sources, false);
  const std::string head = "error[E]: m\n --> a:1:" + std::to_string(column) + "\n  |\n";
  const std::string tail = "\n\n1 error\n";
  EXPECT_TRUE(text.starts_with(head)) << text;
  EXPECT_TRUE(text.ends_with(tail)) << text;
  return text.substr(head.size(), text.size() - head.size() - tail.size());
}

TEST(RenderText, TabsAreFourColumns) {
  EXPECT_EQ(excerpt("\ta:\tb", 5, 1),
            "1 |     a:    b\n"
            "  |           ^ here");
  EXPECT_EQ(excerpt("\ta", 1, 1),
            "1 |     a\n"
            "  | ^^^^ here");
}

TEST(RenderText, WideAndCombiningCharacters) {
  EXPECT_EQ(excerpt("ä: 漢字 x", 4, 2),
            "1 | ä: 漢字 x\n"
            "  |    ^^^^ here");
  EXPECT_EQ(excerpt("e\xcc\x81: x", 5, 1),
            "1 | e\xcc\x81: x\n"
            "  |    ^ here");
}

TEST(RenderText, UnprintableCharactersAreReplaced) {
  EXPECT_EQ(excerpt("a\x1b[0m\xff z", 7, 1),
            "1 | a\xef\xbf\xbd[0m\xef\xbf\xbd z\n"
            "  |       ^ here");
}

TEST(RenderText, SpanPastTheEndIsClipped) {
  EXPECT_EQ(excerpt("abc", 2, 1000),
            "1 | abc\n"
            "  |  ^^ here");
  EXPECT_EQ(excerpt("abc", 4000000000U, 4000000000U),
            "1 | abc\n"
            "  |    ^ here");
}

TEST(RenderText, LongLinesAreCutAroundTheSpan) {
  const std::string line = std::string(500, 'a') + "HERE" + std::string(500, 'b');
  EXPECT_EQ(excerpt(line, 501, 4), "1 | …" + std::string(30, 'a') + "HERE" + std::string(66, 'b') +
                                       "…\n  | " + std::string(31, ' ') + "^^^^ here");
  EXPECT_EQ(excerpt(line, 1, 1), "1 | " + std::string(100, 'a') + "…\n  | ^ here");
  // Near the end the hundred columns are filled from the left.
  EXPECT_EQ(excerpt(line, 1004, 1),
            "1 | …" + std::string(100, 'b') + "\n  | " + std::string(100, ' ') + "^ here");
  // A span longer than what is shown has carets up to the cut.
  EXPECT_EQ(excerpt(line, 501, 500), "1 | …" + std::string(30, 'a') + "HERE" +
                                         std::string(66, 'b') + "…\n  | " + std::string(31, ' ') +
                                         std::string(70, '^') + " here");
}

TEST(RenderText, MessagesCannotControlTheTerminal) {
  SourceMap sources;
  const FileId file = sources.add("a\n\x1b.yaml", "x");
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error("E", {file, 1, 1, 1}, "key `\x1b[31m\n\xff\xe2\x80\xae`");
  error.help = "one\ntwo";
  EXPECT_EQ(render_text(diagnostics, sources, false),
            "error[E]: key `\\x1b[31m\\n\\xff\\u202e`\n"
            " --> a\\n\\x1b.yaml:1:1\n"
            "  |\n"
            "1 | x\n"
            "  | ^\n"
            "help: one\n"
            "      two\n"
            "\n"
            "1 error\n");
}

TEST(RenderText, ColorsOnlyAddEscapes) {
  SourceMap sources;
  const FileId file = sources.add("a.yaml", "x: 1");
  Diagnostics diagnostics;
  Diagnostic& error = diagnostics.error("E1", {file, 1, 1, 1}, "m");
  error.label = "l";
  error.notes.push_back({"n", {file, 1, 4, 1}, "here"});
  error.help = "h";
  const std::string colored = render_text(diagnostics, sources, true);
  EXPECT_NE(colored.find("\x1b[1;31merror[E1]\x1b[0m"), std::string::npos) << colored;
  std::string stripped;
  for (std::size_t i = 0; i < colored.size(); ++i) {
    if (colored[i] == '\x1b') {
      i = colored.find('m', i);
    } else {
      stripped += colored[i];
    }
  }
  EXPECT_EQ(stripped, render_text(diagnostics, sources, false));
}

TEST(SourceMap, Lines) {
  SourceMap sources;
  const FileId file = sources.add("a", "one\r\ntwo\n\nfour");
  EXPECT_EQ(sources.line(file, 0), "");
  EXPECT_EQ(sources.line(file, 1), "one");
  EXPECT_EQ(sources.line(file, 2), "two");
  EXPECT_EQ(sources.line(file, 3), "");
  EXPECT_EQ(sources.line(file, 4), "four");
  EXPECT_EQ(sources.line(file, 5), "");
  EXPECT_EQ(sources.line(FileId::none, 1), "");
  EXPECT_EQ(sources.name(FileId::none), "");
  EXPECT_EQ(sources.name(file), "a");
}

}  // namespace
}  // namespace eagerx::gen
