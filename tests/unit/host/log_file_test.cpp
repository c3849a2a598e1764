// Logs: what is read, and what is said about those that are broken.
#include "runtime/host/trace/log_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <string>

namespace eagerx::trace_log {
namespace {

const std::string kHead =
    "# eagerx trace 1\n"
    "# graph g\n"
    "# engine OdeEngine\n"
    "# seed 7\n"
    "# channel environment/u float32 2 30/1\n"
    "# channel a/b int8 1 15/2\n"
    "episode,channel,seq,values\n";

/// Either a log or a problem, never both or neither.
bool is_one_or_the_other(const std::string& text) {
  std::string problem;
  const bool has_log = read_log("x", text, problem).has_value();
  return has_log == problem.empty();
}

std::string error_of(const std::string& text) {
  std::string problem;
  return read_log("x", text, problem) ? "none" : problem;
}

TEST(LogFile, Reads) {
  std::string problem;
  const auto log = read_log("x",
                            "boot 3.2\n" + kHead +
                                "0,a/b,0,-128\n0,environment/u,0,0.1,nan\n1,a/b,0,5\r\n"
                                "# end 3 0x00000000000000ff\ntrace hash\n",
                            problem);
  ASSERT_TRUE(log) << problem;
  EXPECT_EQ(log->graph, "g");
  EXPECT_EQ(log->seed, 7U);
  EXPECT_EQ(log->episodes(), 2U);
  EXPECT_TRUE(log->complete);
  EXPECT_EQ(log->hash, 0xffU);
  ASSERT_EQ(log->rows.size(), 3U);
  EXPECT_EQ(log->rows[1].line, 10U);
  EXPECT_EQ(value_of<std::int8_t>(*log->values_of(log->rows[0])), -128);
  EXPECT_EQ(value_of<float>(*log->values_of(log->rows[1])), 0.1F);
  EXPECT_EQ(log->values_of(log->rows[1])[1], 0x7fc00000U);
}

TEST(LogFile, HasWhatWasSetWhileAnEpisodeRan) {
  std::string problem;
  const auto log = read_log(
      "x", kHead + "0,a/b,0,1\n# set 0 40 controller/kp 3.5\n# set 0 41 a/b 1,2\n", problem);
  ASSERT_TRUE(log) << problem;
  ASSERT_EQ(log->settings.size(), 2U);
  EXPECT_EQ(log->settings[0].step, 40U);
  EXPECT_EQ(log->settings[0].name, "controller/kp");
  EXPECT_EQ(log->settings[1].values, (std::vector<std::string>{"1", "2"}));
  for (const char* wrong : {"# set ", "# set 0", "# set 0 1", "# set 0 1 a", "# set x 1 a 2",
                            "# set 0 -1 a 2", "# set 0 1 a two", "# set 0 1 a 1,,2"}) {
    EXPECT_FALSE(read_log("x", kHead + wrong + "\n0,a/b,0,1\n", problem)) << wrong;
  }
}

/// As a monitor reads: the file grows, and what was read is taken away.
TEST(LogFile, ReadsPieceByPiece) {
  const std::string text = kHead +
                           "# state 0 a/x 1\n0,a/b,0,-128\n0,environment/u,0,0.1,nan\n"
                           "1,a/b,0,5\n1,a/b,1,6\n# end 4 0x00000000000000ff\nbehind";
  for (std::size_t piece = 1; piece < 40; ++piece) {
    LogReader reader("x");
    std::string left;
    std::vector<std::string> seen;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      left += text.substr(at, piece);
      std::string_view rest = left;
      ASSERT_TRUE(reader.read(rest)) << reader.problem();
      left.erase(0, left.size() - rest.size());
      Log& log = reader.log();
      for (const Row& row : log.rows)
        seen.push_back(std::to_string(row.episode) + log.channels[row.channel].name +
                       std::to_string(row.seq) + "@" + std::to_string(row.line));
      log.rows.clear();
      log.values.clear();
    }
    EXPECT_EQ(seen,
              (std::vector<std::string>{"0a/b0@9", "0environment/u0@10", "1a/b0@11", "1a/b1@12"}));
    EXPECT_TRUE(reader.log().complete);
    EXPECT_TRUE(reader.finish(left));
  }
}

TEST(LogFile, PieceByPieceSaysWhatIsWrongOnce) {
  LogReader reader("x");
  const std::string text = kHead + "0,a/b,0,5\n2,a/b,0,5\n0,a/b,1,6\n";
  std::string_view rest = text;
  EXPECT_FALSE(reader.read(rest));
  EXPECT_EQ(reader.problem(), "x:9:1: error: expected episode 0 or the next");
  EXPECT_EQ(reader.log().rows.size(), 1U);
  EXPECT_FALSE(reader.read(rest));
  EXPECT_FALSE(reader.finish(rest));
  EXPECT_EQ(reader.log().rows.size(), 1U);
}

TEST(LogFile, ReadsScenes) {
  std::string problem;
  const auto log = read_log("x",
                            kHead +
                                "# scenes 30/2\n# scene 0 0 2 0=1,20=nan\n0,a/b,0,1\n"
                                "# scene 0 3 1\n1,a/b,0,1\n# scene 1 0 2 31=-0.5\n",
                            problem);
  ASSERT_TRUE(log) << problem;
  EXPECT_EQ(log->scenes_num, 30U);
  EXPECT_EQ(log->scenes_den, 2U);
  ASSERT_EQ(log->scenes.size(), 3U);
  EXPECT_EQ(log->scenes[1].tick, 3U);
  EXPECT_EQ(log->scenes[1].changes, 0U);
  EXPECT_EQ(log->scenes[2].episode, 1U);
  ASSERT_EQ(log->scene_changes.size(), 3U);
  EXPECT_EQ(log->scene_changes[2].index, 31U);
  EXPECT_EQ(log->scene_changes[2].value, -0.5F);
  EXPECT_EQ(log->rows.size(), 2U);
}

TEST(LogFile, SaysWhatIsWrongWithAScene) {
  const std::string begin = kHead + "# scenes 30/1\n";
  EXPECT_EQ(error_of(kHead + "# scene 0 0 1\n"),
            "x:8:1: error: no line `# scenes RATE` is before this scene");
  for (const char* const rate : {"# scenes 30\n", "# scenes 0/1\n", "# scenes 1/0\n"})
    EXPECT_NE(error_of(kHead + rate).find("`# scenes RATE`"), std::string::npos) << rate;
  EXPECT_EQ(error_of(begin + "# scene 0 0 4096\n"),
            "x:9:13: error: expected how many rows the scene has, at most 4095");
  for (const char* const scene :
       {"# scene", "# scene 0 0 1 16=1\n", "# scene 0 0 1 0=\n", "# scene 0 0 1 =1\n",
        "# scene 0 0 1 0=1,\n# scene 0 0 1\n", "# scene 1 0 1\n# scene 0 1 1\n", "# scene x 0 1\n",
        "# scene 0 0\n"})
    EXPECT_TRUE(is_one_or_the_other(begin + scene)) << scene;
  EXPECT_NE(error_of(begin + "# scene 0 0 1 16=1\n"), "none");
  EXPECT_NE(error_of(begin + "# scene 0 0 1\n# scene 0 0 1\n"), "none");
}

TEST(LogFile, EndsEarly) {
  for (const std::string& text : {kHead, kHead + "0,a/b,0,1\n", kHead + "0,a/b,0,1\n0,a/"}) {
    std::string problem;
    const auto log = read_log("x", text, problem);
    ASSERT_TRUE(log) << problem;
    EXPECT_FALSE(log->complete);
    EXPECT_LE(log->rows.size(), 1U);
  }
}

TEST(LogFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(
      error_of(""),
      "x: error: no line `# eagerx trace 1`; a log is what a program writes with `--trace FILE`");
  EXPECT_EQ(
      error_of("# eagerx trace 2\n"),
      "x:1:1: error: `# eagerx trace 2` is not a version that can be read; this is version 1");
  EXPECT_EQ(error_of("# eagerx trace 1\n# seed 1\n"),
            "x: error: the log ends before its first message, in line 3");
  EXPECT_EQ(error_of("# eagerx trace 1\n# seed -1\n"), "x:2:8: error: `-1` is not a seed");
  EXPECT_EQ(error_of("# eagerx trace 1\n\x1b[2J\n"),
            "x:2:1: error: expected `# name value` or `episode,channel,seq,values`, found `?[2J`");
  const std::string channel = "# eagerx trace 1\n# channel ";
  EXPECT_EQ(error_of(channel + "a float32 1\n"),
            "x:2:11: error: a channel is `name dtype size rate`, not `a float32 1`");
  EXPECT_EQ(error_of(channel + "a float16 1 1/1\n"), "x:2:13: error: `float16` is not a type");
  EXPECT_EQ(error_of(channel + "a int8 0 1/1\n"), "x:2:18: error: `0` is not a number of elements");
  EXPECT_EQ(error_of(channel + "a int8 1 1/0\n"), "x:2:20: error: `1/0` is not a rate");
  EXPECT_EQ(error_of(channel + "a int8 1 1/1 1\n"),
            "x:2:24: error: `1` behind the rate of a channel");
  EXPECT_EQ(error_of(channel + "a int8 1 1/1\n# channel a int8 1 1/1\n"),
            "x:3:11: error: `a` is there twice");
}

TEST(LogFile, ChannelsHaveNamesThatOtherToolsCanRead) {
  const auto said = [](const std::string& name) {
    const std::string error = error_of("# eagerx trace 1\n# channel " + name + " int8 1 1/1\n");
    return error.substr(error.rfind(": ") + 2);
  };
  for (const char* const name :
       {"\xff", "a\xc3", "\xc3(", "\x80", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xe2\x82",
        "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"})
    EXPECT_EQ(said(name), "a name is UTF-8") << name;
  for (const std::string& name : {std::string("a\0b", 3), std::string("a\tb"), std::string("\x7f"),
                                  std::string("a\rb"), std::string("\x1b[2J")})
    EXPECT_EQ(said(name), "a name has no control characters") << name;
  EXPECT_EQ(said("a,b"), "no line could begin a message of it");
  EXPECT_EQ(said(std::string(1001, 'a')), "a name has at most 1000 bytes");
  for (const std::string& name :
       {std::string(1000, 'a'), std::string("é/\xe2\x82\xac"), std::string("\xf0\x9f\xa4\x96"),
        std::string("\xf4\x8f\xbf\xbf"), std::string("\xed\x9f\xbf"), std::string("<i>&\"'/..")})
    EXPECT_EQ(said(name), "the log ends before its first message, in line 3") << name;
}

TEST(LogFile, SaysWhatIsWrongWithAMessage) {
  EXPECT_EQ(error_of(kHead + "x,a/b,0,1\n"), "x:8:1: error: `x` is not the number of an episode");
  EXPECT_EQ(error_of(kHead + "\n"), "x:8:1: error: `` is not the number of an episode");
  EXPECT_EQ(error_of(kHead + "0\n"), "x:8:2: error: the line ends before its channel");
  EXPECT_EQ(error_of(kHead + "1,a/b,0,1\n"), "x:8:1: error: expected episode 0 or the next");
  EXPECT_EQ(error_of(kHead + "0,a/c,0,1\n"),
            "x:8:3: error: no line `# channel` says what `a/c` is");
  EXPECT_EQ(error_of(kHead + "0,a/b,,1\n"), "x:8:7: error: `` is not the number of a message");
  EXPECT_EQ(error_of(kHead + "0,a/b,0\n"),
            "x:8:8: error: a message of `a/b` has 1 value, this one 0");
  EXPECT_EQ(error_of(kHead + "0,a/b,0,1,2\n"),
            "x:8:11: error: a message of `a/b` has 1 value, this one more");
  EXPECT_EQ(error_of(kHead + "0,a/b,0,128\n"), "x:8:9: error: `128` is not a int8");
  EXPECT_EQ(error_of(kHead + "0,environment/u,0,1, 2\n"), "x:8:21: error: ` 2` is not a float32");
  EXPECT_EQ(error_of(kHead + "# end 1 0x0\n"),
            "x:8:7: error: the last line is `# end messages hash`, not `# end 1 0x0`");
  EXPECT_EQ(error_of(kHead + "# end 1 0x0000000000000000\n"),
            "x:8:7: error: the log has 0 messages, its last line says 1");
}

TEST(LogFile, CutAnywhereOrWithAByteChanged) {
  const std::string text =
      kHead + "0,a/b,0,-128\n0,environment/u,0,0.1,nan\n# end 2 0x00000000000000ff\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_TRUE(is_one_or_the_other(text.substr(0, i)));
    for (const char byte : {'\0', '\n', ',', ' ', '9', '\xff'}) {
      std::string changed = text;
      changed[i] = byte;
      EXPECT_TRUE(is_one_or_the_other(changed));
    }
  }
}

TEST(LogFile, Distances) {
  const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x)}; };
  EXPECT_EQ(distance(Dtype::float32, bits(0.0F), bits(-0.0F)), 0U);
  EXPECT_EQ(distance(Dtype::float32, bits(1.0F), bits(1.0000001F)), 1U);
  EXPECT_EQ(distance(Dtype::float32, bits(1e-45F), bits(-1e-45F)), 2U);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(distance(Dtype::float32, bits(nan), bits(1.0F)));
  EXPECT_EQ(distance(Dtype::int64, 0x7fffffffffffffffU, 0x8000000000000000U), 0xffffffffffffffffU);
  EXPECT_EQ(distance(Dtype::uint64, 1, 0xffffffffffffffffU), 0xfffffffffffffffeU);
  EXPECT_EQ(distance_text(Dtype::float32, bits(1.0F), bits(1.0000001F)), "1 ulp apart");
  EXPECT_EQ(text_of(Dtype::int8, static_cast<std::uint64_t>(-3)), "-3");
  EXPECT_EQ(text_of(Dtype::float32, bits(0.1F)), "0.1");
}

}  // namespace
}  // namespace eagerx::trace_log
