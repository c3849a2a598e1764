// Files that programs write while they run: everything arrives, in order, from every thread.
#include "runtime/host/base/text_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

/// The clock of the day is set back by this as soon as somebody has looked at it.
static time_t set_back_s = 0;

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const auto result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  if (clock == CLOCK_REALTIME) time->tv_sec += set_back_s;
  return result;
}

namespace eagerx::host {
namespace {

// On 0d2dc587 it waits for an hour, and what a program has written stays in its memory.
TEST(TextFileSignal, WaitsNoLongerWhenTheClockIsSetBack) {
  constexpr unsigned kPatienceS = 10;
  Signal signal;
  set_back_s = 3600;
  alarm(kPatienceS);
  EXPECT_FALSE(signal.acquire_within(1));
  alarm(0);
  set_back_s = 0;
  signal.release();
  EXPECT_TRUE(signal.acquire_within(1));
}

void fill(TextFile& file, std::string& expected, int lines) {
  for (int i = 0; i < lines; ++i) {
    file.number(i);
    file.text("\n");
    expected += std::to_string(i) + "\n";
  }
}

TEST(TextFile, ArrivesCompleteAndInOrder) {
  const std::string path = testing::TempDir() + "text_file_test.txt";
  for (const Writing writing : {Writing::direct, Writing::background}) {
    for (const int lines : {0, 1, 200'000}) {
      TextFile file;
      std::string expected;
      ASSERT_TRUE(file.open(path, writing));
      fill(file, expected, lines);
      EXPECT_TRUE(file.close());
      std::ifstream in(path);
      EXPECT_TRUE(expected == std::string(std::istreambuf_iterator<char>(in), {}));
    }
  }
  std::remove(path.c_str());
}

TEST(TextFile, FullDiskIsSaidOnceAndNothingWaits) {
  for (const Writing writing : {Writing::direct, Writing::background}) {
    TextFile file;
    std::string expected;
    const int full = ::open("/dev/full", O_WRONLY);
    ASSERT_TRUE(file.open(full, writing));
    fill(file, expected, 1'500'000);
    EXPECT_FALSE(file.close());
    EXPECT_EQ(file.error(), ENOSPC);
    ::close(full);
  }
}

TEST(TextFile, InRealTimeTheWriterDoesNotWaitForAStalledReader) {
  const std::string path = ::testing::TempDir() + "text_file_test.fifo";
  std::remove(path.c_str());
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  const int writer = ::open(path.c_str(), O_WRONLY);
  TextFile file;
  ASSERT_TRUE(file.open(writer, Writing::real_time));
  std::string expected;
  fill(file, expected, 1'500'000);  // more than there are buffers
  EXPECT_EQ(file.error(), ETIMEDOUT);
  EXPECT_FALSE(file.close());
  ::close(reader);
  ::close(writer);
  std::remove(path.c_str());
}

std::string content(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(TextFile, WhatIsThereStaysUntilSomethingTakesItsPlace) {
  const std::string path = ::testing::TempDir() + "text_file_test.old";
  for (const Writing writing : {Writing::direct, Writing::background}) {
    std::ofstream(path) << "an earlier run\n";
    {
      TextFile file;
      ASSERT_TRUE(file.open(path, writing));
      file.text("new\n");
      EXPECT_EQ(content(path), "an earlier run\n");
      file.discard();
      EXPECT_EQ(content(path), "an earlier run\n");
    }
    EXPECT_EQ(content(path), "an earlier run\n");
    for (const std::string text : {"new\n", ""}) {
      TextFile file;
      ASSERT_TRUE(file.open(path, writing));
      file.text(text);
      EXPECT_TRUE(file.close());
      EXPECT_EQ(content(path), text) << "shorter than what was there";
      std::ofstream(path) << "an earlier run\n";
    }
    std::remove(path.c_str());
    TextFile file;
    ASSERT_TRUE(file.open(path, writing));
    file.discard();
    EXPECT_NE(access(path.c_str(), F_OK), 0) << "no empty file is left";
  }
}

TEST(TextFile, FoldersAndFifosWithoutAReaderAreRefused) {
  const std::string path = ::testing::TempDir() + "text_file_test.fifo";
  std::remove(path.c_str());
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const auto error_of = [](const std::string& name) {
    TextFile file;
    EXPECT_FALSE(file.open(name)) << name;
    return file.error();
  };
  EXPECT_EQ(error_of(path), ENXIO);
  EXPECT_EQ(error_of(::testing::TempDir()), EISDIR);
  std::remove(path.c_str());
}

// At 9028afbf, only what the shell opened as the standard output could be a FIFO.
TEST(TextFile, AFifoThatSomebodyReadsIsWritten) {
  const std::string path = ::testing::TempDir() + "text_file_test.fifo";
  std::remove(path.c_str());
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  TextFile file;
  ASSERT_TRUE(file.open(path, Writing::background));
  file.text("a row\n");
  EXPECT_TRUE(file.close());
  char bytes[16] = {};
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 6);
  EXPECT_STREQ(bytes, "a row\n");
  ::close(reader);
  std::remove(path.c_str());
}

TEST(TextFile, KnowsItsOwnFileByAnotherName) {
  const std::string folder = ::testing::TempDir();
  TextFile file, same, other, nowhere;
  ASSERT_TRUE(file.open(folder + "text_file_test.a"));
  ASSERT_TRUE(same.open(folder + "./text_file_test.a"));
  ASSERT_TRUE(other.open(folder + "text_file_test.b"));
  EXPECT_TRUE(file.is_same_file(same));
  EXPECT_FALSE(file.is_same_file(other));
  EXPECT_FALSE(file.is_same_file(nowhere));
  EXPECT_TRUE(file.is_same_file(folder + "./text_file_test.a"));
  EXPECT_FALSE(file.is_same_file(folder + "text_file_test.b"));
  EXPECT_FALSE(file.is_same_file(folder + "text_file_test.none"));
  EXPECT_FALSE(nowhere.is_same_file(folder + "text_file_test.a"));
}

TEST(TextFile, IsReservedForOne) {
  const std::string path = ::testing::TempDir() + "text_file_test.reserved";
  for (const bool discards : {false, true}) {
    TextFile first, second, third, null, another_null;
    ASSERT_TRUE(first.open(path) && second.open(path) && third.open(path));
    EXPECT_TRUE(first.reserve());
    EXPECT_FALSE(second.reserve());
    if (discards) {
      first.discard();
    } else {
      first.close();
    }
    EXPECT_TRUE(second.reserve());
    EXPECT_FALSE(third.reserve());
    ASSERT_TRUE(null.open("/dev/null") && another_null.open("/dev/null"));
    EXPECT_TRUE(null.reserve() && another_null.reserve()) << "all may write where nothing stays";
  }
  std::remove(path.c_str());
}

TEST(TextFile, IsFreeBehindItsEndThoughAForkedProcessHasItStill) {
  const std::string path = ::testing::TempDir() + "text_file_test.forked";
  TextFile first, second;
  ASSERT_TRUE(first.open(path) && second.open(path));
  ASSERT_TRUE(first.reserve());
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    ::close(ends[1]);
    char byte = 0;
    _exit(static_cast<int>(read(ends[0], &byte, 1)));  // until the test closes its end
  }
  first.close();
  EXPECT_TRUE(second.reserve());
  ::close(ends[1]);
  waitpid(child, nullptr, 0);
  ::close(ends[0]);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace eagerx::host
