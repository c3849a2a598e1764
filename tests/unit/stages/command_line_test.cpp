// The table of a command line: what is taken, and what is said of what is wrong.
#include "generator/support/command_line/command_line.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "generator/support/command_line/bugs.hpp"

namespace eagerx::gen {
namespace {

using Words = std::vector<std::string>;

struct Program {
  std::string graph, output, format;
  std::vector<std::string> paths, rest;
  bool quiet = false;
  int runs = 0;
  std::string wrong_together;

  CommandLine line() {
    Command make;
    make.name = "make";
    make.about = "make it";
    make.arguments = {required(reads(text("graph", graph, "the graph", "GRAPH"))),
                      writes(text("-o,--output", output, "the file", "FILE")),
                      choice("--format", {"one", "two"}, "form",
                             [this](const std::string& word) { format = word; }),
                      texts("--path", paths, "folders", "FOLDER"), flag("--quiet", quiet, "less")};
    make.check = [this] { return wrong_together; };
    make.run = [this] { return ++runs, int{kDone}; };
    Command pass = make;
    pass.name = "pass";
    pass.rest = Argument{"words", "words for another program", "WORD",
                         [this](const Words& words) { rest = words; }};
    CommandLine all;
    all.top.name = "tool";
    all.top.about = "a tool";
    all.top.commands = {make, pass};
    all.version = "tool 1.2";
    all.default_command = "make";
    return all;
  }
};

/// The exit code; `said` is what was printed to the standard error.
int run(Program& program, Words words, std::string* said = nullptr) {
  testing::internal::CaptureStderr();
  const int code = run_command_line(program.line(), std::move(words));
  const std::string text = testing::internal::GetCapturedStderr();
  if (said != nullptr) *said = text;
  return code;
}

TEST(CommandLine, TakesWhatIsGiven) {
  Program program;
  EXPECT_EQ(run(program, {"make", "a.yaml", "--output=x", "--format", "two", "--path", "p",
                          "--path", "q", "--path", "p", "--quiet"}),
            kDone);
  EXPECT_EQ(program.graph, "a.yaml");
  EXPECT_EQ(program.output, "x");
  EXPECT_EQ(program.format, "two");
  EXPECT_EQ(program.paths, (Words{"p", "q"})) << "what is given twice is kept once";
  EXPECT_TRUE(program.quiet);
  EXPECT_EQ(program.runs, 1);
}

TEST(CommandLine, AFileThatComesFirstIsForTheDefaultCommand) {
  Program program;
  EXPECT_EQ(run(program, {"a.yaml"}), kDone);
  EXPECT_EQ(program.graph, "a.yaml");
}

TEST(CommandLine, WhatIsForAnotherProgramStaysAsItIs) {
  Program program;
  EXPECT_EQ(run(program, {"pass", "a.yaml", "--quiet", "--seed", "1", "--", "--quiet", "-h"}),
            kDone);
  EXPECT_TRUE(program.quiet);
  EXPECT_EQ(program.rest, (Words{"--seed", "1", "--quiet", "-h"}));
}

TEST(CommandLine, SaysWhatIsWrongAndRunsNothing) {
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"make"}, "graph"},
      {{"make", "a.yaml", "--formt", "one"}, "--formt"},
      {{"make", "a.yaml", "--format", "three"}, "three"},
      {{"make", "a.yaml", "--output"}, "--output"},
      {{"make", "a.yaml", "b.yaml"}, "b.yaml"},
      {{"mak", "a.yaml"}, "mak"},
      {{}, "not enough"},
  };
  for (const auto& [words, part] : cases) {
    Program program;
    std::string said;
    EXPECT_EQ(run(program, words, &said), kWrongUsage) << testing::PrintToString(words);
    EXPECT_TRUE(said.starts_with("error: ")) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(program.runs, 0);
  }
}

TEST(CommandLine, ArgumentsThatAreWrongTogetherAreWrongUsage) {
  Program program;
  program.wrong_together = "not both";
  std::string said;
  EXPECT_EQ(run(program, {"make", "a.yaml"}, &said), kWrongUsage);
  EXPECT_NE(said.find("not both"), std::string::npos);
  EXPECT_EQ(program.runs, 0);
}

TEST(CommandLine, PagesHaveEveryCommandAndOption) {
  Program program;
  std::size_t manuals = 0;
  for (const CommandLinePage& page : command_line_pages(program.line())) {
    EXPECT_FALSE(page.path.empty() || page.text.empty());
    if (page.path == "man/tool-make.1") {
      EXPECT_NE(page.text.find("format"), std::string::npos);
    }
    manuals += page.path.starts_with("man/") ? 1U : 0U;
  }
  EXPECT_GE(manuals, 3U);
}

// Most of the generator is compiled without exceptions: what would throw aborts.
TEST(Bugs, AreReportedHoweverTheyEndTheProgram) {
  EXPECT_EQ(reporting_bugs("tool", [] { return 7; }), 7);
  EXPECT_EXIT(reporting_bugs("tool", []() -> int { std::abort(); }),
              testing::ExitedWithCode(kInternal),
              "error: this is a bug in tool: it has aborted\nhelp: please report it");
  const std::vector<int> nothing;
  EXPECT_EXIT(std::exit(reporting_bugs("tool", [&] { return nothing.at(3); })),
              testing::ExitedWithCode(kInternal),
              "error: this is a bug in tool: vector::.*help: please report it");
}

}  // namespace
}  // namespace eagerx::gen
