// Two programs never write one file: Drafts (claim_output()) and files that grow (TextFile).
#include "runtime/host/base/claim.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "runtime/host/base/text_file.hpp"

namespace eagerx::host {
namespace {

namespace fs = std::filesystem;

/// Another process that has claimed a file while this object lives; `error` is what it got.
class Other {
 public:
  explicit Other(const std::string& path) {
    EXPECT_EQ(pipe(said_), 0);
    EXPECT_EQ(pipe(asked_), 0);
    child_ = fork();
    if (child_ == 0) {
      ::close(asked_[1]);
      int found = claim_output(path);
      char byte = 0;
      const bool good = write(said_[1], &found, sizeof found) == sizeof found;
      _exit(good && read(asked_[0], &byte, 1) == 0 ? 0 : 1);
    }
    EXPECT_EQ(read(said_[0], &error, sizeof error), static_cast<ssize_t>(sizeof error));
  }
  ~Other() {
    ::close(asked_[1]);
    waitpid(child_, nullptr, 0);
    for (const int end : {said_[0], said_[1], asked_[0]}) ::close(end);
  }
  Other(const Other&) = delete;
  Other& operator=(const Other&) = delete;

  int error = -1;

 private:
  int said_[2] = {}, asked_[2] = {};
  pid_t child_ = -1;
};

class Claim : public ::testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/claim_test.XXXXXX";
    folder = mkdtemp(name);
    ASSERT_FALSE(folder.empty());
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string folder;
};

TEST_F(Claim, IsOfOneProcessUntilItEnds) {
  const std::string path = folder + "/policy";
  {
    const Other other(path);
    EXPECT_EQ(other.error, 0);
    EXPECT_TRUE(is_claimed(path));
    EXPECT_EQ(claim_output(path), EWOULDBLOCK);
    EXPECT_EQ(claim_output(folder + "/another"), 0);
    EXPECT_FALSE(fs::exists(path)) << "nothing is made";
  }
  EXPECT_FALSE(is_claimed(path));
  EXPECT_EQ(claim_output(path), 0);
  EXPECT_EQ(claim_output(path), 0) << "what this process has already";
  EXPECT_EQ(Other(path + "2").error, 0);
}

TEST_F(Claim, IsOfTheFileWhateverItsName) {
  fs::create_directory(folder + "/inner");
  fs::create_symlink(folder + "/inner", folder + "/link");
  fs::create_symlink("inner/policy", folder + "/file");
  const Other other(folder + "/inner/policy");
  for (const char* name : {"/inner/../inner/policy", "/link/policy", "/file"})
    EXPECT_EQ(claim_output(folder + name), EWOULDBLOCK) << name;
}

TEST_F(Claim, StaysWhenTheFileIsReplaced) {
  const std::string path = folder + "/table";
  const Other other(path);
  std::ofstream(folder + "/draft") << "text";
  fs::rename(folder + "/draft", path);
  EXPECT_EQ(claim_output(path), EWOULDBLOCK);
}

TEST_F(Claim, KnowsFilesThatGrow) {
  const std::string path = folder + "/run.csv";
  TextFile file;
  ASSERT_TRUE(file.open(path) && file.reserve());
  EXPECT_EQ(Other(path).error, EWOULDBLOCK);
  file.close();
  const Other other(path);
  EXPECT_EQ(other.error, 0);
  TextFile second, third;
  ASSERT_TRUE(second.open(path));
  EXPECT_FALSE(second.reserve());
  ASSERT_TRUE(third.open(folder + "/another") && third.reserve());
}

TEST_F(Claim, IsNotOfDevices) {
  const Other other("/dev/null");
  EXPECT_EQ(other.error, 0);
  EXPECT_EQ(claim_output("/dev/null"), 0);
}

}  // namespace
}  // namespace eagerx::host
