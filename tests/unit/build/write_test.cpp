#include "generator/driver/build/write.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "generator/support/files/files.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

class WriteFiles : public testing::Test {
 protected:
  WriteFiles() {
    std::string name = (fs::temp_directory_path() / "eagerx-write-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr) << name;
    folder_ = name;
  }
  ~WriteFiles() override {
    std::error_code ignored;
    fs::permissions(folder_ / "out", fs::perms::owner_all, ignored);
    fs::remove_all(folder_, ignored);
  }

  std::optional<WriteResult> write(const std::vector<GeneratedFile>& files) {
    diagnostics_ = {};
    return write_files((folder_ / "out").string(), files, diagnostics_);
  }

  std::string text(const std::string& path) const { return text_of(fs::path("out") / path); }
  std::string text_of(const fs::path& path) const {
    std::ifstream file(folder_ / path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  void put(const fs::path& path, const std::string& content) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path) << content;
  }

  /// Every path below the output folder.
  std::vector<std::string> listing() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
      if (!entry.is_directory())
        result.push_back(fs::relative(entry.path(), folder_ / "out").string());
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  fs::path folder_;
  Diagnostics diagnostics_;
};

TEST_F(WriteFiles, WritesAllAndListsThem) {
  const auto result = write({{"b/two.hpp", "two"}, {"one.txt", "one"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->written, 3U);  // and the list
  EXPECT_EQ(text("b/two.hpp"), "two");
  EXPECT_EQ(listing(), (std::vector<std::string>{"b/two.hpp", "eagerx-gen.files", "one.txt"}));
}

TEST_F(WriteFiles, LeavesUnchangedFilesAlone) {
  write({{"one.txt", "one"}, {"two.txt", "two"}});
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder_ / "out/one.txt", old);
  const auto result = write({{"one.txt", "one"}, {"two.txt", "changed"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->written, 1U);
  EXPECT_EQ(result->unchanged, 2U);
  EXPECT_EQ(fs::last_write_time(folder_ / "out/one.txt"), old);
  EXPECT_EQ(text("two.txt"), "changed");
}

TEST_F(WriteFiles, RemovesWhatIsNoLongerMadeAndNothingElse) {
  write({{"old/gone.hpp", "gone"}, {"kept.txt", "kept"}});
  put("out/mine.txt", "mine");
  const auto result = write({{"kept.txt", "kept"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->removed, 1U);
  EXPECT_EQ(listing(), (std::vector<std::string>{"eagerx-gen.files", "kept.txt", "mine.txt"}));
}

TEST_F(WriteFiles, NeverRemovesAnythingOutsideOfTheFolder) {
  put("victim.txt", "precious");
  put("out/eagerx-gen.files",
      "../victim.txt\nsub/../../victim.txt\n" + (folder_ / "victim.txt").string() + "\n\n.\n..\n");
  ASSERT_TRUE(write({{"one.txt", "one"}}));
  EXPECT_TRUE(fs::exists(folder_ / "victim.txt"));
  EXPECT_TRUE(fs::exists(folder_ / "out/one.txt"));
}

TEST_F(WriteFiles, ChangesNothingWhenOneFileCannotBeWritten) {
  write({{"a.txt", "old"}, {"z.txt", "old"}});
  put("out/blocked/file", "a folder where a file should go");
  EXPECT_FALSE(write({{"a.txt", "new"}, {"blocked", "new"}, {"z.txt", "new"}}));
  ASSERT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_EQ(diagnostics_.all().front().code, "E0901");
  EXPECT_TRUE(diagnostics_.has_io_errors());
  EXPECT_EQ(text("a.txt"), "old");
  EXPECT_EQ(text("z.txt"), "old");
  EXPECT_EQ(listing(), (std::vector<std::string>{"a.txt", "blocked/file", "eagerx-gen.files",
                                                 "z.txt"}));  // no leftovers
}

TEST_F(WriteFiles, NeverOverwritesWhatSomebodyElseWrote) {
  put("out/CMakeLists.txt", "project(mine)");
  EXPECT_FALSE(write({{"CMakeLists.txt", "project(generated)"}, {"a.txt", "new"}}));
  ASSERT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_EQ(diagnostics_.all().front().code, "E0903");
  EXPECT_EQ(text("CMakeLists.txt"), "project(mine)");
  EXPECT_EQ(listing(), (std::vector<std::string>{"CMakeLists.txt"}));
}

TEST_F(WriteFiles, WritesWhatIsYoursOnce) {
  const GeneratedFile yours{"hardware.h", "blank", true};
  auto result = write({yours, {"a.txt", "one"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(text("hardware.h"), "blank");
  put("out/hardware.h", "filled in");
  result = write({yours, {"a.txt", "two"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->kept, 1U);
  EXPECT_EQ(text("hardware.h"), "filled in");
  ASSERT_TRUE(write({{"a.txt", "three"}}));
  EXPECT_EQ(text("hardware.h"), "filled in") << "not even when it is no longer made";
}

TEST_F(WriteFiles, NeverOverwritesWhatItMayNotRead) {
  put("out/one.txt", "mine");
  fs::permissions(folder_ / "out/one.txt", fs::perms::none);
  const uid_t user = geteuid();
  if (user == 0) {  // who may read everything, so somebody else tries
    constexpr uid_t kNobody = 65534;
    for (const fs::path& path : {folder_, folder_ / "out"})
      ASSERT_EQ(chown(path.c_str(), kNobody, static_cast<gid_t>(-1)), 0);
    ASSERT_EQ(seteuid(kNobody), 0);
  }
  const bool written = write({{"one.txt", "one"}}).has_value();
  ASSERT_EQ(seteuid(user), 0);
  EXPECT_FALSE(written);
  ASSERT_EQ(diagnostics_.error_count(), 1U);
  EXPECT_EQ(diagnostics_.all().front().code, "E0903");
  fs::permissions(folder_ / "out/one.txt", fs::perms::owner_all);
  EXPECT_EQ(text("one.txt"), "mine");
}

TEST_F(WriteFiles, TakesAFileOfTheSameTextForItsOwn) {
  put("out/a.txt", "same");
  ASSERT_TRUE(write({{"a.txt", "same"}}));
  ASSERT_TRUE(write({{"a.txt", "changed"}}));
  EXPECT_EQ(text("a.txt"), "changed");
}

TEST_F(WriteFiles, TwoFilesOfOneNameAreAnErrorThatChangesNothing) {
  write({{"a.txt", "old"}});
  EXPECT_FALSE(write({{"a.txt", "new"}, {"b.txt", "one"}, {"b.txt", "two"}}));
  EXPECT_TRUE(diagnostics_.has_io_errors());
  EXPECT_EQ(text("a.txt"), "old");
  EXPECT_EQ(listing(), (std::vector<std::string>{"a.txt", "eagerx-gen.files"}));
}

TEST_F(WriteFiles, WhatARunLeftThatWasKilledBeforeItsEndIsRemoved) {
  write({{"a.txt", "old"}});
  put("out/.eagerx-gen.new/0", "new");
  put("out/.eagerx-gen.new/journal.begun", ".eagerx-gen.new/0:a");
  ASSERT_TRUE(write({{"a.txt", "old"}}));
  EXPECT_EQ(text("a.txt"), "old");
  EXPECT_EQ(listing(), (std::vector<std::string>{"a.txt", "eagerx-gen.files"}));
  EXPECT_FALSE(fs::exists(folder_ / "out/.eagerx-gen.new"));
}

TEST_F(WriteFiles, WhatARunBeganToRenameIsCompleted) {
  write({{"a.txt", "old"}, {"b.txt", "old"}, {"sub/gone.txt", "old"}});
  // Killed when a.txt had its place, and the other two had not.
  put("out/a.txt", "new");
  put("out/.eagerx-gen.new/1", "new");
  put("out/.eagerx-gen.new/2", "eagerx-gen.files\na.txt\nb.txt\n");
  put("out/.eagerx-gen.new/journal",
      ".eagerx-gen.new/0:a.txt\n.eagerx-gen.new/1:b.txt\n.eagerx-gen.new/2:eagerx-gen.files\n"
      ":sub/gone.txt\n");
  const auto result = write({{"a.txt", "new"}, {"b.txt", "new"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->unchanged, 3U);
  EXPECT_EQ(text("b.txt"), "new");
  EXPECT_EQ(listing(), (std::vector<std::string>{"a.txt", "b.txt", "eagerx-gen.files"}));
  EXPECT_FALSE(fs::exists(folder_ / "out/sub"));
}

TEST_F(WriteFiles, AJournalOfSomebodyElseLeavesTheFolderAlone) {
  put("victim.txt", "precious");
  for (const char* line : {":../victim.txt", "../victim.txt:a.txt", "a.txt:b.txt",
                           ".eagerx-gen.new/../../victim.txt:a.txt"}) {
    put("out/.eagerx-gen.new/journal", line);
    EXPECT_FALSE(write({{"one.txt", "one"}})) << line;
    EXPECT_TRUE(fs::exists(folder_ / "victim.txt"));
  }
}

TEST_F(WriteFiles, NothingIsWrittenOrRemovedThroughALink) {
  put("elsewhere/victim.txt", "precious");
  put("out/eagerx-gen.files", "linked/victim.txt\nlinked/other.txt\n");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "out/linked");
  EXPECT_FALSE(write({{"linked/other.txt", "new"}, {"a.txt", "new"}}));
  EXPECT_NE(diagnostics_.all().front().message.find("is a link"), std::string::npos);
  EXPECT_EQ(listing(), (std::vector<std::string>{"eagerx-gen.files"}));
  ASSERT_TRUE(write({{"a.txt", "new"}}));
  EXPECT_TRUE(fs::exists(folder_ / "elsewhere/victim.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "elsewhere/other.txt"));
}

TEST_F(WriteFiles, ALinkInThePlaceOfAFileIsReplacedAndNotFollowed) {
  put("victim.txt", "precious");
  put("out/eagerx-gen.files", "a.txt\n");
  fs::create_symlink(folder_ / "victim.txt", folder_ / "out/a.txt");
  ASSERT_TRUE(write({{"a.txt", "new"}}));
  EXPECT_EQ(text("a.txt"), "new");
  EXPECT_FALSE(fs::is_symlink(folder_ / "out/a.txt"));
  EXPECT_EQ(text_of("victim.txt"), "precious");
}

TEST_F(WriteFiles, TheStageIsNoLink) {
  put("elsewhere/kept.txt", "kept");
  fs::create_directories(folder_ / "out");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "out/.eagerx-gen.new");
  EXPECT_FALSE(write({{"a.txt", "new"}}));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "elsewhere"), {}), 1);
}

TEST_F(WriteFiles, NamesThatLeaveTheFolderAreRefused) {
  for (const char* path : {"../victim.txt", "/victim.txt", "a/../../victim.txt", "a\nb", ""}) {
    EXPECT_FALSE(write({{path, "new"}})) << path;
    EXPECT_FALSE(fs::exists(folder_ / "victim.txt"));
  }
}

TEST_F(WriteFiles, FoldersAndPipesWithoutAReaderAreNoOutputs) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, folder_.string()}) {
    EXPECT_FALSE(write_file(path, "text", diagnostics_)) << path;
  }
  EXPECT_TRUE(write_file("/dev/null", "text", diagnostics_));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_TRUE(write_file(pipe, "text", diagnostics_));
  std::string read(8, '\0');
  EXPECT_EQ(::read(reader, read.data(), read.size()), 4);
  close(reader);
}

// At 9028afbf, a file took the place of the link.
TEST_F(WriteFiles, OneFileIsWrittenWhereALinkLeads) {
  put("elsewhere.txt", "before");
  fs::create_symlink("elsewhere.txt", folder_ / "link.txt");
  EXPECT_TRUE(write_file((folder_ / "link.txt").string(), "after", diagnostics_));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(text_of("elsewhere.txt"), "after");
}

TEST_F(WriteFiles, OneFileIsWrittenNextToALeftover) {
  put("elsewhere.txt", "precious");
  fs::create_symlink(folder_ / "elsewhere.txt", folder_ / ".graph.yaml.eagerx-gen.new");
  EXPECT_TRUE(write_file((folder_ / "graph.yaml").string(), "name: new\n", diagnostics_));
  EXPECT_EQ(text_of("elsewhere.txt"), "precious");
  EXPECT_EQ(text_of("graph.yaml"), "name: new\n");
}

TEST_F(WriteFiles, AKilledWriterLeavesNothingWhereTheFileStaysAsItIs) {
  const pid_t killed = fork();
  if (killed == 0) _exit(0);
  ASSERT_EQ(waitpid(killed, nullptr, 0), killed);
  put("out/page.html", "same");
  put("out/.page.html." + std::to_string(killed) + ".0x01.part", "half");
  Diagnostics diagnostics;
  EXPECT_TRUE(write_file((folder_ / "out/page.html").string(), "same", diagnostics));
  EXPECT_EQ(listing(), std::vector<std::string>({"page.html"}));
}

TEST_F(WriteFiles, AFileWhereAFolderBelongsIsAnError) {
  put("out/sub", "a file");
  EXPECT_FALSE(write({{"a.txt", "new"}, {"sub/b.txt", "new"}}));
  EXPECT_TRUE(diagnostics_.has_io_errors());
  EXPECT_EQ(listing(), (std::vector<std::string>{"sub"}));
}

TEST_F(WriteFiles, AFileWhereAFolderShouldBeIsAnErrorThatChangesNothing) {
  write({{"a.txt", "old"}});
  put("out/sub", "a file");
  EXPECT_FALSE(write({{"a.txt", "new"}, {"sub/b.txt", "x"}}));
  EXPECT_TRUE(diagnostics_.has_io_errors());
  EXPECT_EQ(text("a.txt"), "old");
}

TEST_F(WriteFiles, AnInputStaysByAnyName) {
  put("out/a.txt", "read");
  fs::create_symlink("a.txt", folder_ / "out/link.txt");
  fs::create_hard_link(folder_ / "out/a.txt", folder_ / "out/hard.txt");
  remember_input((folder_ / "out/a.txt").string());
  for (const char* name : {"out/a.txt", "out/link.txt", "out/hard.txt", "out/../out/a.txt"}) {
    diagnostics_ = {};
    EXPECT_FALSE(write_file((folder_ / name).string(), "written", diagnostics_)) << name;
    ASSERT_EQ(diagnostics_.error_count(), 1U);
    EXPECT_EQ(diagnostics_.all().front().code, "E0906");
    EXPECT_TRUE(diagnostics_.has_usage_errors());
    EXPECT_EQ(text("a.txt"), "read");
  }
  forget_files();
  EXPECT_TRUE(write_file((folder_ / "out/a.txt").string(), "written", diagnostics_));
}

TEST_F(WriteFiles, OutputsOfACommandAreDifferent) {
  remember_output((folder_ / "out/b.txt").string(), "--csv");
  remember_output((folder_ / "out/../out/b.txt").string(), "--curve");
  EXPECT_FALSE(write({{"a.txt", "a"}}));  // for a folder as well, and nothing is there yet
  EXPECT_FALSE(fs::exists(folder_ / "out/a.txt"));
  forget_files();
  remember_output((folder_ / "out/a.txt").string(), "--csv");
  EXPECT_FALSE(write({{"a.txt", "a"}}));
  EXPECT_TRUE(write({{"c.txt", "c"}}));
  forget_files();
}

TEST_F(WriteFiles, AFileWithoutAFolderGoesWhereThePersonIs) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_TRUE(write_file("graph.yaml", "name: here\n", diagnostics_));
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(folder_ / "graph.yaml"));
}

}  // namespace
}  // namespace eagerx::gen
