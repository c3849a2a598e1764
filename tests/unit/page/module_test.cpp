// Files in the place of a WebAssembly module.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

const std::string kHead("\0asm\1\0\0\0", 8);

class ModuleTest : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  /// The message of the problem with such a file; empty if it is taken.
  std::string problem(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return problem();
  }
  std::string problem() const {
    Diagnostics diagnostics;
    const auto module = load_module(path_.string(), diagnostics);
    EXPECT_EQ(module.has_value(), diagnostics.all().empty());
    if (module) return {};
    EXPECT_EQ(diagnostics.all().front().code, "E0301");
    const std::string& message = diagnostics.all().front().message;
    return message.substr(message.find("` ") + 2);
  }

  const fs::path path_ =
      fs::temp_directory_path() / ("eagerx-module-" + std::to_string(getpid()) + ".wasm");
};

TEST_F(ModuleTest, OnlyAModuleOfASizeForPagesIsTaken) {
  EXPECT_EQ(problem(kHead + "anything"), "");
  const std::string none = "is not a module of WebAssembly";
  EXPECT_EQ(problem(""), none);
  EXPECT_EQ(problem(kHead.substr(0, 7)), none);
  EXPECT_EQ(problem("<!doctype html>"), none);
  EXPECT_EQ(problem(std::string("\0asm\2\0\0\0", 8)), none);
  EXPECT_EQ(problem("\x7f"
                    "ELF\1\1\1"),
            none);
  fs::resize_file(path_, 64'000'001);  // with a hole
  EXPECT_EQ(problem(), "is too large for a page: 64 MB");
  fs::remove(path_);
  EXPECT_NE(problem(), "");
}

}  // namespace
}  // namespace eagerx::gen
