// Files of linux-sim programs: everything arrives, in order, whoever writes it.
#include "targets/linux-sim/text_file.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace eagerx::linux_sim {
namespace {

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
    ASSERT_TRUE(file.open("/dev/full", writing));
    fill(file, expected, 1'500'000);
    EXPECT_FALSE(file.close());
    EXPECT_EQ(file.error(), ENOSPC);
  }
}

}  // namespace
}  // namespace eagerx::linux_sim
