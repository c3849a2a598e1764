#include "generator/tools/edit/edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "generator/frontend/outline/fixes.hpp"
#include "generator/frontend/outline/lines.hpp"
#include "generator/tools/edit/rename_port.hpp"

namespace eagerx::gen {
namespace {

TEST(Edit, SplicesStayWhereTheyWere) {
  EXPECT_EQ(applied("one two three", {{{4, 7}, "2"}, {{0, 3}, "uno"}, {{8, 8}, "<"}}),
            "uno 2 <three");
  EXPECT_EQ(applied("one two", {{{0, 5}, "x"}, {{4, 7}, "y"}, {{6, 99}, "z"}}),
            "xwo");  // overlaps, and past the end
}

TEST(Edit, TakesTheFixOfAHelpAndNotItsWords) {
  const std::string text = "a: \xF0\x9F\xA4\x96\nb: thetta\n";
  Diagnostic problem;
  problem.span = {static_cast<FileId>(0), 2, 4, 6};
  EXPECT_FALSE(fix_of(problem, text));
  problem.help = "did you mean `theta`?";
  EXPECT_FALSE(fix_of(problem, text));
  problem.help = meaning("theta");
  EXPECT_EQ(problem.help.text, "did you mean `theta`?");
  problem.help.text = "in other words";
  const auto fix = fix_of(problem, text);
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->reason, "Change to `theta`");
  EXPECT_EQ(applied(text, fix->splices), "a: \xF0\x9F\xA4\x96\nb: theta\n");
  problem.span.length = 0;
  EXPECT_FALSE(fix_of(problem, text));
}

TEST(Edit, FixesGetTheirPlaces) {
  SourceMap sources;
  const FileId file = sources.add("g.yaml", "\xEF\xBB\xBFname: x\nrate: 5\nä: {type: B}\n");
  Diagnostics diagnostics;
  diagnostics.error("E0202", {file, 3, 4, 1}, "no rate").help = {"add it", add_key("rate")};
  diagnostics.error("E0203", {file, 3, 1, 1}, "no list").help = {"", change_list_to("1")};
  place_fixes(diagnostics, sources);
  ASSERT_EQ(diagnostics.all()[0].help.fixes.size(), 1U);
  const Fix& fix = diagnostics.all()[0].help.fixes.front();
  EXPECT_EQ(fix.title, "Add `rate: 5`");
  EXPECT_FALSE(fix.certain);
  ASSERT_EQ(fix.edits.size(), 1U);
  EXPECT_EQ(fix.edits[0].text, ", rate: 5");
  EXPECT_EQ(fix.edits[0].span.line, 3U);
  EXPECT_EQ(fix.edits[0].span.column, 12U);
  EXPECT_EQ(fix.edits[0].span.length, 0U);
  EXPECT_TRUE(diagnostics.all()[1].help.fixes.empty()) << "no list stands there";
}

TEST(Edit, LinesAreCountedInCodePoints) {
  const std::string text =
      "a\xF0\x9F\xA4\x96"
      "b\nc\n";
  const Bytes word = bytes_of(text, {static_cast<FileId>(0), 1, 2, 2});
  EXPECT_EQ(text.substr(word.begin, word.end - word.begin),
            "\xF0\x9F\xA4\x96"
            "b");
  EXPECT_EQ(bytes_of("ab\ncd", {}).end, 2U);
  EXPECT_EQ(bytes_of("\xEF\xBB\xBF"
                     "ab\ncd",
                     {static_cast<FileId>(0), 1, 1, 2})
                .begin,
            3U);  // a byte order mark
  EXPECT_EQ(bytes_of("ab", {static_cast<FileId>(0), 9, 9, 9}).begin, 2U);
}

constexpr const char* kGraph = R"(name: arm # the arm
objects:
  arm: {type: Arm}
  arm2: {type: Arm}
nodes:
  pid: {type: PidController, config: {text: arm}}
actions: {arm: {space: {like: arm.u}}}
connections:
  - {from: actions.arm, to: pid.arm}
  - {from: pid.u, to: "arm.u"}
  - {from: "arm[0].q", to: observations.arm}
  - {from: arm2.q, to: pid.q}
safety:
  outputs: {arm.u: {max: 1}}
tunable: [arm]
variants:
  real:
    objects: {arm: {config: {a: 1}}}
)";

TEST(Rename, FindsWhatNamesAnObjectAndNothingElse) {
  EXPECT_EQ(uses_of(kGraph, "arm").size(), 7U);
  EXPECT_TRUE(uses_of(kGraph, "elbow").empty());
  const auto edit = rename(kGraph, "arm", "left");
  ASSERT_TRUE(edit);
  const std::string text = applied(kGraph, edit->splices);
  for (const char* const kept :
       {"name: arm # the arm", "arm2: {type: Arm}", "text: arm",
        "actions: {arm:", "from: actions.arm, to: pid.arm", "to: observations.arm", "from: arm2.q"})
    EXPECT_NE(text.find(kept), std::string::npos) << kept << "\n" << text;
  for (const char* const changed :
       {"  left: {type: Arm}", "like: left.u", "to: \"left.u\"", "from: \"left[0].q",
        "{left.u: {max: 1}}", "tunable: [left]", "objects: {left: {config"})
    EXPECT_NE(text.find(changed), std::string::npos) << changed << "\n" << text;
  // And back.
  const auto back = rename(text, "left", "arm");
  ASSERT_TRUE(back);
  EXPECT_EQ(applied(text, back->splices), kGraph);
}

TEST(Rename, RefusesNamesThatAreNone) {
  for (const char* const name : {"arm2", "pid", "", "a b", "2a", "a.b", "actions", "engine"})
    EXPECT_FALSE(rename(kGraph, "arm", name)) << name;
  EXPECT_FALSE(rename(kGraph, "missing", "x"));
  EXPECT_EQ(name_at(kGraph, std::string_view(kGraph).find("arm[0]") + 1), "arm");
  EXPECT_EQ(name_at(kGraph, 0), "");
}

std::string part(std::string_view text, Bytes place) {
  return std::string(text.substr(place.begin, place.end - place.begin));
}

/// The text with a fix of a diagnostic at `word`.
std::string fixed(const std::string& text, const std::string& word, const Fix& fix) {
  const std::size_t at = text.find(word);
  Diagnostic problem;
  problem.help = {"", fix};
  const auto line = static_cast<std::uint32_t>(
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  problem.span = {static_cast<FileId>(0), line + 1, static_cast<std::uint32_t>(at - begin + 1),
                  static_cast<std::uint32_t>(word.size())};
  const auto fixes = fixes_of(problem, text);
  return fixes.empty() ? "" : applied(text, fixes.front().edit.splices);
}

TEST(Fixes, AreWrittenAsTheLinesAround) {
  EXPECT_EQ(fixed("rate: 30hz\n", "30hz", change_to("30 Hz")), "rate: 30 Hz\n");
  EXPECT_EQ(fixed("a: !x 1\n", "!x", leave_out("")), "a: 1\n");
  const std::string block =
      "connections:\n  - from: a.b # c\n    to: c.d # e\r\n  - {from: x.y, to: z.w}\n";
  EXPECT_EQ(fixed(block, "c.d", add_to_connection("processor", "P")),
            "connections:\n  - from: a.b # c\n    to: c.d # e\n    processor: P\r\n  - {from: x.y, "
            "to: z.w}\n");
  EXPECT_EQ(fixed(block, "z.w", add_to_connection("processor", "P")),
            "connections:\n  - from: a.b # c\n    to: c.d # e\r\n  - {from: x.y, to: z.w, "
            "processor: P}\n");
  EXPECT_EQ(fixed(block, "z.w", add_to_connection("to", "P")), "");
  const Fix connection = missing_connection("{from: …, to: a.b}").fixes.front();
  EXPECT_EQ(fixed("nodes:\n  a: {}\n", "a:", connection),
            "nodes:\n  a: {}\nconnections:\n  - {from: , to: a.b}\n");
  EXPECT_EQ(fixed("connections: [{from: x.y, to: z.w}]", "x.y", connection),
            "connections: [{from: x.y, to: z.w}, {from: , to: a.b}]");
  EXPECT_EQ(fixed("rate: 5\nnodes:\n  a: {type: B}\n", "{", add_key("rate")),
            "rate: 5\nnodes:\n  a: {type: B, rate: 5}\n");
  EXPECT_EQ(fixed("nodes:\n  a:\n    type: B\n", "type", add_key("rate")),
            "nodes:\n  a:\n    type: B\n    rate: \n");
  EXPECT_EQ(fixed("nodes:\n  a: {type: B}\n", "a:", add_parameter("n")),
            "nodes:\n  a: {type: B, config: {n: }}\n");
  EXPECT_EQ(fixed("nodes:\n  a: {type: B, config: {}}\n", "a:", add_parameter("n")),
            "nodes:\n  a: {type: B, config: {n: }}\n");
  EXPECT_EQ(
      fixed("objects:\n  p: {type: P, sensors: [x]}\nconnections:\n  - {from: p.y, to: q.z}\n",
            "p.y", add_to_list("y", "sensors", "p[0]")),
      "objects:\n  p: {type: P, sensors: [x, y]}\nconnections:\n  - {from: p.y, to: q.z}\n");
  EXPECT_EQ(fixed("rate: 400000\n", "400000", change_number_to("400 Hz")), "rate: 400 Hz\n");
  EXPECT_EQ(fixed("rate: $(x)\n", "$(x)", change_number_to("400 Hz")), "");
  EXPECT_EQ(fixed("rate: 5\na: 1\n", "1", set_in_graph("rate", "10")), "rate: 10\na: 1\n");
  EXPECT_EQ(fixed("a: {delay: [5 ms], b: 1}\n", "[", change_list_to("5 ms")),
            "a: {delay: 5 ms, b: 1}\n");
  EXPECT_EQ(fixed("a: 1\n", "1", allow_here("W0115")), "a: 1\nallow: [W0115]\n");
}

constexpr const char* kManifest = R"(kind: object
id: Arm
sensors:
  q: {rate: $(config rate), space: {dtype: float32}, about: q of the arm}
actuators:
  u: {rate: 30, space: {like: q}}
engines:
  OdeEngine:
    nodes:
      x: {type: OdeOutput, rate: $(sensors q rate)}
      q: {type: FloatOutput, rate: $(actuators u rate), config: {safe: $(safe u)}}
    connections:
      - {from: q.observation, to: sensors.q}
      - {from: actuators.u, to: x.u}
)";

TEST(RenamePort, FindsItInItsManifest) {
  std::vector<std::size_t> lines;
  for (const Bytes& use : uses_of_port_in_manifest(kManifest, "Arm", "q")) {
    EXPECT_EQ(part(kManifest, use), "q");
    lines.push_back(static_cast<std::size_t>(std::count(kManifest, kManifest + use.begin, '\n')) +
                    1);
  }
  EXPECT_EQ(lines, (std::vector<std::size_t>{4, 6, 10, 13}));  // not the engine node `q`
  EXPECT_EQ(uses_of_port_in_manifest(kManifest, "Arm", "u").size(), 4U);
  EXPECT_TRUE(uses_of_port_in_manifest(kManifest, "Leg", "u").empty());
  EXPECT_EQ(why_no_port(kManifest, "q", "angle"), "");
  EXPECT_NE(why_no_port(kManifest, "q", "u"), "");
  EXPECT_NE(why_no_port(kManifest, "none", "angle"), "");
  EXPECT_NE(why_no_port(kManifest, "q", "1x"), "");
}

TEST(RenamePort, FindsItInAGraph) {
  const std::string text =
      "objects:\n  arm: {type: Arm, sensors: [q]}\n  other: {type: Leg, sensors: {q: {}}}\n"
      "connections:\n  - {from: arm.q, to: x.arm}\n  - {from: other.q, to: x.q}\n"
      "  - {from: \"arm[*].sensors.q[0]\", to: x.z}\n"
      "task: {inputs: {a: arm.q, b: [big_arm.q, arm.qq]}}\n"
      "variants: {v: {objects: {arm: {sensors: {q: {rate: 5}}}}}}\n";
  const auto uses = uses_of_port(text, "Arm", "q");
  for (const Bytes& use : uses) EXPECT_EQ(part(text, use), "q");
  EXPECT_EQ(uses.size(), 5U);
  const auto port = port_in_graph(text, text.find("arm.q,") + 4);
  ASSERT_TRUE(port);
  EXPECT_EQ(port->owner + " " + port->type + " " + port->port, "arm Arm q");
  EXPECT_FALSE(port_in_graph(text, text.find("arm.q,") + 1));
}

TEST(RenamePort, FindsItInAHeader) {
  const std::string text = "in.q + begin.q + Io::Inputs::q; q = out.q; in.qq; this.in.q2";
  EXPECT_EQ(uses_of_port_in_header(text, "q").size(), 3U);
}

}  // namespace
}  // namespace eagerx::gen
