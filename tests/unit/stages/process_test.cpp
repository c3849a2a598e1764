// Other programs.
#include "generator/support/process/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "generator/support/process/companions.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

using Lines = std::vector<std::string>;

TEST(Process, ItsOutputAndExitCodeAreReported) {
  const auto result = run_process({"sh", "-c", "echo out; echo err >&2; exit 7"});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->exit_code, 7);
  EXPECT_EQ(result->output, "out\nerr\n");
  EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"})->exit_code, -1) << "a signal";
}

TEST(Process, WhatIsNotThereIsNotStarted) {
  EXPECT_FALSE(run_process({"there-is-no-such-program"}));
  EXPECT_FALSE(run_process({"/no/such/program"}));
  EXPECT_EQ(find_program("there-is-no-such-program"), "");
  EXPECT_TRUE(find_program("sh").ends_with("/sh"));
  EXPECT_EQ(find_program("/bin/sh"), "/bin/sh");
  EXPECT_EQ(find_program("/tmp"), "") << "a folder";
}

TEST(Process, WordsAreNotReadByAShell) {
  const auto result = run_process({"printf", "%s|", "a b", "$(id)", "'", "*"});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->output, "a b|$(id)|'|*|");
}

TEST(Process, HasNoInputAndTheCLocale) {
  EXPECT_EQ(run_process({"cat"})->output, "");
  EXPECT_EQ(
      run_process({"sh", "-c", "echo $LC_ALL $MORE"}, {.environment = {{"MORE", "x"}}})->output,
      "C x\n");
}

/// The lines of a program, and whether its output was kept besides.
Lines lines_of(const std::string& script, int input = -1) {
  Lines lines;
  const auto result = run_process(
      {"sh", "-c", script},
      {.input = input, .line = [&](std::string_view line) { lines.emplace_back(line); }});
  EXPECT_TRUE(result && result->output.empty());
  return lines;
}

TEST(Process, LinesComeWhole) {
  EXPECT_EQ(lines_of("printf 'one\\n\\nlast'; echo no >&2"), (Lines{"one", "", "last"}));
  EXPECT_EQ(lines_of("true"), Lines{});
  const Lines many = lines_of("seq 100000");  // longer than a pipe holds
  ASSERT_EQ(many.size(), 100'000U);
  EXPECT_EQ(many[54'320], "54321");
  EXPECT_EQ(lines_of("head -c 300000 /dev/zero | tr '\\0' a").front().size(), 300'000U);
}

TEST(Process, ReadsWhatItIsGiven) {
  const TestFolder folder;
  const int input = open(folder.file("in", "b\na\n").c_str(), O_RDONLY);
  ASSERT_GE(input, 0);
  EXPECT_EQ(lines_of("sort", input), (Lines{"a", "b"}));
  close(input);
}

/// Whether `what` comes true within ten seconds, however busy the machine is.
template <class F>
bool comes_true(F&& what) {
  for (int look = 0; look < 1000; ++look) {
    if (what()) return true;
    usleep(10'000);
  }
  return false;
}

/// A companion that has a child of its own, whose number is in FOLDER/child once both run.
Companion with_child(const std::string& folder) {
  return {{"sh", "-c",
           "sleep 1000 & echo $! >" + folder + "/new && mv " + folder + "/new " + folder +
               "/child; wait"},
          "/dev/null",
          folder + "/child"};
}

TEST(Companions, EndWithTheProcessHoweverItEnds) {
  for (const char* end : {"true", "kill -9 $$"}) {
    const TestFolder outer;
    const std::string& kept = outer.path();
    const std::string folder = kept + "/of_companions";
    std::filesystem::create_directory(folder);
    const pid_t parent = fork();
    if (parent == 0) {
      if (start_companions({with_child(folder)}, folder)) _exit(1);
      std::filesystem::copy_file(folder + "/child", kept + "/child");
      // It becomes another program, as `eagerx-gen run` does.
      execlp("sh", "sh", "-c", end, nullptr);
      _exit(1);
    }
    int status = 0;
    waitpid(parent, &status, 0);
    EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
    pid_t child = 0;
    std::ifstream(kept + "/child") >> child;
    ASSERT_GT(child, 0);
    EXPECT_TRUE(comes_true([&] { return kill(child, 0) != 0; })) << end;
    EXPECT_TRUE(comes_true([&] { return !std::filesystem::exists(folder); })) << end;
  }
}

TEST(Companions, OneThatEndsIsReported) {
  const TestFolder outer;
  const std::string& kept = outer.path();
  const std::string folder = kept + "/of_companions";
  std::filesystem::create_directory(folder);
  const auto problem = start_companions(
      {with_child(folder), {{"sh", "-c", "echo no; exit 3"}, kept + "/log", folder + "/never"}},
      folder);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->which, 1U);
  EXPECT_TRUE(problem->has_ended);
  std::string said;
  std::getline(std::ifstream(kept + "/log"), said);
  EXPECT_EQ(said, "no");
  EXPECT_FALSE(std::filesystem::exists(folder));
}

}  // namespace
}  // namespace eagerx::gen
