// Files that cannot be read, and real ones that can.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/unit/read/reading.hpp"

namespace eagerx::gen {
namespace {

/// A folder of this test alone, removed afterwards.
class File : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("eagerx_read_" + std::to_string(getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  YamlValue read(const std::string& file, Tags tags = Tags::refuse) {
    return read_yaml_file(file, sources_, diagnostics_, tags);
  }
  void expect_unreadable(const std::string& file, const std::string& reason) {
    EXPECT_TRUE(read(file).is_null());
    ASSERT_EQ(diagnostics_.error_count(), 1U);
    const Diagnostic& error = diagnostics_.all()[0];
    EXPECT_EQ(error.code, "E0101");
    EXPECT_TRUE(error.io);
    EXPECT_EQ(sources_.name(error.span.file), file);
    EXPECT_EQ(error.message, "cannot read `" + file + "`: " + reason);
  }

  SourceMap sources_;
  Diagnostics diagnostics_;

 private:
  std::filesystem::path folder_;
};

TEST_F(File, Missing) {
  expect_unreadable(path("none.yaml"), "no such file or directory");
}
TEST_F(File, EmptyName) {
  expect_unreadable("", "no such file or directory");
}
TEST_F(File, Directory) {
  expect_unreadable(path("."), "it is a directory");
}
TEST_F(File, PathThroughAFile) {
  expect_unreadable(write("a.yaml", "a: 1") + "/b.yaml", "not a directory");
}

TEST_F(File, NoPermission) {
  const std::string file = write("a.yaml", "a: 1");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const bool root = geteuid() == 0;  // may read everything, so somebody else must try
  constexpr uid_t kNobody = 65534;
  std::filesystem::permissions(path("."), std::filesystem::perms::all);
  ASSERT_TRUE(!root || seteuid(kNobody) == 0);
  expect_unreadable(file, "permission denied");
  ASSERT_TRUE(!root || seteuid(0) == 0);
}

TEST_F(File, FailsWhileReading) {
  const std::string file = "/proc/self/mem";  // opens, but nothing is mapped at address 0
  expect_unreadable(file, "input/output error");
}

TEST_F(File, HugeFileIsRefusedUnread) {
  const std::string file = write("huge.yaml", "");
  std::filesystem::resize_file(file, 1ULL << 40U);  // a terabyte of holes: reading it would show
  EXPECT_TRUE(read(file).is_null());
  ASSERT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_EQ(diagnostics_.all()[0].code, "E0102");
  EXPECT_EQ(diagnostics_.all()[0].message, "the file is larger than 16777216 bytes");
}

TEST_F(File, DevicesAndPipesAreRefused) {
  const std::string pipe = write("pipe.yaml", "");
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);  // it never gets a writer
  for (const std::string& path : {std::string("/dev/zero"), pipe}) {
    diagnostics_ = {};
    EXPECT_TRUE(read(path).is_null());
    ASSERT_EQ(diagnostics_.error_count(), 1U);
    EXPECT_EQ(diagnostics_.all()[0].code, "E0101");
  }
}

TEST_F(File, Good) {
  const std::string file = write("a.yaml", "a: 1\r\n");
  EXPECT_EQ(show(read(file)), "1:1+1 {1:1+1 a: 1:4+1 1}");
  EXPECT_EQ(sources_.name(FileId{0}), file);
  EXPECT_EQ(sources_.text(FileId{0}), "a: 1\n");
}

TEST_F(File, GraphSavedByEagerx) {
  const std::string file = std::string(EAGERX_SOURCE_DIR) + "/tests/data/read/eagerx_graph.yaml";
  const YamlValue root = read(file, Tags::accept);
  EXPECT_EQ(render_text(diagnostics_, sources_, false), "");
  const YamlValue* backup = root.find("backup");
  ASSERT_NE(backup, nullptr);
  const YamlValue* environment = backup->find("environment");
  ASSERT_NE(environment, nullptr);
  const YamlValue* rate = environment->find("config")->find("rate");
  ASSERT_NE(rate, nullptr);
  EXPECT_TRUE(rate->is_null());
  EXPECT_EQ(place(rate->span), "13:13+4");
}

TEST_F(File, AMegabyteOfEagerx) {
  const std::string source = std::string(EAGERX_SOURCE_DIR) + "/tests/data/read/eagerx_graph.yaml";
  std::ifstream stream(source, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  ASSERT_FALSE(text.empty());
  std::string all;
  std::size_t copies = 0;
  for (; all.size() < 1'000'000; ++copies) {
    all += "copy" + std::to_string(copies) + ":\n";
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      all += "  " + text.substr(begin, end - begin) + "\n";
      begin = end + 1;
    }
  }
  const YamlValue root = read(write("big.yaml", all), Tags::accept);
  EXPECT_EQ(render_text(diagnostics_, sources_, false), "");
  ASSERT_EQ(root.entries.size(), copies);
  EXPECT_EQ(root.entries.back().value.entries.size(), root.entries.front().value.entries.size());
}

}  // namespace
}  // namespace eagerx::gen
