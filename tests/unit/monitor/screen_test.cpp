// The screen's lines and its keys, without a terminal.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "generator/support/diagnostics/utf8.hpp"
#include "generator/tools/monitor/numbers.hpp"
#include "generator/tools/monitor/screen_lines.hpp"
#include "generator/tools/monitor/sparkline.hpp"

namespace eagerx::gen {
namespace {

std::string text_of(const ScreenLine& line) {
  std::string text;
  for (const InkedText& part : line) text += part.text;
  return text;
}

class OnScreen : public testing::Test {
 protected:
  OnScreen() {
    StreamFacts facts;
    facts.graph = "robot";
    model_.begin(facts);
    for (int i = 0; i < 30; ++i) {
      const std::string name = "node_" + std::to_string(i) + "/out";
      const std::vector<double> values(i == 0 ? 12 : 1, 0.25 + i);
      model_.message({.channel = name, .values = values, .elements = values.size(), .real_ns = 0});
    }
  }
  std::vector<std::string> lines() {
    std::vector<std::string> texts;
    for (const ScreenLine& line : screen_lines(model_, view_, size_, "udp:1", note_))
      texts.push_back(text_of(line));
    return texts;
  }
  void keys(const std::string& characters) {
    for (const char each : characters) press({Key::character, each}, model_, view_);
  }
  void key(Key which, int times = 1) {
    for (int i = 0; i < times; ++i) {
      press({which}, model_, view_);
      lines();
    }
  }
  bool shows(const std::string& what) {
    for (const std::string& line : lines())
      if (line.find(what) != std::string::npos) return true;
    return false;
  }

  Model model_{nullptr};
  ScreenView view_;
  ScreenSize size_{24, 80, false};
  std::string note_;
};

TEST_F(OnScreen, FitsEverySize) {
  for (const std::size_t rows : {1U, 7U, 8U, 9U, 24U, 60U}) {
    for (std::size_t columns = 1; columns < 260; ++columns) {
      size_ = {rows, columns, true};
      for (int page = 0; page < 3; ++page) {
        view_ = {};
        if (page == 1) view_.zoomed = "node_0/out";
        if (page == 2) view_.helps = true;
        const auto all = lines();
        ASSERT_LE(all.size(), std::max<std::size_t>(rows, 1));
        for (const auto& line : all) ASSERT_LE(count_code_points(line), columns) << line;
      }
    }
  }
}

TEST_F(OnScreen, HasEightyColumns) {
  const auto all = lines();
  ASSERT_EQ(all.size(), 24U);
  EXPECT_NE(all[0].find("eagerx-gen monitor udp:1"), std::string::npos);
  EXPECT_NE(all[0].find("robot"), std::string::npos);
  for (const char* const head : {"CHANNEL", "VALUE", "LAST", "HZ/PLAN", "AGE", "LIMIT"})
    EXPECT_NE(all[3].find(head), std::string::npos) << head;
  EXPECT_EQ(all[5].substr(0, 11), " node_1/out");
  EXPECT_NE(all[5].find("1.25"), std::string::npos);
  EXPECT_NE(all[23].find("1-19 of 30"), std::string::npos);
}

TEST_F(OnScreen, ScrollsWithTheChosenRow) {
  EXPECT_FALSE(shows("node_25/out"));
  key(Key::down, 25);
  EXPECT_TRUE(shows(">node_25/out"));
  EXPECT_FALSE(shows("node_0/out"));
  key(Key::home);
  EXPECT_TRUE(shows(">node_0/out"));
  key(Key::end);
  EXPECT_TRUE(shows(">node_29/out"));
  key(Key::page_up);
  EXPECT_TRUE(shows(">node_10/out"));
  key(Key::down, 100);
  EXPECT_TRUE(shows(">node_29/out"));
}

TEST_F(OnScreen, Filters) {
  keys("/_2");
  EXPECT_TRUE(shows("filter: _2"));
  EXPECT_TRUE(shows("node_2/out"));
  EXPECT_TRUE(shows("node_27/out"));
  EXPECT_FALSE(shows("node_3/out"));
  keys("q");  // typed, not obeyed
  EXPECT_FALSE(view_.ends);
  EXPECT_TRUE(shows("0 of 0"));
  key(Key::enter);
  key(Key::enter);  // nothing to zoom into
  EXPECT_FALSE(view_.zoomed);
  key(Key::escape);
  EXPECT_TRUE(shows("node_3/out"));
}

TEST_F(OnScreen, ZoomsIntoAChannel) {
  key(Key::enter);
  EXPECT_TRUE(shows(" node_0/out"));
  EXPECT_TRUE(shows("1-12 of 12"));
  size_.rows = 12;
  EXPECT_TRUE(shows("1-5 of 12"));
  key(Key::down, 3);
  EXPECT_TRUE(shows("4-8 of 12"));
  key(Key::escape);
  EXPECT_FALSE(view_.zoomed);
  EXPECT_TRUE(shows(">node_0/out"));
}

TEST_F(OnScreen, PausesHelpsAndEnds) {
  keys(" ");
  EXPECT_TRUE(view_.paused);
  EXPECT_TRUE(shows("PAUSED"));
  keys(" ");
  EXPECT_FALSE(view_.paused);
  keys("?");
  EXPECT_TRUE(shows("escape"));
  keys("x");
  EXPECT_FALSE(view_.helps);
  keys("q");
  EXPECT_TRUE(view_.ends);
}

TEST_F(OnScreen, SaysWhatIsWrong) {
  model_.fault(StreamFault::damaged, 3);
  note_ = "the stream has ended";
  EXPECT_TRUE(shows("the stream has ended, damaged 3"));
}

TEST_F(OnScreen, NamesCannotSteerTheTerminal) {
  model_.message(
      {.channel = "\u202eevil/\x1b[2J", .values = std::vector<double>{1.0}, .elements = 1});
  key(Key::end);
  for (const std::string& line : lines()) {
    EXPECT_EQ(line.find('\x1b'), std::string::npos);
    EXPECT_EQ(line.find("\u202e"), std::string::npos);
  }
}

TEST(Sparkline, IsBetweenTheLeastAndTheGreatest) {
  const std::deque<float> values = {9, 0, 1, 2, 4, 3};
  EXPECT_EQ(sparkline(values, 5, true), "▁▃▅█▇");
  EXPECT_EQ(sparkline(values, 5, false), "_,=#*");
  EXPECT_EQ(sparkline({1, 1}, 4, false), "  __");
  EXPECT_EQ(sparkline({1, std::numeric_limits<float>::quiet_NaN(), 2}, 3, false), "_?#");
  EXPECT_EQ(sparkline({}, 3, false), "   ");
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(sparkline({-kMost, kMost}, 2, false), "_#");
}

TEST(Numbers, AreShort) {
  EXPECT_EQ(short_text(-1.23456789, 8), "-1.23457");
  EXPECT_EQ(short_text(-1.23456789, 6), "-1.235");
  EXPECT_EQ(short_text(1.5e-300, 6), "2e-300");
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(rate_text(30.0001), "30");
  EXPECT_EQ(rate_text(29.97), "30");
  EXPECT_EQ(rate_text(0.25), "0.25");
  EXPECT_EQ(duration_text(0.0123), "12 ms");
  EXPECT_EQ(duration_text(2.5), "2.5 s");
  EXPECT_EQ(duration_text(120.0), "2 min");
}

}  // namespace
}  // namespace eagerx::gen
