// Files that are replaced by others with an older time.
#include "generator/driver/build/digests.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

class BuildDigests : public testing::Test {
 protected:
  BuildDigests() {
    std::string name = (fs::temp_directory_path() / "eagerx-digests-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::create_directories(folder_ / "build");
  }
  ~BuildDigests() override { fs::remove_all(folder_); }

  /// As cp -p does.
  void replace(const std::string& text, time_t modified_s) const {
    std::ofstream(folder_ / "new") << text;
    const timespec times[2] = {{modified_s, 0}, {modified_s, 0}};
    ASSERT_EQ(utimensat(AT_FDCWD, (folder_ / "new").c_str(), times, 0), 0);
    fs::rename(folder_ / "new", folder_ / "a node.hpp");
  }
  [[nodiscard]] std::string build() const { return (folder_ / "build").string(); }
  void keep() const {
    const std::string listed =
        "CMakeFiles/demo.dir/main.cpp.o: #deps 2, deps mtime 12 (VALID)\n    ../a node.hpp\n"
        "    " +
        (folder_ / "gone.hpp").string() + "\n";
    const std::string text = Digests(build()).now(listed);
    EXPECT_NE(text.find("../a node.hpp\n"), std::string::npos) << text;
    std::ofstream(folder_ / "build" / kDigests) << text;
  }
  [[nodiscard]] bool has_unseen() const {
    return Digests(build()).have_unseen_change({kLastBuildS, 0});
  }

  static constexpr time_t kLastBuildS = 1'000'000;
  fs::path folder_;
};

// As GCC writes them for Make.
TEST_F(BuildDigests, DepfilesListWhatMakeCompiles) {
  fs::create_directories(folder_ / "build/CMakeFiles/demo.dir");
  std::ofstream(folder_ / "build/CMakeFiles/demo.dir/main.cpp.o.d")
      << "CMakeFiles/demo.dir/main.cpp.o: \\\n /tree/main.cpp ../a\\ node.hpp \\\n"
         " /usr/b$$c.hpp /usr/d\\#e.hpp\n/tree/main.cpp:\n";
  const std::string listed = listed_in_depfiles(build());
  EXPECT_NE(listed.find("main.cpp.o.d:\n    /tree/main.cpp\n    ../a node.hpp\n"
                        "    /usr/b$c.hpp\n    /usr/d#e.hpp\n"),
            std::string::npos)
      << listed;
  replace("one", kLastBuildS - 100);
  std::ofstream(folder_ / "build" / kDigests) << Digests(build()).now(listed);
  EXPECT_FALSE(has_unseen());
  replace("two", kLastBuildS - 200);
  EXPECT_TRUE(has_unseen());
}

// At 9028afbf, the program of the older text was run, with its hash.
TEST_F(BuildDigests, ContentsDecideWhereTimesDoNot) {
  EXPECT_FALSE(has_unseen()) << "without a build";
  replace("one", kLastBuildS - 100);
  keep();
  EXPECT_FALSE(has_unseen());
  replace("two", kLastBuildS - 200);
  EXPECT_TRUE(has_unseen()) << "older";
  replace("tw2", kLastBuildS);
  EXPECT_TRUE(has_unseen()) << "as old as the build";
  replace("two", kLastBuildS + 100);
  EXPECT_FALSE(has_unseen()) << "every build tool sees that";
  replace("one", kLastBuildS - 200);
  EXPECT_FALSE(has_unseen()) << "the same text";
  replace("two", kLastBuildS - 200);
  keep();
  EXPECT_FALSE(has_unseen());
}

TEST_F(BuildDigests, WhatIsDamagedIsNotThere) {
  replace("one", kLastBuildS - 100);
  keep();
  std::ofstream(folder_ / "build" / kDigests) << "12 x";
  replace("two", kLastBuildS - 200);
  EXPECT_FALSE(has_unseen());
}

}  // namespace
}  // namespace eagerx::gen
