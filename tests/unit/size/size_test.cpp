// Output of the compiler's tools, including unexpected output, and the results.
#include "generator/analysis/size/size.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <runtime/host/base/hash.hpp>

#include "generator/analysis/size/function_name.hpp"
#include "generator/analysis/size/stack.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/backend/program_map/program_map.hpp"
#include "generator/driver/commands/commands.hpp"
#include "tests/unit/size/tools.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kProgram = "class Program;\n";

/// The map of a program.hpp with this text, in which two nodes have the lines 4 to 7 and 8 to 11.
std::string map_of(const std::string& program) {
  ProgramMap map;
  map.program_hash = host::fnv1a(program);
  map.type_of_node = {{"smooth", "ButterworthFilter"}, {"pendulum/theta", "FloatOutput"}};
  map.blocks = {{4, 7, "smooth"}, {8, 11, "pendulum/theta"}};
  map.owner_of_member = {{"smooth_", {true, "smooth"}}, {"smooth_filtered_", {false, "rings"}}};
  return to_text(map);
}

std::optional<SizeReport> measured(const Tools& tools, Diagnostics& diagnostics) {
  return measure_image(tools.image(), tools.folder(), diagnostics);
}

/// An image with two nodes and a policy, as the tools describe one.
void describe(Tools& tools) {
  const std::string program = tools.file("graph/program.hpp", kProgram);
  tools.file("graph/program.map", map_of(kProgram));
  tools.says("size",
             "   text    data     bss     dec     hex filename\n  100  8  40  148  94 image\n");
  tools.says("nm",
             "00000000 00000006 T eagerx_start\n00000011 00000004 t step\n"
             "00000040 00000020 r graphs::g::policy::kLayer\n"
             "20000000 B eagerx_bss_begin\n20000028 B eagerx_bss_end\n"
             "20000000 00000018 b eagerx::board::run<G>(char const*)::program\n");
  tools.says(
      "addr2line",
      "0x00000000\n/x/targets/common/start.cpp:1\n0x00000002\n/x/targets/common/start.cpp:2\n"
      "0x00000004\n/lib/libgcc.c:4\n"
      "0x00000010\n/x/models/nodes/filter.hpp:3\n" +
          program +
          ":6\n"
          "0x00000012\n" +
          program + ":10\n");
  tools.says(
      "readelf",
      " <1><2a>: Abbrev Number: 5 (DW_TAG_class_type)\n    <2b>   DW_AT_byte_size   : 24\n"
      " <2><2c>: Abbrev Number: 6 (DW_TAG_member)\n    <2d>   DW_AT_name : smooth_filtered_\n"
      "    <2e>   DW_AT_data_member_location: 0\n"
      " <2><2f>: Abbrev Number: 6 (DW_TAG_member)\n    <30>   DW_AT_name : smooth_\n"
      "    <31>   DW_AT_data_member_location: 8\n");
}

TEST(Size, BelongsToTheBlockOfItsNode) {
  Tools tools;
  describe(tools);
  Diagnostics diagnostics;
  const auto report = measured(tools, diagnostics);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->flash, 108U);
  EXPECT_EQ(report->ram, 48U);
  EXPECT_EQ(report->nodes.at("smooth").flash, 2U);
  EXPECT_EQ(report->nodes.at("pendulum/theta").flash, 2U);
  EXPECT_EQ(report->others.at("board").flash, 4U);
  EXPECT_EQ(report->others.at("libraries").flash, 2U);
  EXPECT_EQ(report->others.at("policy").flash, 32U);
  EXPECT_EQ(report->others.at("rings").ram, 8U);
  EXPECT_EQ(report->nodes.at("smooth").ram, 16U) << "with the padding behind it";
  EXPECT_EQ(report->others.at("other").flash, 108U - 42U) << "what has no symbol";
}

TEST(Size, PartsAddUpToTheImage) {
  Tools tools;
  describe(tools);
  Diagnostics diagnostics;
  const auto report = measured(tools, diagnostics);
  ASSERT_TRUE(report);
  Usage sum;
  for (const auto* parts : {&report->nodes, &report->others}) {
    for (const auto& [name, usage] : *parts) {
      sum.flash += usage.flash;
      sum.ram += usage.ram;
    }
  }
  EXPECT_EQ(sum.flash, report->flash);
  EXPECT_EQ(sum.ram, report->ram);
}

/// The one problem of an image whose program.map has this text; without one, there is no such file.
std::string problem_with_map(const std::optional<std::string>& map) {
  Tools tools;
  describe(tools);
  const std::string path = tools.folder() + "/graph/program.map";
  std::filesystem::remove(path);
  if (map) tools.file("graph/program.map", *map);
  Diagnostics diagnostics;
  EXPECT_FALSE(measured(tools, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1U);
  EXPECT_TRUE(diagnostics.has_io_errors());
  std::string message = diagnostics.all().front().message;
  EXPECT_EQ(diagnostics.all().front().code, "E0911");
  if (const auto at = message.find(path); at != std::string::npos)
    message.replace(at, path.size(), "MAP");
  return message;
}

TEST(Size, NeedsTheMapOfThisProgram) {
  EXPECT_TRUE(problem_with_map(std::nullopt).starts_with("cannot read `MAP`, which says what of"));
  EXPECT_EQ(problem_with_map(""), "`MAP:1` is not a program map that this eagerx-gen reads");
  EXPECT_EQ(problem_with_map(map_of(kProgram) + "nod x y\n").substr(0, 4), "`MAP");
  EXPECT_TRUE(
      problem_with_map(map_of("another program\n")).starts_with("`MAP` was not made with this `"));
}

TEST(Size, NeedsTheProgramThatItWasBuiltFrom) {
  Tools tools;
  describe(tools);
  std::filesystem::remove(tools.folder() + "/graph/program.hpp");
  Diagnostics diagnostics;
  EXPECT_FALSE(measured(tools, diagnostics));
  EXPECT_TRUE(diagnostics.all().front().message.starts_with("cannot read `" + tools.folder() +
                                                            "/graph/program.hpp`"));
}

TEST(Size, RefusesWhatIsNoImage) {
  Tools tools;
  Diagnostics diagnostics;
  EXPECT_FALSE(measure_image(tools.file("text", "no image at all, but long"), ".", diagnostics));
  EXPECT_FALSE(measure_image(tools.file("short",
                                        "\x7f"
                                        "ELF"),
                             ".", diagnostics));
  EXPECT_FALSE(measure_image(tools.folder() + "/none", ".", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 3U);
  for (const auto& problem : diagnostics.all()) EXPECT_EQ(problem.code, "E0911");
}

/// Output of `eagerx-gen size` for the image and a graph with this budget.
std::string said_of_budget(const Tools& tools, const std::string& budget) {
  const std::string graph =
      tools.file("graph.yaml",
                 "name: small\nrate: 30\nengine: {type: OdeEngine, rate: 30}\n"
                 "objects:\n  pendulum: {type: Pendulum}\n"
                 "actions: [voltage]\nobservations: [angle]\nconnections:\n"
                 "  - {from: actions.voltage, to: pendulum.u}\n"
                 "  - {from: pendulum.theta, to: observations.angle}\n"
                 "budget: " +
                     budget + "\n");
  testing::internal::CaptureStderr();
  const int code =
      run_command_line({.top = {.name = "eagerx-gen", .about = "", .commands = {size_command()}}},
                       {"size", tools.image(), "--graph", graph, "--quiet"});
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, said.empty() ? kDone : kProblems) << said;
  return said;
}

TEST(Size, ABudgetNamesPartsOfTheImageAndWhatWasCounted) {
  Tools tools;
  describe(tools);
  EXPECT_EQ(said_of_budget(tools, "{flash: 108, nodes: {smooth: {flash: 2}}}"), "");
  EXPECT_NE(said_of_budget(tools, "{nodes: {smoth: {flash: 2}}}")
                .find("error[E0421]: the image has no node `smoth`"),
            std::string::npos);
  EXPECT_NE(said_of_budget(tools, "{instructions: 1000}")
                .find("error[E0422]: instructions have a budget, but were not counted"),
            std::string::npos);
}

TEST(Size, ToolsThatSayNothingAreAnError) {
  Tools tools;
  Diagnostics diagnostics;
  EXPECT_FALSE(measured(tools, diagnostics));
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0911");
}

TEST(Size, ToolsThatSayNonsenseDoNoHarm) {
  const std::string nonsense[] = {"\n",
                                  " \n",
                                  "x\n",
                                  "a b\n",
                                  "a b c\n",
                                  "00000000 ffffffffffffffff T f\n",
                                  "0 9999999999999999999999 T f g\n",
                                  "::::\n",
                                  "0x\n:\n",
                                  "<>:\n 0: sub sp, #\n",
                                  std::string(100'000, 'a') + "\n",
                                  std::string(5'000, ' ') + "\n"};
  for (const std::string& text : nonsense) {
    for (const char* tool : {"size", "nm", "addr2line", "objdump", "readelf"}) {
      Tools tools;
      describe(tools);
      tools.says(tool, text);
      tools.file("a.ci", text);
      Diagnostics diagnostics;
      const auto report = measured(tools, diagnostics);
      EXPECT_NE(report.has_value(), diagnostics.has_errors())
          << tool << " says " << text.substr(0, 40);
    }
  }
}

TEST(Size, NamesOfSymbolsNeedNotBeUtf8) {
  SizeReport report;
  report.others["\xff\xfe"] = {1, 2};
  report.stack.unbounded = {"\xc3("};
  report.stack.path = {"\x80"};
  EXPECT_NE(size_text(report).find("calls of \xc3("), std::string::npos);
  EXPECT_TRUE(parse_json(dump_json(size_json(report))));
}

TEST(Size, MembersThatAreNoNumbers) {
  Tools tools;
  describe(tools);
  tools.says(
      "readelf",
      " <1><2a>: Abbrev Number: 5 (DW_TAG_class_type)\n    <2b>   DW_AT_byte_size   : 24\n"
      " <2><2c>: Abbrev Number: 6 (DW_TAG_member)\n    <2d>   DW_AT_name : smooth_\n"
      "    <2e>   DW_AT_data_member_location: many\n"
      " <2><2f>: Abbrev Number: 6 (DW_TAG_member)\n    <30>   DW_AT_name : smooth_filtered_\n"
      "    <31>   DW_AT_data_member_location: 99999999999999999999999999\n");
  Diagnostics diagnostics;
  const auto report = measured(tools, diagnostics);
  ASSERT_TRUE(report);
  EXPECT_LE(report->nodes.at("smooth").ram, 24U);
}

constexpr const char* kDisassembly =
    "00000000 <eagerx_start>:\n   0:\tpush\t{r4, r5, r6, lr}\n   2:\tbl\t10 <step>\n\n"
    "00000010 <step>:\n  10:\tstmdb\tsp!, {r4, lr}\n  14:\tvpush\t{d8-d9}\n  16:\tsub\tsp, #24\n"
    "  18:\tbl\t30 <leaf>\n  1a:\tblx\tr3\n\n00000030 <leaf>:\n  30:\tstr\tr7, [sp, #-8]!\n";

TEST(Stack, IsTheDeepestChain) {
  Tools tools;
  tools.says("objdump", kDisassembly);
  const StackBound bound = stack_bound("arm-none-eabi-", tools.image(), tools.folder());
  EXPECT_EQ(bound.bytes, 16U + (8 + 16 + 24) + 8);
  EXPECT_EQ(bound.path, (std::vector<std::string>{"eagerx_start", "step", "leaf"}));
  EXPECT_EQ(bound.unbounded, std::vector<std::string>{"step"});
}

TEST(Stack, TheCompilersFiguresCountInsteadOfInstructions) {
  Tools tools;
  tools.says("objdump", kDisassembly);
  tools.file(
      "sub/a.ci",
      "node: { title: \"step\" label: \"step()\\na.cpp:1:1\\n100 bytes (static)\" }\n"
      "node: { title: \"a.cpp:leaf\" label: \"leaf()\\na.cpp:9:1\\n12 bytes (dynamic,bounded)\" }\n"
      "node: { title: \"leaf\" label: \"no figure\" }\nnode: {\n");
  EXPECT_EQ(stack_bound("arm-none-eabi-", tools.image(), tools.folder()).bytes, 16U + 100 + 12);
}

TEST(Stack, FunctionsThatCallThemselvesAreNamed) {
  Tools tools;
  tools.says("objdump",
             "00000000 <main>:\n   0:\tbl\t10 <even>\n\n00000010 <even>:\n  10:\tpush\t{lr}\n"
             "  12:\tbl\t20 <odd>\n\n00000020 <odd>:\n  20:\tbl\t10 <even>\n");
  const StackBound bound = stack_bound("arm-none-eabi-", tools.image(), tools.folder());
  EXPECT_EQ(bound.bytes, 4U);
  EXPECT_EQ(bound.unbounded, std::vector<std::string>{"even"});
}

TEST(Stack, CallsAreThoseOfTheNodesWhoseLinesMakeThem) {
  Tools tools;
  describe(tools);
  // The code at 10 is in the lines of `smooth`; the code that it calls is in no lines.
  tools.says("objdump",
             "00000000 <eagerx_start>:\n   0:\tpush\t{lr}\n   2:\tbl\t8 <run>\n\n"
             "00000008 <run>:\n  10:\tbl\t30 <_ZN6eagerx6models3AddIiE8callbackEv>\n\n"
             "00000030 <_ZN6eagerx6models3AddIiE8callbackEv>:\n  30:\tsub\tsp, #24\n"
             "  32:\tbl\t40 <leaf>\n\n00000040 <leaf>:\n  40:\tpush\t{r4, lr}\n");
  Diagnostics diagnostics;
  const auto report = measured(tools, diagnostics);
  ASSERT_TRUE(report);
  EXPECT_EQ(stack_text(report->stack),
            "       4  board                eagerx_start\n"
            "       0  board                run\n"
            "      24  smooth               Add::callback\n"
            "       8  smooth               leaf\n");
}

TEST(FunctionName, IsThatOfAPerson) {
  EXPECT_EQ(function_name("main"), "main");
  EXPECT_EQ(function_name("_Z"), "_Z");
  EXPECT_EQ(function_name("_ZN6eagerx5board7DecimalIdE12write_scaledEPcyi"),
            "Decimal::write_scaled");
  EXPECT_EQ(function_name("_ZN6eagerx5board3runIN6graphs1g5GraphEEEiPKc"), "run");
  EXPECT_EQ(function_name("_ZN6eagerx12_GLOBAL__N_14stepEv.constprop.0"), "step");
  EXPECT_EQ(function_name("_ZN6eagerx6models3AddIiE8callbackEv.isra.0"), "Add::callback");
}

TEST(ToolPrefix, IsThatOfTheMachine) {
  const Tools tools;
  constexpr int kRiscv = 243;
  constexpr int kX86 = 62;
  EXPECT_EQ(tool_prefix(tools.image()), "arm-none-eabi-");
  EXPECT_EQ(tool_prefix(tools.file("r", Tools::elf(kRiscv))), "riscv64-unknown-elf-");
  EXPECT_EQ(tool_prefix(tools.file("x", Tools::elf(kX86))), "");
  EXPECT_EQ(tool_prefix(tools.file("t", "text")), std::nullopt);
}

TEST(ForEachLine, TellsWhetherAProgramRan) {
  std::vector<std::string> lines;
  const auto keep = [&](std::string_view line) { lines.emplace_back(line); };
  EXPECT_EQ(for_each_line({"printf", "one\\n\\nit's"}, keep), 0);
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "", "it's"}));
  EXPECT_EQ(for_each_line({"false"}, keep), 1);
  EXPECT_EQ(for_each_line({"there is no such program"}, keep), -1);
}

SizeReport example() {
  SizeReport report;
  report.flash = 100;
  report.ram = 20;
  report.nodes["smooth"] = {60, 16};
  report.others["other"] = {40, 4};
  report.stack = {
      64,
      {"eagerx_start", "step"},
      {"step"},
      {{"eagerx_start", "board", false, 24, 0, 0}, {"step", "smooth", true, 40, 16, 2}}};
  return report;
}

TEST(Report, AsText) {
  EXPECT_EQ(size_text(example()),
            "bytes                           flash      RAM\n"
            "smooth                             60       16\n"
            "other                              40        4\n"
            "all                               100       20\n\n"
            "stack: 64 bytes at most, through 1 call; not counted are calls of step through "
            "pointers, or "
            "of themselves; interrupts come on top\n"
            "      24  board                eagerx_start\n"
            "      40  smooth               step\n");
}

TEST(Report, AsJson) {
  SizeReport report = example();
  report.instructions = Instructions{300, 10, 30, 12.5};
  const auto json = nlohmann::json::parse(dump_json(size_json(report)));
  EXPECT_EQ(json["flash"], 100);
  EXPECT_EQ(json["nodes"]["smooth"]["ram"], 16);
  EXPECT_EQ(json["stack"]["unbounded"][0], "step");
  EXPECT_EQ(json["stack"]["calls"][0]["part"], "board");
  EXPECT_EQ(json["stack"]["calls"][1]["node"], "smooth");
  EXPECT_EQ(json["stack"]["calls"][1]["bytes"], 40);
  EXPECT_EQ(json["instructions"]["most"], 30);
  EXPECT_EQ(json["instructions"]["mean"], 12.5);
}

}  // namespace
}  // namespace eagerx::gen
