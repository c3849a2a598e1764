// Nodes that are cut out of a graph, and what was recorded where they were cut.
#include "generator/graph/cut/cut.hpp"

#include "generator/tools/trace/pil_recording.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

struct CutGraph {
  std::unique_ptr<GraphOfText> whole;
  std::optional<Graph> part;
};

CutGraph cut(const std::vector<std::string>& names, const std::string& text = swing()) {
  CutGraph result{graph_of_text(text), {}};
  result.part = cut_out(*result.whole->graph, {names, {}, {}}, result.whole->diagnostics);
  return result;
}

TEST(Cut, WhatComesFromOthersIsAnActionAndWhatGoesToThemAnObservation) {
  const auto [whole, part] = cut({"smooth"});
  ASSERT_TRUE(part) << whole->codes();
  ASSERT_TRUE(part->cut);
  ASSERT_EQ(part->cut->actions.size(), 1U);
  ASSERT_EQ(part->cut->observations.size(), 1U);
  EXPECT_EQ(part->cut->actions[0].sender, "actions.voltage");
  EXPECT_EQ(part->cut->observations[0].sender, "smooth.filtered");
  EXPECT_EQ(part->cut->observations[0].actuator, "pendulum.u");
  EXPECT_EQ(part->environment().rate_hz, Rational(30));
  EXPECT_EQ(part->nodes.size(), 2U) << "the environment and the filter";
}

TEST(Cut, AStepIsTheLongestTimeThatAllPortsAreMultiplesOf) {
  const auto [whole, part] = cut({"smooth"}, swing("60"));
  ASSERT_TRUE(part) << whole->codes();
  EXPECT_EQ(part->environment().rate_hz, Rational(60));
}

TEST(Cut, RefusesWhatCannotBeCutOut) {
  EXPECT_EQ(cut({"smoth"}).whole->codes(), "E0307");
  EXPECT_EQ(cut({"pendulum"}).whole->codes(), "E0397");
  const auto [whole, part] = cut({"smoth", "smooth"});
  EXPECT_FALSE(part);
}

/// Little-endian words of 32 bits.
std::vector<std::uint32_t> words_of(const std::string& bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    words[i / 4] |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * (i % 4));
  return words;
}

constexpr const char* kLog =
    "# eagerx trace 1\n# graph swing\n# engine OdeEngine\n# seed 4294967298\n# environment 0\n"
    "# channel environment/voltage float32 1 30/1\n# channel smooth/filtered float32 1 30/1\n"
    "episode,channel,seq,values\n"
    "0,environment/voltage,0,1\n0,smooth/filtered,0,0.5\n0,environment/voltage,1,2\n";

TEST(Pil, ARecordingHasTheStepsWhoseMessagesAreAllThere) {
  const auto [whole, part] = cut({"smooth"});
  ASSERT_TRUE(part);
  const TestFolder folder;
  std::string problem;
  const auto found = recording_of(folder.file("a.log", kLog), *part, problem);
  ASSERT_TRUE(found) << problem;
  EXPECT_EQ(found->episodes, 1U);
  EXPECT_EQ(found->steps, 1U) << "the second step has no output";
  // seed, episodes, steps, and of each step the action and the observation
  EXPECT_EQ(words_of(found->words),
            (std::vector<std::uint32_t>{2, 1, 1, 1, 0x3f800000, 0x3f000000}));
}

TEST(Pil, SaysWhichChannelIsMissing) {
  const auto [whole, part] = cut({"smooth"});
  ASSERT_TRUE(part);
  const TestFolder folder;
  std::string text = kLog, problem;
  for (std::size_t at = 0; (at = text.find("smooth/filtered")) != std::string::npos;)
    text.replace(at, 6, "others");
  const std::string path = folder.file("a.log", text);
  EXPECT_FALSE(recording_of(path, *part, problem));
  EXPECT_EQ(problem, path + ": there is no channel `smooth/filtered`");
  EXPECT_FALSE(recording_of(folder.path() + "/none.log", *part, problem));
  EXPECT_NE(problem.find("none.log"), std::string::npos) << problem;
  EXPECT_FALSE(recording_of(folder.file("b.log", "no log\n"), *part, problem));
}

}  // namespace
}  // namespace eagerx::gen
