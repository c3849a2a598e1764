// Changes of what a graph is made of: before, what is asked for, after.
#include "generator/tools/edit/structure.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace eagerx::gen {
namespace {

std::string after(const std::string& text, const Change& change) {
  return change.edit ? applied(text, change.edit->splices) : "refused: " + change.problem;
}
std::string added(const std::string& text, const NewEntry& entry) {
  return after(text, add_entry(text, entry));
}
std::string set(const std::string& text, const OutlinePath& path, const std::string& value) {
  return after(text, set_value(text, path, value));
}
std::string taken(const std::string& text, const OutlinePath& path) {
  return after(text, remove_entry(text, path));
}
std::string connected(const std::string& text, const std::string& from, const std::string& to,
                      const std::vector<KeyValue>& keys = {}) {
  return after(text, connect_ports(text, from, to, keys));
}
std::string renamed(const std::string& text, const OutlinePath& path, const std::string& name) {
  return after(text, rename_entry(text, path, name));
}

const NewEntry kLowPass{"nodes", "low_pass", "Filter", {{"rate", "30"}}, {{"order", "2"}}};

TEST(Add, BeginsAnEmptyFile) {
  EXPECT_EQ(added("", kLowPass),
            "nodes:\n  low_pass: {type: Filter, rate: 30, config: {order: 2}}\n");
  EXPECT_EQ(added("# mine\n", {"objects", "arm", "Arm"}), "# mine\nobjects:\n  arm: {type: Arm}\n");
  EXPECT_EQ(added("# mine", {"objects", "arm", "Arm"}), "# mine\nobjects:\n  arm: {type: Arm}\n");
  EXPECT_EQ(added("", {"observations", "angle"}), "observations: [angle]\n");
  EXPECT_EQ(added("", {"actions", "u", "", {{"space", "{like: arm.u}"}}}),
            "actions:\n  u: {space: {like: arm.u}}\n");
}

TEST(Add, PutsASectionWherePeopleLookForIt) {
  const std::string text = "name: a  # x\nobjects:\n    arm: {type: Arm}\n\nconnections:\n";
  EXPECT_EQ(added(text, kLowPass),
            "name: a  # x\nobjects:\n    arm: {type: Arm}\nnodes:\n"
            "    low_pass: {type: Filter, rate: 30, config: {order: 2}}\n\nconnections:\n");
  EXPECT_EQ(set("# first\nobjects: {}\n", {"name"}, "arm"), "# first\nname: arm\nobjects: {}\n");
}

TEST(Add, WritesAsTheOthersAreWritten) {
  EXPECT_EQ(added("nodes:\n  a:\n    type: A # why\n    rate: 1\n# end\n", kLowPass),
            "nodes:\n  a:\n    type: A # why\n    rate: 1\n  low_pass:\n    type: Filter\n"
            "    rate: 30\n    config: {order: 2}\n# end\n");
  EXPECT_EQ(
      added("nodes: {a: {type: A}}  # all\n", kLowPass),
      "nodes: {a: {type: A}, low_pass: {type: Filter, rate: 30, config: {order: 2}}}  # all\n");
  EXPECT_EQ(added("nodes: {\n  a: {type: A},  # a\n  b: {type: B}  # b\n}\n", {"nodes", "c", "C"}),
            "nodes: {\n  a: {type: A},  # a\n  b: {type: B},\n  c: {type: C}  # b\n}\n");
  EXPECT_EQ(added("nodes: {}  # none\n", {"nodes", "c", "C"}), "nodes:  # none\n  c: {type: C}\n");
  EXPECT_EQ(added("nodes:  # none\nx: 1\n", {"nodes", "c", "C"}),
            "nodes:  # none\n  c: {type: C}\nx: 1\n");
  EXPECT_EQ(added("observations:\n- a\n- b # last\n", {"observations", "c"}),
            "observations:\n- a\n- b # last\n- c\n");
  EXPECT_EQ(added("observations: [a, b]\n", {"observations", "c"}), "observations: [a, b, c]\n");
  EXPECT_EQ(added("observations: {a: {}}\n", {"observations", "c"}),
            "observations: {a: {}, c: {}}\n");
  EXPECT_EQ(added("observations: [a]\n", {"observations", "c", "", {{"space", "{low: 0}"}}}),
            "observations: {a: {}, c: {space: {low: 0}}}\n");
}

TEST(Add, KeepsLineEndsByteOrderMarksAndMissingNewlines) {
  EXPECT_EQ(added("\xEF\xBB\xBFname: a\r\nnodes:\r\n  a: {type: A}\r\n", {"nodes", "b", "B"}),
            "\xEF\xBB\xBFname: a\r\nnodes:\r\n  a: {type: A}\r\n  b: {type: B}\r\n");
  EXPECT_EQ(added("name: a\nnodes:\n  a: {type: A}", {"nodes", "b", "B"}),
            "name: a\nnodes:\n  a: {type: A}\n  b: {type: B}");
  EXPECT_EQ(added("\xEF\xBB\xBFnodes:\n  a: {type: A}\n", {"nodes", "b", "B"}),
            "\xEF\xBB\xBFnodes:\n  a: {type: A}\n  b: {type: B}\n");
  EXPECT_EQ(added("\xEF\xBB\xBF", {"observations", "a"}), "\xEF\xBB\xBFobservations: [a]\n");
}

TEST(Add, RefusesWhatIsNoEntry) {
  const std::string text = "objects: {a: {type: A}}\n";
  for (const NewEntry& entry : std::vector<NewEntry>{{"nodes", "a", "A"},
                                                     {"nodes", "", "A"},
                                                     {"nodes", "1a", "A"},
                                                     {"nodes", "a b", "A"},
                                                     {"nodes", "b", ""},
                                                     {"nodes", "b", "B: {"},
                                                     {"wires", "b", "B"},
                                                     {"nodes", "engine", "B"},
                                                     {"nodes", "b", "B", {{"rate", "1}"}}},
                                                     {"nodes", "b", "B", {{"rate", "1 # fast"}}},
                                                     {"nodes", "b", "B", {{"rate", "1\n2"}}},
                                                     {"nodes", "b", "B", {{"", "1"}}},
                                                     {"nodes", "b", "B", {}, {{"x", ""}}}})
    EXPECT_FALSE(add_entry(text, entry).edit) << entry.name << entry.type;
  EXPECT_FALSE(add_entry("nodes: 3\n", {"nodes", "b", "B"}).edit);
  EXPECT_FALSE(add_entry("- 1\n- 2\n", {"nodes", "b", "B"}).edit);
}

TEST(Set, ReplacesAValueAndNothingElse) {
  EXPECT_EQ(set("a: 1  # one\nb: 2\n", {"a"}, "[3, 4]"), "a: [3, 4]  # one\nb: 2\n");
  EXPECT_EQ(set("a: \"x # y\" # one\n", {"a"}, "2"), "a: 2 # one\n");
  EXPECT_EQ(set("a: {b: {c: 1, d: 2}}\n", {"a", "b", "c"}, "7"), "a: {b: {c: 7, d: 2}}\n");
  EXPECT_EQ(set("a: {b: 1 , c: 2}\n", {"a", "b"}, "7"), "a: {b: 7 , c: 2}\n");
  EXPECT_EQ(set("a: [1, 2,3]\n", {"a", std::size_t{1}}, "7"), "a: [1, 7,3]\n");
  EXPECT_EQ(set("a:\n- x: 1\n  y: 2\n- 5 # five\n", {"a", std::size_t{1}}, "6"),
            "a:\n- x: 1\n  y: 2\n- 6 # five\n");
  EXPECT_EQ(set("a:\n- x: 1\n  y: 2\n", {"a", std::size_t{0}, "x"}, "6"), "a:\n- x: 6\n  y: 2\n");
  EXPECT_EQ(set("a:\n  b: 1\n  c: 2\nd: 3\n", {"a"}, "{}"), "a: {}\nd: 3\n");
  EXPECT_EQ(set("a: |\n  text\n  more\nd: 3\n", {"a"}, "x"), "a: x\nd: 3\n");
  EXPECT_EQ(set("a:\nb: 1\n", {"a"}, "x"), "a: x\nb: 1\n");
  EXPECT_EQ(set("a: # later\nb: 1\n", {"a"}, "x"), "a: x # later\nb: 1\n");
  EXPECT_EQ(set("n: {a, b: 1}\n", {"n", "a"}, "x"), "n: {a: x, b: 1}\n");
}

TEST(Set, AddsTheKeysThatAreMissing) {
  EXPECT_EQ(set("nodes:\n  a: {type: A}  # a\n", {"nodes", "a", "config", "order"}, "2"),
            "nodes:\n  a: {type: A, config: {order: 2}}  # a\n");
  EXPECT_EQ(set("nodes:\n  a:\n    type: A  # a\n\n\n# end\n", {"nodes", "a", "rate"}, "30"),
            "nodes:\n  a:\n    type: A  # a\n    rate: 30\n\n\n# end\n");
  EXPECT_EQ(set("nodes:\n  a:\n    config:\n    rate: 1\n", {"nodes", "a", "config", "k"}, "2"),
            "nodes:\n  a:\n    config:\n      k: 2\n    rate: 1\n");
  EXPECT_EQ(set("connections:\n- from: a.x\n  to: b.x\n", {"connections", std::size_t{0}, "skip"},
                "true"),
            "connections:\n- from: a.x\n  to: b.x\n  skip: true\n");
  EXPECT_EQ(set("name: a\n", {"agent", "policy"}, "x.onnx"), "name: a\nagent: {policy: x.onnx}\n");
  EXPECT_EQ(set("", {"name"}, "arm"), "name: arm\n");
  EXPECT_EQ(set("{name: a}\n", {"rate"}, "3"), "{name: a, rate: 3}\n");
  EXPECT_EQ(set("observations: [a, b]\n", {"observations", "b", "space"}, "{low: 0}"),
            "observations: {a: {}, b: {space: {low: 0}}}\n");
  EXPECT_EQ(set("o: {x: {sensors: [a]}}\n", {"o", "x", "sensors", "a", "rate"}, "3"),
            "o: {x: {sensors: {a: {rate: 3}}}}\n");
}

TEST(Set, RefusesWhatWouldDoMore) {
  EXPECT_FALSE(set_value("a: &x {b: 1}\nc: *x\n", {"a"}, "2").edit);
  EXPECT_FALSE(set_value("a:\n  b: 1 # why\n  c: 2\n", {"a"}, "2").edit);
  EXPECT_FALSE(set_value("a: 1\n", {"a", "b"}, "2").edit);
  EXPECT_FALSE(set_value("a: [1]\n", {"a", std::size_t{1}}, "2").edit);
  EXPECT_FALSE(set_value("a: 1\n", {}, "2").edit);
  for (const char* const value : {"", " ", "1, b: 2", "}", "\"", "x: y", "# x", "1 # x", "a\nb",
                                  "{a: 1", "[1", "&x 1", "!!int 1", "*x", "- 1"})
    EXPECT_FALSE(set_value("a: 1\n", {"a"}, value).edit) << value;
  for (const char* const value : {"1", "a", "{a: 1}", "[1, [2]]", "\"x # y\"", "'a, b'", "1/3",
                                  "10 ms", "$(config k)", "-1e-3", "\"leg[*].u\""})
    EXPECT_TRUE(set_value("a: 1\n", {"a"}, value).edit) << value;
}

TEST(Remove, TakesTheCommaOrTheLine) {
  EXPECT_EQ(taken("a: {b: 1, c: 2, d: 3} # x\n", {"a", "b"}), "a: {c: 2, d: 3} # x\n");
  EXPECT_EQ(taken("a: {b: 1, c: 2, d: 3}\n", {"a", "c"}), "a: {b: 1, d: 3}\n");
  EXPECT_EQ(taken("a: {b: 1, c: 2, d: 3 }\n", {"a", "d"}), "a: {b: 1, c: 2 }\n");
  EXPECT_EQ(taken("a: {b: 1}\n", {"a", "b"}), "a: {}\n");
  EXPECT_EQ(taken("a: {\n  b: 1,  # one\n  c: 2  # two\n}\n", {"a", "c"}),
            "a: {\n  b: 1,  # one\n    # two\n}\n");
  EXPECT_EQ(taken("a:\n  b: 1 # one\n  # about c\n  c: 2\nd: 4\n", {"a", "c"}),
            "a:\n  b: 1 # one\n  # about c\nd: 4\n");
  EXPECT_EQ(taken("a: # all\n  b: 1\nd: 4\n", {"a", "b"}), "a: {} # all\nd: 4\n");
  EXPECT_EQ(taken("a:\n- 1\n- 2\n", {"a", std::size_t{0}}), "a:\n- 2\n");
  EXPECT_EQ(taken("a:\n- x: 1\n  y: 2\n", {"a", std::size_t{0}, "x"}), "a:\n- y: 2\n");
  EXPECT_EQ(taken("a:\n- x: 1\n", {"a", std::size_t{0}, "x"}), "a:\n- {}\n");
  EXPECT_EQ(taken("a: 1\r\nb: 2\r\n", {"b"}), "a: 1\r\n");
  EXPECT_EQ(taken("a: 1\nb: 2", {"b"}), "a: 1");
  EXPECT_EQ(taken("a: 1\n", {"a"}), "");
  EXPECT_FALSE(remove_entry("a: 1\n", {"b"}).edit);
  EXPECT_FALSE(remove_entry("a: 1\n", {}).edit);
}

constexpr const char* kWrittenGraph = R"(objects:
  arm: {type: Arm}  # the arm
nodes:
  pid:
    type: Pid  # slow
    inputs: [goal]
actions: {u: {space: {like: arm.u}}}
observations: [q]  # one
connections:
  - {from: actions.u, to: pid.goal}  # goal
  # the loop
  - {from: pid.u, to: arm.u}
  - {from: arm.q, to: observations.q}
  - {from: arm2.q, to: x.q}
agent: {observations: [q]}
task: {inputs: {u: actions.u, q: arm.q}}
render: {source: arm.scene, rate: 30}
)";

TEST(Remove, TakesWhatHangsOnIt) {
  EXPECT_EQ(taken(kWrittenGraph, {"objects", "arm"}), R"(objects: {}
nodes:
  pid:
    type: Pid  # slow
    inputs: [goal]
actions: {u: {space: {like: arm.u}}}
observations: [q]  # one
connections:
  - {from: actions.u, to: pid.goal}  # goal
  # the loop
  - {from: arm2.q, to: x.q}
agent: {observations: [q]}
task: {inputs: {u: actions.u, q: arm.q}}
)");
  const std::string text = taken(kWrittenGraph, {"observations", "q"});
  EXPECT_NE(text.find("observations: []  # one"), std::string::npos) << text;
  EXPECT_EQ(text.find("observations.q"), std::string::npos) << text;
}

TEST(Connect, WritesAsTheOthersAreWritten) {
  EXPECT_EQ(connected("", "a.x", "b.y"), "connections:\n  - {from: a.x, to: b.y}\n");
  EXPECT_EQ(connected("connections:\n- {from: a.x, to: b.x} # 1\n", "leg[*].x", "b.y",
                      {{"window", "2"}, {"delay", "10 ms"}}),
            "connections:\n- {from: a.x, to: b.x} # 1\n"
            "- {from: 'leg[*].x', to: b.y, window: 2, delay: 10 ms}\n");
  EXPECT_EQ(connected("connections:\n  - from: a.x\n    to: b.x", "a.x", "b.y", {{"skip", "true"}}),
            "connections:\n  - from: a.x\n    to: b.x\n  - from: a.x\n    to: b.y\n    skip: true");
  EXPECT_EQ(connected("connections: []\nx: 1\n", "a.x", "b.y"),
            "connections:\n  - {from: a.x, to: b.y}\nx: 1\n");
  EXPECT_EQ(connected("connections: [{from: a.x, to: b.x}]\n", "a.x", "b.y"),
            "connections: [{from: a.x, to: b.x}, {from: a.x, to: b.y}]\n");
  EXPECT_FALSE(connect_ports("", "a", "b.y", {}).edit);
  EXPECT_FALSE(connect_ports("", "a.x", "b.y", {{"skip", "}"}}).edit);
  EXPECT_FALSE(connect_ports("connections: 3\n", "a.x", "b.y", {}).edit);
}

TEST(Connect, ChoosesThePortWhereThereIsAList) {
  const std::string text = connected(kWrittenGraph, "arm.q", "pid.measured");
  EXPECT_NE(text.find("    inputs: [goal, measured]\n"), std::string::npos) << text;
  EXPECT_EQ(connected("objects: {a: {type: A, sensors: {x: {rate: 1}}}}\nconnections: []\n", "a.z",
                      "observations.z"),
            "objects: {a: {type: A, sensors: {x: {rate: 1}, z: {}}}}\nconnections:\n"
            "  - {from: a.z, to: observations.z}\n");
}

TEST(Rename, FindsActionsAndObservationsEverywhere) {
  std::string text = renamed(kWrittenGraph, {"actions", "u"}, "torque");
  for (const char* const changed : {"actions: {torque: ", "{from: actions.torque, to: pid.goal}",
                                    "inputs: {u: actions.torque, q"})
    EXPECT_NE(text.find(changed), std::string::npos) << changed << text;
  EXPECT_NE(text.find("{from: pid.u, to: arm.u}"), std::string::npos) << text;
  EXPECT_EQ(renamed(text, {"actions", "torque"}, "u"), kWrittenGraph);
  text = renamed(kWrittenGraph, {"observations", "q"}, "angle");
  for (const char* const changed : {"observations: [angle]  # one", "to: observations.angle}",
                                    "agent: {observations: [angle]}"})
    EXPECT_NE(text.find(changed), std::string::npos) << changed << text;
  EXPECT_NE(renamed(kWrittenGraph, {"nodes", "pid"}, "loop").find("{from: loop.u, to: arm.u}"),
            std::string::npos);
  for (const char* const name : {"arm", "1", "", "a.b", "engine"})
    EXPECT_FALSE(rename_entry(kWrittenGraph, {"nodes", "pid"}, name).edit) << name;
  EXPECT_FALSE(rename_entry(kWrittenGraph, {"nodes", "missing"}, "x").edit);
  EXPECT_FALSE(rename_entry(kWrittenGraph, {"nodes"}, "x").edit);
}

TEST(Difference, IsOneSmallSplice) {
  const Edit edit = difference("x", "abcdef", "abXdef");
  ASSERT_EQ(edit.splices.size(), 1U);
  EXPECT_EQ(edit.splices[0].place.begin, 2U);
  EXPECT_EQ(edit.splices[0].place.end, 3U);
  EXPECT_EQ(applied("aa", difference("x", "aa", "aaa").splices), "aaa");
}

}  // namespace
}  // namespace eagerx::gen
