// program.map as it is written and read; also when it is not what was written.
#include "generator/backend/program_map/program_map.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

ProgramMap example() {
  ProgramMap map;
  map.program_hash = 0x0123456789abcdefU;
  map.type_of_node = {{"pendulum/theta", "FloatOutput"}, {"smooth", "ButterworthFilter"}};
  map.blocks = {{4, 7, "smooth"}, {8, 11, "pendulum/theta"}};
  map.owner_of_member = {{"smooth_", {true, "smooth"}},
                         {"smooth_filtered_", {false, "rings"}},
                         {"trace", {false, "runtime"}}};
  map.type_of_node["rough"] = "ButterworthFilter";
  map.shares = {{"rough", "smooth"}};
  map.graph_file = "my graph.yaml";
  map.places = {{12, 3, "actions.voltage"}, {9, 5, "smooth"}};
  return map;
}

constexpr const char* kHead = "eagerx-gen program map 2\nprogram 01\nnode a A\nnode b B\n";

std::string problem(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_program_map(text, "m", diagnostics)) << text;
  EXPECT_EQ(diagnostics.error_count(), 1U) << text;
  EXPECT_TRUE(diagnostics.has_io_errors());
  return diagnostics.all().empty() ? "" : diagnostics.all().front().message;
}

TEST(ProgramMap, IsReadAsItWasWritten) {
  Diagnostics diagnostics;
  const std::string text = to_text(example());
  const auto map = parse_program_map(text, "program.map", diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(to_text(*map), text);
  EXPECT_EQ(map->program_hash, example().program_hash);
  EXPECT_EQ(map->type_of_node.at("pendulum/theta"), "FloatOutput");
  EXPECT_EQ(map->shares.at("rough"), "smooth");
  EXPECT_EQ(map->graph_file, "my graph.yaml");
  ASSERT_EQ(map->places.size(), 2U);
  EXPECT_EQ(map->places[1].line, 9U);
  EXPECT_EQ(map->places[1].column, 5U);
  EXPECT_EQ(map->places[1].element, "smooth");
}

TEST(ProgramMap, KnowsWhoseLinesAndMembersAre) {
  const ProgramMap map = example();
  EXPECT_EQ(map.node_of_line(0), nullptr);
  EXPECT_EQ(map.node_of_line(3), nullptr);
  EXPECT_EQ(*map.node_of_line(4), "smooth");
  EXPECT_EQ(*map.node_of_line(7), "smooth");
  EXPECT_EQ(*map.node_of_line(8), "pendulum/theta");
  EXPECT_EQ(map.node_of_line(12), nullptr);
  EXPECT_TRUE(map.owner("smooth_").is_node);
  EXPECT_FALSE(map.owner("smooth_filtered_").is_node);
  EXPECT_EQ(map.owner("smooth_filtered_").name, "rings");
  EXPECT_EQ(map.owner("n30Hz_").name, "schedule") << "what is not named";
}

TEST(ProgramMap, ACommentIsNoLine) {
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_program_map(std::string(kHead) + "# lines 1\n", "m", diagnostics));
}

TEST(ProgramMap, OthersAreRefusedWithTheirLine) {
  EXPECT_EQ(problem(""), "`m:1` is not a program map that this eagerx-gen reads");
  EXPECT_EQ(problem("eagerx-gen program map 1\n"),
            "`m:1` is not a program map that this eagerx-gen reads");
  EXPECT_EQ(problem("eagerx-gen program map 2\nnode a A\n"),
            "`m:2` ends without the hash of program.hpp");
  for (const char* line : {"",
                           "\r",
                           " ",
                           "nodes c C",
                           "node c",
                           "node c ",
                           "node a A",
                           "node c C C",
                           "lines 1 2",
                           "lines 1 2 c",
                           "lines 0 2 a",
                           "lines 3 2 a",
                           "lines -1 2 a",
                           "lines 1 99999999999 a",
                           "lines 1x 2 a",
                           "lines  1 2 a",
                           "program 02",
                           "program",
                           "member x",
                           "member x node c",
                           "shares a",
                           "shares a c",
                           "shares c a",
                           "graph",
                           "place 1 2",
                           "place 1 x smooth",
                           "place 1 2 smooth more",
                           "member x part ",
                           "member x ring a",
                           "member  part a",
                           "member x part rings rings"}) {
    EXPECT_EQ(problem(std::string(kHead) + line + "\n"), "`m:5` is not a line of a program map")
        << line;
  }
}

TEST(ProgramMap, NoLineBelongsToTwoEntries) {
  const std::string first = std::string(kHead) + "lines 5 9 a\n";
  for (const char* line : {"lines 9 12 b", "lines 1 4 b", "lines 5 9 a"})
    EXPECT_EQ(problem(first + line), "`m:6` is not a line of a program map") << line;
  EXPECT_EQ(problem(std::string(kHead) + "member x node a\nmember x part rings"),
            "`m:6` is not a line of a program map");
}

}  // namespace
}  // namespace eagerx::gen
