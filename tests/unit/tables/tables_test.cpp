// Cells of csv files, and parameters whose numbers are in one.
#include "generator/frontend/tables/tables.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "generator/frontend/tables/csv.hpp"

namespace eagerx::gen {
namespace {

struct Reading {
  SourceMap sources;
  Diagnostics diagnostics;
  std::optional<CsvTable> table;
  explicit Reading(std::string text) {
    const FileId file = sources.add("in.csv", std::move(text));
    table = read_csv(file, sources, diagnostics);
  }
};
std::string show(const CsvRow& row) {
  std::string result;
  for (const CsvCell& cell : row) {
    result += "[" + cell.text + "]" + std::to_string(cell.span.line) + ":" +
              std::to_string(cell.span.column) + "+" + std::to_string(cell.span.length);
  }
  return result;
}

TEST(Csv, CellsKnowTheirPlaces) {
  const Reading reading("# made by hand\n\n \"a,\"\"b\"\" µ\" , c\t,é\n 1,2.5 ,-3e-4\n\n4,5,6");
  ASSERT_TRUE(reading.table);
  EXPECT_EQ(show(reading.table->header), "[a,\"b\" µ]3:2+11[c]3:16+1[é]3:19+1");
  ASSERT_EQ(reading.table->rows.size(), 2U);
  EXPECT_EQ(show(reading.table->rows[0]), "[1]4:2+1[2.5]4:4+3[-3e-4]4:9+5");
  EXPECT_EQ(show(reading.table->rows[1]), "[4]6:1+1[5]6:3+1[6]6:5+1");
}
TEST(Csv, ARowWithANumberIsNoHeader) {
  for (const char* text : {"1,2\n3,4\n", "1,b\n3,4\n", ",b\n3,4\n"}) {
    const Reading reading(text);
    ASSERT_TRUE(reading.table) << text;
    EXPECT_TRUE(reading.table->header.empty()) << text;
    EXPECT_EQ(reading.table->rows.size(), 2U) << text;
  }
}
TEST(Csv, EmptyCellsAreCells) {
  const Reading reading("a,b,c\n,,\n");
  ASSERT_TRUE(reading.table);
  EXPECT_EQ(show(reading.table->rows.at(0)), "[]2:1+1[]2:2+1[]2:3+1");
}
TEST(Csv, SaysAHundredProblemsAtMost) {
  std::string text = "a,b\n";
  for (int i = 0; i < 1000; ++i) text += "1\n";
  const Reading reading(text);
  EXPECT_FALSE(reading.table);
  EXPECT_EQ(reading.diagnostics.error_count(), kMostCsvProblems);
}

/// A graph next to its files, in a folder of its own.
class Tables : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// The values of the parameter of the only node, which is written `value`.
  std::string values(const std::string& value) {
    const std::string graph =
        "name: g\nrate: 1\nactions: [a]\nobservations: [o]\nconnections: []\n"
        "nodes: {n: {type: N, rate: 1, config: {p: " +
        value + "}}}\n";
    sources_ = {};
    diagnostics_ = {};
    const YamlValue root = read_yaml_text("g.yaml", graph, sources_, diagnostics_);
    auto spec = read_graph_spec(root, (folder_ / "g.yaml").string(), diagnostics_);
    if (!spec) return "no graph";
    files_ = read_tables(*spec, sources_, diagnostics_);
    std::string result = text(spec->nodes.at(0).config.at(0).value);
    for (const auto& each : diagnostics_.all()) result += " " + each.code;
    return result;
  }
  static std::string text(const YamlValue& yaml) {
    std::string result = yaml.text;
    for (const YamlValue& item : yaml.items) result += text(item) + " ";
    for (const auto& entry : yaml.entries) result += entry.key + "(" + text(entry.value) + ")";
    return result;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("eagerx_tables_" + std::to_string(getpid()));
  std::vector<std::string> files_;
  SourceMap sources_;
  Diagnostics diagnostics_;
};

TEST_F(Tables, AreColumnsOrAllNumbers) {
  write("run.csv", "\xef\xbb\xbftime,height\r\n0,1.5\r\n0.5,-2\r\n");
  EXPECT_EQ(values("{csv: run.csv, column: time}"), "0 0.5 ");
  EXPECT_EQ(values("{csv: run.csv, column: 2}"), "1.5 -2 ");
  EXPECT_EQ(values("{csv: run.csv}"), "0 1.5 0.5 -2 ") << "row after row";
  EXPECT_EQ(files_, std::vector<std::string>{(folder_ / "run.csv").string()});
  EXPECT_EQ(values("{type: Thing, config: {list: {csv: run.csv, column: 1}}}"),
            "type(Thing)config(list(0 0.5 ))");
  EXPECT_EQ(values("[1, 2]"), "1 2 ");
  EXPECT_TRUE(files_.empty());
}
TEST_F(Tables, AHeaderOfNamesThatAreNumbersIsARow) {
  write("run.csv", "1,2\n3,4\n");
  EXPECT_EQ(values("{csv: run.csv, column: 2}"), "2 4 ");
}
TEST_F(Tables, AreFiniteNumbers) {
  for (const char* bad : {"nan", ".nan", "inf", ".inf", "0x10", "1e999", "01", "1_0", "1;2"}) {
    write("run.csv", std::string("a\n1\n") + bad + "\n");
    EXPECT_TRUE(values("{csv: run.csv}").ends_with(" E0346")) << bad;
  }
}
TEST_F(Tables, AreNotTooLarge) {
  std::string rows;
  for (int i = 0; i < 65'536; ++i) rows += "1\n";
  write("run.csv", rows);
  EXPECT_EQ(values("{csv: run.csv}").size(), 2U * 65'536U);
  write("run.csv", rows + "1\n");
  EXPECT_TRUE(values("{csv: run.csv}").ends_with(" E0345"));
  write("run.csv", std::string((16U << 20U) + 1, ' '));
  EXPECT_TRUE(values("{csv: run.csv}").ends_with(" E0345"));
}

}  // namespace
}  // namespace eagerx::gen
