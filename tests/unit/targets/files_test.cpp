// targets/linux-sim/files.hpp: inputs are never overwritten, descriptors 0 to 2 are there.
#include "targets/linux-sim/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <functional>

namespace eagerx::linux_sim {
namespace {

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/eagerx_files_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = std::string(name) + "/";
    std::ofstream(folder + "a.csv") << "0\n";
    ASSERT_EQ(symlink("a.csv", (folder + "soft.csv").c_str()), 0);
    ASSERT_EQ(::link((folder + "a.csv").c_str(), (folder + "hard.csv").c_str()), 0);
  }
  void TearDown() override {
    for (const char* name : {"a.csv", "soft.csv", "hard.csv", "fifo"})
      std::remove((folder + name).c_str());
    rmdir(folder.c_str());
  }
  bool is_refused(const std::function<void(Options&)>& set) const {
    Options options;
    set(options);
    return !problem_with_files(options).empty();
  }
  std::string folder;
};

TEST_F(Files, NoOutputIsAnInput) {
  for (const char* name : {"a.csv", "./a.csv", "soft.csv", "hard.csv"}) {
    const std::string other = folder + name;
    const std::string input = folder + "a.csv";
    EXPECT_TRUE(is_refused([&](Options& options) {
      options.agent = target::Agent::csv;
      options.action_file = input;
      options.csv = other;
    })) << name;
    EXPECT_TRUE(is_refused([&](Options& options) {
      options.agent = target::Agent::csv;
      options.action_file = other;
      options.trace = input;
    })) << name;
    EXPECT_TRUE(is_refused([&](Options& options) {
      options.identify = input;
      options.identify_out = other;
    })) << name;
    EXPECT_TRUE(is_refused([&](Options& options) {
      options.csv = input;
      options.trace = other;
    })) << name;
    EXPECT_FALSE(is_refused([&](Options& options) {
      options.action_file = input;  // of another agent: nothing reads it
      options.csv = other;
    })) << name;
  }
  const int file = open((folder + "a.csv").c_str(), O_RDONLY);
  EXPECT_TRUE(is_refused([&](Options& options) {
    options.identify = folder + "a.csv";
    options.identify_out = "/proc/self/fd/" + std::to_string(file);
  })) << "a descriptor";
  close(file);
}

TEST_F(Files, OutputsAreNoFolders) {
  ASSERT_EQ(mkfifo((folder + "fifo").c_str(), 0600), 0);
  EXPECT_TRUE(is_refused([&](Options& options) { options.csv = folder; }));
  for (const std::string& name : {folder + "fifo", std::string("/dev/zero")}) {
    EXPECT_FALSE(is_refused([&](Options& options) { options.csv = name; })) << name;
    EXPECT_TRUE(is_refused([&](Options& options) { options.csv = options.trace = name; }))
        << name << " mixes them";
  }
  EXPECT_FALSE(is_refused([&](Options& options) { options.csv = folder + "new.csv"; }));
  EXPECT_FALSE(is_refused([&](Options& options) { options.csv = folder + "a.csv"; }));
  EXPECT_FALSE(is_refused([&](Options& options) { options.csv = options.trace = "/dev/null"; }));
}

TEST_F(Files, TheSummaryDoesNotGoIntoATable) {
  const std::string path = folder + "a.csv";
  EXPECT_EXIT(
      {
        dup2(open(path.c_str(), O_WRONLY), STDOUT_FILENO);
        Options options;
        options.csv = path;
        std::exit(problem_with_files(options).empty() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(Files, NoFileBecomesTheStandardOutput) {
  const std::string path = folder + "a.csv";
  EXPECT_EXIT(
      {
        for (int i = 0; i < 3; ++i) close(i);
        open_standard_files();
        const int file = open(path.c_str(), O_RDONLY);
        const bool written = write(STDOUT_FILENO, "a", 1) == 1;
        std::exit(file > STDERR_FILENO && !written && write(STDERR_FILENO, "a", 1) == 1 ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_F(Files, WhatCannotBePrintedIsSaid) {
  EXPECT_EXIT(
      {
        dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO);
        std::exit(print(stdout, "a summary\n") ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "cannot write to the standard output: No space left on device");
}

}  // namespace
}  // namespace eagerx::linux_sim
