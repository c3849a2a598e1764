// runtime/host/base/files.hpp: every kind of file that may stand where an output goes.
#include "runtime/host/base/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>

namespace eagerx::host {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/eagerx_draft_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void make(const std::string& name, const std::string& content, mode_t mode = 0644) const {
    std::ofstream(path(name)) << content;
    ASSERT_EQ(chmod(path(name).c_str(), mode), 0);
  }
  struct stat status(const std::string& name) const {
    struct stat found {};
    EXPECT_EQ(lstat(path(name).c_str(), &found), 0) << name;
    return found;
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  fs::path folder;
};

TEST_F(OutputFiles, TakesThePlaceOfTheFileAsAWhole) {
  EXPECT_EQ(write_whole(path("q"), "first"), 0);
  {
    AtomicFile draft(path("q"));
    EXPECT_EQ(draft.write("second"), 0);
    EXPECT_EQ(text("q"), "first");
  }
  EXPECT_EQ(text("q"), "first");
  EXPECT_EQ(write_whole(path("q"), "third"), 0);
  EXPECT_EQ(text("q"), "third");
  EXPECT_EQ(files(), 1) << "nothing is left next to it";
}

TEST_F(OutputFiles, LeavesNothingWhereItCannotWrite) {
  EXPECT_EQ(write_whole("/nowhere/file", "x"), ENOENT);
  EXPECT_EQ(write_whole(path("."), "x"), EISDIR);
  make("file", "before");
  EXPECT_EQ(write_whole(path("file/below"), "x"), ENOTDIR);
  EXPECT_EQ(problem_of_output(path("new")), 0);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFiles, AFullDiskLeavesWhatWasThere) {
  make("q", "before");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{3, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  const int error = write_whole(path("q"), "after");
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(error, EFBIG);
  EXPECT_EQ(text("q"), "before");
  EXPECT_EQ(files(), 1);
}

// At 9028afbf, the one was the draft of the other.
TEST_F(OutputFiles, NoOutputIsTheDraftOfAnother) {
  AtomicFile policy(path("q.part")), table(path("q"));
  EXPECT_EQ(policy.write("policy"), 0);
  EXPECT_EQ(table.write("table"), 0);
  EXPECT_EQ(table.put(), 0);
  EXPECT_EQ(policy.put(), 0);
  EXPECT_EQ(text("q.part"), "policy");
  EXPECT_EQ(text("q"), "table");
}

// At 9028afbf, `q.part` was opened through the link, and `precious` was empty then.
TEST_F(OutputFiles, ALinkThatStandsReadyIsNotFollowed) {
  make("precious", "precious");
  ASSERT_EQ(symlink("precious", path("q.part").c_str()), 0);
  EXPECT_EQ(write_whole(path("q"), "new"), 0);
  EXPECT_EQ(text("precious"), "precious");
  EXPECT_EQ(text("q"), "new");
}

TEST_F(OutputFiles, LinksStayAndAreFollowed) {
  ASSERT_EQ(mkdir(path("deep").c_str(), 0755), 0);
  make("deep/file", "before");
  ASSERT_EQ(symlink("deep/file", path("link").c_str()), 0);
  ASSERT_EQ(symlink(path("link").c_str(), path("second").c_str()), 0);
  ASSERT_EQ(symlink("deep/none", path("dangling").c_str()), 0);
  for (const char* name : {"link", "second", "dangling"}) {
    EXPECT_EQ(write_whole(path(name), name), 0) << name;
    EXPECT_TRUE(S_ISLNK(status(name).st_mode)) << name;
    EXPECT_EQ(text(name), name);
  }
  EXPECT_EQ(text("deep/file"), "second");
  EXPECT_EQ(text("deep/none"), "dangling");
  ASSERT_EQ(symlink("round", path("round").c_str()), 0);
  EXPECT_EQ(write_whole(path("round"), "x"), ELOOP);
}

TEST_F(OutputFiles, OwnerAndModeStay) {
  const mode_t mask = umask(027);
  EXPECT_EQ(write_whole(path("new"), "x"), 0);
  umask(mask);
  EXPECT_EQ(status("new").st_mode & 07777U, 0640U);
  make("secret", "before", 0600);
  make("shared", "before", 0666);
  const bool is_root = geteuid() == 0;
  constexpr uid_t kOwner = 12345, kGroup = 54321;
  ASSERT_EQ(is_root ? chown(path("shared").c_str(), kOwner, kGroup) : 0, 0);
  for (const char* name : {"secret", "shared"}) EXPECT_EQ(write_whole(path(name), "after"), 0);
  EXPECT_EQ(status("secret").st_mode & 07777U, 0600U);
  EXPECT_EQ(status("shared").st_mode & 07777U, 0666U);
  EXPECT_EQ(status("shared").st_uid, is_root ? kOwner : geteuid());
  EXPECT_EQ(status("shared").st_gid, is_root ? kGroup : getegid());
}

/// Everything below happens as another user, who may write what is another's.
TEST_F(OutputFiles, WhatCannotBeReplacedAsItIsIsWrittenInto) {
  if (geteuid() != 0) GTEST_SKIP() << "only root has files of other users";
  ASSERT_EQ(chmod(folder.c_str(), 0777), 0);
  make("of_root", "before", 0666);
  ASSERT_EQ(mkdir(path("closed").c_str(), 0755), 0);
  make("closed/open", "a longer text", 0666);
  EXPECT_EXIT(
      {
        constexpr uid_t kOther = 12345;
        if (setgid(kOther) != 0 || setuid(kOther) != 0) std::exit(1);
        const bool both = write_whole(path("of_root"), "after") == 0 &&
                          write_whole(path("closed/open"), "short") == 0;
        std::exit(both && write_whole(path("closed/new"), "x") == EACCES ? 0 : 2);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_EQ(text("of_root"), "after");
  EXPECT_EQ(text("closed/open"), "short");
  EXPECT_EQ(status("of_root").st_uid, 0U);
}

TEST_F(OutputFiles, AReadOnlyFileStays) {
  make("kept", "before", 0444);
  EXPECT_EQ(write_whole(path("kept"), "after"), EACCES) << "for root, too";
  EXPECT_EQ(problem_of_output(path("kept")), EACCES);
  EXPECT_EQ(text("kept"), "before");
}

// At 9028afbf, as root, a file took the place of the device.
TEST_F(OutputFiles, DevicesAndFifosAreWritten) {
  ASSERT_EQ(mkfifo(path("fifo").c_str(), 0600), 0);
  EXPECT_EQ(problem_of_output(path("fifo")), 0) << "which opens nothing";
  EXPECT_EQ(write_whole(path("fifo"), "x"), ENXIO) << "without a reader";
  const int reader = open(path("fifo").c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(write_whole(path("fifo"), "into it"), 0);
  std::array<char, 64> bytes{};
  EXPECT_EQ(read(reader, bytes.data(), bytes.size()), 7);
  close(reader);
  EXPECT_STREQ(bytes.data(), "into it");
  EXPECT_TRUE(S_ISFIFO(status("fifo").st_mode));

  ASSERT_EQ(symlink("/dev/null", path("null").c_str()), 0);
  ASSERT_EQ(symlink("/dev/full", path("full").c_str()), 0);
  EXPECT_EQ(write_whole(path("null"), "x"), 0);
  EXPECT_EQ(write_whole(path("full"), "x"), ENOSPC);
  EXPECT_TRUE(fs::is_character_file(path("null")));
  if (geteuid() == 0 && mknod(path("device").c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) {
    EXPECT_EQ(problem_of_output(path("device")), 0);
    EXPECT_EQ(write_whole(path("device"), "x"), 0);
    EXPECT_TRUE(S_ISCHR(status("device").st_mode));
  }
}

TEST_F(OutputFiles, AnOpenDescriptorIsWritten) {
  const int file = open(path("gone").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(unlink(path("gone").c_str()), 0);
  EXPECT_EQ(write_whole("/proc/self/fd/" + std::to_string(file), "text"), 0);
  std::array<char, 8> bytes{};
  EXPECT_EQ(pread(file, bytes.data(), bytes.size(), 0), 4);
  EXPECT_EQ(files(), 0);
  close(file);
}

TEST_F(OutputFiles, IsPutOverTheExpectedTextOnly) {
  const auto put_over = [&](const std::optional<std::string>& expected, const char* after) {
    AtomicFile draft(path("graph"));
    EXPECT_EQ(draft.write(after), 0);
    return draft.put_over(expected);
  };
  EXPECT_EQ(put_over("x", "y"), ECANCELED);
  EXPECT_EQ(put_over(std::nullopt, "one"), 0);
  EXPECT_EQ(put_over(std::nullopt, "two"), ECANCELED);
  EXPECT_EQ(put_over("zero", "two"), ECANCELED);
  EXPECT_EQ(put_over("one and more", "two"), ECANCELED);
  EXPECT_EQ(put_over("on", "two"), ECANCELED);
  EXPECT_EQ(text("graph"), "one");
  EXPECT_EQ(put_over("one", "two"), 0);
  EXPECT_EQ(text("graph"), "two");
  ASSERT_EQ(symlink("graph", path("link").c_str()), 0);
  {
    AtomicFile draft(path("link"));
    EXPECT_EQ(draft.write("three"), 0);
    EXPECT_EQ(draft.put_over("two"), 0);
  }
  EXPECT_TRUE(S_ISLNK(status("link").st_mode));
  EXPECT_EQ(text("graph"), "three");
  EXPECT_EQ(files(), 2);
}

// Each of them counts in one file by compare and exchange.
TEST_F(OutputFiles, NoneOfManyIsLost) {
  constexpr int kThreads = 4, kEach = 50;
  make("count", "");
  const auto count = [&] {
    for (int i = 0; i < kEach;) {
      const std::string before = text("count");
      AtomicFile draft(path("count"));
      EXPECT_EQ(draft.write(before + "x", Durability::cached), 0);
      const int error = draft.put_over(before);
      EXPECT_TRUE(error == 0 || error == ECANCELED) << error;
      i += error == 0 ? 1 : 0;
    }
  };
  std::array<std::thread, kThreads> threads;
  for (std::thread& thread : threads) thread = std::thread(count);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(text("count").size(), std::size_t{kThreads * kEach});
}

TEST_F(OutputFiles, AnotherProgramWritesTheDraft) {
  {
    AtomicFile draft(path("film.mp4"));
    EXPECT_EQ(draft.make(".mp4"), 0);
    EXPECT_NE(draft.name(), path("film.mp4"));
    EXPECT_TRUE(draft.name().ends_with(".mp4"));
    std::ofstream(draft.name()) << "film";
    EXPECT_EQ(draft.put(), 0);
  }
  EXPECT_EQ(text("film.mp4"), "film");
  ASSERT_EQ(symlink("/dev/null", path("null.mp4").c_str()), 0);
  AtomicFile nowhere(path("null.mp4"));
  EXPECT_EQ(nowhere.make(".mp4"), 0);
  EXPECT_EQ(nowhere.name(), path("null.mp4"));
  EXPECT_EQ(nowhere.put(), 0);
  EXPECT_TRUE(fs::is_character_file(path("null.mp4")));
}

TEST_F(OutputFiles, LongNamesFit) {
  const std::string name(255, 'x');
  EXPECT_EQ(write_whole(path(name), "long"), 0);
  EXPECT_EQ(text(name), "long");
}

// Each of the threads reads, adds and replaces: without the lock, or with one of the file that was
// replaced, some of what the others add is lost.
TEST_F(OutputFiles, WhoHasTheLockSeesWhatTheOthersWrote) {
  constexpr int kThreads = 4, kEach = 50;
  const auto add = [&] {
    for (int i = 0; i < kEach; ++i) {
      const FileLock lock(path("log"));
      EXPECT_EQ(lock.error(), 0);
      EXPECT_EQ(write_whole(path("log"), text("log") + "x", Durability::cached), 0);
    }
  };
  std::array<std::thread, kThreads> threads;
  for (std::thread& thread : threads) thread = std::thread(add);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(text("log").size(), std::size_t{kThreads * kEach});
}

TEST(LeftBehind, DraftsOfKilledProgramsGo) {
  const std::string folder = ::testing::TempDir() + "eagerx_left_behind/";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const pid_t gone = fork();
  if (gone == 0) _exit(0);
  ASSERT_EQ(waitpid(gone, nullptr, 0), gone);
  const std::string dead = folder + ".q.csv." + std::to_string(gone) + ".0x01.part";
  const std::string alive = folder + ".q.csv." + std::to_string(getpid()) + ".0x01.part";
  const std::string other = folder + ".q.csv.name.part";
  for (const std::string& path : {dead, alive, other}) std::ofstream(path) << "half";
  EXPECT_EQ(write_whole(folder + "q.csv", "whole"), 0);
  EXPECT_FALSE(std::filesystem::exists(dead));
  EXPECT_TRUE(std::filesystem::exists(alive));
  EXPECT_TRUE(std::filesystem::exists(other));
}

}  // namespace
}  // namespace eagerx::host
