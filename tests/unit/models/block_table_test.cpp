// Every block of the library against its row in block_table.hpp. tests/numerics runs 2^26 ticks.
#include "tests/unit/models/block_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace eagerx::models::testing::long_runs {
namespace {

const std::filesystem::path kNodes = EAGERX_SOURCE_DIR "/models/nodes";

bool is_listed(std::string_view folder) {
  return std::any_of(kBlocks.begin(), kBlocks.end(),
                     [&](const Row& row) { return row.folder == folder; });
}

std::string manifest_of(std::string_view folder) {
  std::ifstream file(kNodes / folder / "manifest.yaml");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(BlockTable, HasEveryBlockOfTheLibrary) {
  for (const auto& entry : std::filesystem::directory_iterator(kNodes)) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename().string();
    const bool is_none = std::find(kNoBlocks.begin(), kNoBlocks.end(), folder) != kNoBlocks.end();
    EXPECT_NE(is_listed(folder), is_none)
        << "list " << folder << " in tests/unit/models/block_table.hpp";
  }
  for (const Row& row : kBlocks) EXPECT_FALSE(manifest_of(row.folder).empty()) << row.folder;
}

TEST(BlockTable, FloatStaysNearDouble) {
  for (const Row& row : kBlocks) {
    EXPECT_LE(row.error(Seq{1} << 26, 40'000), row.bound) << row.folder << " " << row.what;
  }
}

/// The line of a manifest's description that says what NaN does: "NaN: passes …", "NaN: …".
std::string line_of_nan(std::string_view folder) {
  std::istringstream lines(manifest_of(folder));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  NaN: ")) return line.substr(7);
  }
  return {};
}

/// Whether NaN in that input is seen at the output. A Switch's control chooses, and does not pass.
bool passes(const Row& row, std::string_view says, std::size_t input) {
  return says.starts_with("passes") && !(row.folder == "switch" && input != 2);
}

TEST(BlockTable, OneWrongNumberDoesWhatTheManifestSaysAndIsOver) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  for (const Row& row : kBlocks) {
    const std::string says = line_of_nan(row.folder);
    EXPECT_EQ(says.empty(), row.inputs == 0)
        << row.folder << "/manifest.yaml: a line \"NaN: …\" in `description` says what one does";
    for (std::size_t input = 0; input < row.inputs; ++input) {
      const Answer nan = row.answer(blocks::kNan<float>, input);
      EXPECT_TRUE(nan.recovers) << row.folder << " " << row.what << ", input " << input;
      EXPECT_EQ(nan.shows, passes(row, says, input)) << row.folder << ": " << says << input;
      for (const float wrong : {kInf, -kInf, 3.4e38F, -3.4e38F})
        EXPECT_TRUE(row.answer(wrong, input).recovers)
            << row.folder << " " << row.what << ", input " << input << ": " << wrong;
    }
  }
}

}  // namespace
}  // namespace eagerx::models::testing::long_runs
