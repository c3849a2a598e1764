// One script of many modules.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "generator/tools/page/modules.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

class ScriptTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "sub"); }
  void TearDown() override { fs::remove_all(folder_); }

  std::optional<std::string> joined(const Files& files,
                                    const std::vector<std::string>& entries = {"main.mjs"}) {
    for (const auto& [name, text] : files) std::ofstream(folder_ / name) << text;
    diagnostics_ = {};
    return joined_modules(folder_, entries, diagnostics_);
  }
  std::string problem(const Files& files) {
    EXPECT_FALSE(joined(files));
    EXPECT_EQ(diagnostics_.all().size(), 1U);
    EXPECT_EQ(diagnostics_.all().front().code, "E0301");
    std::string message = diagnostics_.all().front().message;
    if (const auto at = message.find(folder_.string()); at != std::string::npos)
      message.erase(at, folder_.string().size() + 1);
    return message;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("eagerx-script-" + std::to_string(getpid()));
  Diagnostics diagnostics_;
};

TEST_F(ScriptTest, EachModuleOnceAfterThoseThatItImports) {
  const auto script = joined(
      {{"main.mjs",
        "// main\nimport {a} from \"./a.mjs\";\nimport {b} from \"./sub/b.mjs\";\n\na(b);\n"},
       {"a.mjs", "import {\n  b,\n  c\n} from \"./sub/b.mjs\";\nexport function a() {}\n"},
       {"sub/b.mjs", "import \"../c.mjs\";\nexport const b = \"import {x}\", c = 2;\nlet own = 1;"},
       {"c.mjs", "export class C {}\nexport async function d() {}\nexport let e;\n"}});
  EXPECT_EQ(script,
            "class C {}\nasync function d() {}\nlet e;\nconst b = \"import {x}\", c = 2;\nlet own "
            "= 1;\nfunction a() {}\n// main\n\na(b);\n");
}

TEST_F(ScriptTest, SeveralEntriesShareModules) {
  EXPECT_EQ(joined({{"one.mjs", "import \"./a.mjs\";\none;\n"},
                    {"main.mjs", "import \"./a.mjs\";\nmain;\n"},
                    {"a.mjs", "a;\n"}},
                   {"one.mjs", "main.mjs"}),
            "a;\none;\nmain;\n");
}

TEST_F(ScriptTest, WhatCannotBeJoinedIsRefused) {
  const std::string form = " has another form than `import {a} from \"./b.mjs\";`";
  for (const char* line : {"import a from \"./a.mjs\";", "import * as a from \"./a.mjs\";",
                           "import {a as b} from \"./a.mjs\";", "import {a} from 'a';",
                           "import {a} from \"a\";", "import {a} from \"./a.mjs\""}) {
    EXPECT_EQ(problem({{"main.mjs", std::string(line) + "\n"}, {"a.mjs", ""}}),
              "cannot read `main.mjs`: `" + std::string(line) + "`" + form);
  }
  for (const char* line : {"export default 1;", "export {a};", "export * from \"./a.mjs\";"})
    EXPECT_EQ(problem({{"main.mjs", std::string(line) + "\n"}}),
              "cannot read `main.mjs`: `" + std::string(line) +
                  "` is not an `export` before a declaration");
}

TEST_F(ScriptTest, ACircleAndAModuleThatIsNotThereAreRefused) {
  EXPECT_EQ(problem({{"main.mjs", "import \"./a.mjs\";\n"}, {"a.mjs", "import \"./main.mjs\";\n"}}),
            "cannot read `main.mjs`: it imports itself in a circle");
  EXPECT_EQ(problem({{"main.mjs", "import \"./none.mjs\";\n"}}),
            "cannot read `none.mjs`: No such file or directory");
}

TEST(Sha256, IsThatOfTheStandard) {
  // FIPS 180-2, B.1 and B.2; of a million letters a, B.3.
  EXPECT_EQ(sha256_base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
  EXPECT_EQ(sha256_base64(""), "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  EXPECT_EQ(sha256_base64(std::string(1'000'000, 'a')),
            "zcduXJkU+5KBocfihNc+Z/GAmkiklyAOBG05zMcRLNA=");
}

}  // namespace
}  // namespace eagerx::gen
