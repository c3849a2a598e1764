// Traces: two of them compared, and one in the form of other tools.
#include "generator/tools/trace/trace.hpp"

#include <algorithm>
#include <runtime/host/trace/log_file.hpp>

#include "generator/support/json/json.hpp"
#include "generator/tools/trace/axis.hpp"
#include "generator/tools/trace/bytes.hpp"
#include "generator/tools/trace/compare_logs.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/plot.hpp"
#include "generator/tools/trace/timeline.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

const std::string kHead =
    "# eagerx trace 1\n# graph g\n# engine OdeEngine\n# seed 7\n# environment 0\n"
    "# channel environment/u float32 2 30/1\n# channel pendulum/theta int8 1 15/1\n"
    "episode,channel,seq,values\n";
const std::string kRows =
    "0,environment/u,0,0.5,nan\n0,pendulum/theta,0,-128\n0,environment/u,1,1.5,-2\n"
    "1,pendulum/theta,0,5\n";
const std::string kWhole = kHead + kRows + "# end 4 0x00000000000000ff\n";

class LogsTest : public testing::Test {
 protected:
  Comparison compare(const std::string& first, const std::string& second) {
    return compare_logs(folder_.file("first.log", first), folder_.file("second.log", second));
  }
  TraceResult convert(const std::string& text, TraceFormat format) {
    return convert_log(folder_.file("a.log", text), format);
  }
  static trace_log::Log log(const std::string& text = kWhole) {
    std::string problem;
    auto log = trace_log::read_log("a.log", text, problem);
    EXPECT_TRUE(log) << problem;
    return std::move(*log);
  }

  const TestFolder folder_;
};

TEST_F(LogsTest, EqualLogsAreEqual) {
  const Comparison same = compare(kWhole, kWhole);
  EXPECT_TRUE(same.readable && same.equal);
  EXPECT_EQ(same.text, "equal: 4 messages\n");
}

TEST_F(LogsTest, TheFirstDifferenceIsReportedWithItsPlace) {
  std::string other = kWhole;
  other.replace(other.find("1.5,-2"), 6, "1.5,-3");
  const Comparison different = compare(kWhole, other);
  EXPECT_TRUE(different.readable);
  EXPECT_FALSE(different.equal);
  EXPECT_NE(different.text.find("tick 1 (0.033333 s), node `environment`, field `u`, element 1"),
            std::string::npos)
      << different.text;
  EXPECT_NE(different.text.find("2 messages before, all equal"), std::string::npos)
      << different.text;
}

TEST_F(LogsTest, WhatCannotBeComparedIsSaid) {
  EXPECT_FALSE(compare("no log\n", kWhole).readable);
  EXPECT_FALSE(compare_logs(folder_.path() + "/none", folder_.file("b", kWhole)).readable);
  const Comparison early = compare(kHead + kRows, kWhole);
  EXPECT_TRUE(early.equal);
  EXPECT_NE(early.text.find("ends early"), std::string::npos) << early.text;
}

TEST_F(LogsTest, FormatsGoByTheNameOfTheFile) {
  EXPECT_EQ(trace_format_of("a.b/run.csv"), TraceFormat::csv);
  EXPECT_EQ(trace_format_of("run.mcap"), TraceFormat::mcap);
  for (const char* path : {"", "csv", "run.CSV", "run.txt"})
    EXPECT_FALSE(trace_format_of(path)) << path;
}

TEST_F(LogsTest, EachFormBeginsAsItsReadersWantIt) {
  const TraceResult csv = convert(kWhole, TraceFormat::csv);
  EXPECT_TRUE(csv.readable && csv.problem.empty());
  EXPECT_EQ(csv.summary, "4 messages of 2 channels");
  EXPECT_EQ(csv.bytes.substr(0, csv.bytes.find('\n')),
            "episode,time_s,environment/u[0],environment/u[1],pendulum/theta");
  EXPECT_TRUE(convert(kWhole, TraceFormat::mcap).bytes.starts_with("\x89MCAP0\r\n"));
  EXPECT_TRUE(convert(kWhole, TraceFormat::npz).bytes.starts_with("PK\x03\x04"));
  EXPECT_TRUE(parse_json(convert(kWhole, TraceFormat::json).bytes));
}

TEST_F(LogsTest, ALogThatEndsEarlyIsConvertedWithANote) {
  const TraceResult early = convert(kHead + kRows, TraceFormat::csv);
  EXPECT_TRUE(early.readable && early.problem.empty());
  EXPECT_NE(early.note.find("ends early"), std::string::npos);
  const TraceResult none = convert("x\n", TraceFormat::csv);
  EXPECT_FALSE(none.readable);
  EXPECT_FALSE(none.problem.empty());
}

TEST_F(LogsTest, ValuesHaveTheFewestDigitsAndNullForWhatIsNotFinite) {
  const trace_log::Log read = log();
  EXPECT_EQ(json_values(read, read.rows[0]), "[0.5,null]");
  EXPECT_EQ(json_values(read, read.rows[1]), "-128");
  EXPECT_EQ(quoted_json("a\"\n"), "\"a\\\"\\u000a\"");
}

TEST_F(LogsTest, AChannelIsNamedByPartsThatOnlyItHas) {
  const trace_log::Log read = log();
  Naming naming;
  EXPECT_EQ(channel_named(read, "theta", naming), 1U);
  EXPECT_EQ(channel_named(read, "pendulum/theta", naming), 1U);
  EXPECT_EQ(channel_named(read, "pendulum.theta", naming), 1U);  // as the graph spells it
  EXPECT_EQ(naming.note,
            "`theta` is `pendulum/theta` here\nnote: `pendulum.theta` is `pendulum/theta` here");
  naming.ports = {{"arm.angle", "pendulum/theta"}};
  EXPECT_EQ(channel_named(read, "arm.angle", naming), 1U);  // as a graph calls it
  EXPECT_FALSE(channel_named(read, "thetta", naming));
  EXPECT_NE(naming.problem.find("thetta"), std::string::npos);
}

TEST_F(LogsTest, APanelIsAChannelAnElementOrSeveral) {
  const trace_log::Log read = log();
  Naming naming;
  const auto whole = panel_named(read, "u", {}, naming);
  ASSERT_TRUE(whole) << naming.problem;
  EXPECT_EQ(whole->elements, 2U);
  EXPECT_EQ(whole->names, (std::vector<std::string>{"[0]", "[1]"}));
  const auto one = panel_named(read, "u[1]", {}, naming);
  ASSERT_TRUE(one) << naming.problem;
  EXPECT_EQ(one->title, "environment/u[1]");
  EXPECT_EQ(one->elements, 1U);
  for (const PlotLine& line : one->lines) EXPECT_EQ(line.element, 0U);
  const auto both = panel_named(read, "theta,u[0],u", {}, naming);
  ASSERT_TRUE(both) << naming.problem;
  EXPECT_EQ(both->names, (std::vector<std::string>{"pendulum/theta", "environment/u[0]",
                                                   "environment/u[0]", "environment/u[1]"}));
  EXPECT_EQ(both->elements, 4U);
  for (const std::string wrong : {"u[2]", "u[x]", "u[]", "u[0,1]", "u[0][1]", "u[0:2]", "u[0",
                                  "theta[1]", "theta,", ",u", "thetta"}) {
    naming.problem.clear();
    EXPECT_FALSE(panel_named(read, wrong, {}, naming)) << wrong;
    EXPECT_NE(naming.problem, "") << wrong;
  }
}

TEST_F(LogsTest, AnIndexIsOneNumberBehindTheLastPartOfAName) {
  const trace_log::Log read = log();
  Naming naming;
  for (const std::string index : {"[0,1]", "[0][1]", "[0:2]"}) {
    EXPECT_FALSE(panel_named(read, "u" + index, {}, naming));
    EXPECT_EQ(naming.problem, "`environment/u` has no element `" + index +
                                  "`\nhelp: its elements are environment/u[0] to environment/u[1]: "
                                  "one number, counted row by row, for each element");
  }
  trace_log::Log array = read;
  array.channels[0].name = "smooth[0]/y";
  array.channels[1].name = "smooth[1]/y";
  const auto whole = panel_named(array, "smooth[0]", {}, naming);
  ASSERT_TRUE(whole) << naming.problem;
  EXPECT_EQ(whole->title, "smooth[0]/y");
  const auto one = panel_named(array, "smooth[0]/y[1]", {}, naming);
  ASSERT_TRUE(one) << naming.problem;
  EXPECT_EQ(one->title, "smooth[0]/y[1]");
}

TEST_F(LogsTest, ALegendNamesSeventeenElementsAndTellsThemApart) {
  PlotPanel panel{"pose", 18, {}, {}};
  for (std::uint64_t i = 0; i < panel.elements; ++i) {
    panel.names.push_back("[" + std::to_string(i) + "]");
    panel.lines.push_back({0, i, {0.0, 1.0}, {0.0, static_cast<double>(i)}});
  }
  panel.unit = "rad";
  const std::string svg = plot_svg({panel}, "test");
  EXPECT_NE(svg.find(">[rad]<"), std::string::npos);
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_NE(svg.find(">[" + std::to_string(i) + "]<"), std::string::npos) << i;
  EXPECT_NE(svg.find(">[16] and 1 more<"), std::string::npos);
  EXPECT_NE(svg.find("class=\"line l0\" stroke-dasharray=\"6 3\" points"), std::string::npos);
  EXPECT_NE(svg.find("class=\"line l0\" stroke-dasharray=\"2 2\" points"), std::string::npos);
}

TEST_F(LogsTest, WithoutStampsTimesAreThoseOfTicks) {
  const Timeline times = timeline_of(log());
  EXPECT_EQ(times.in_episode_ns, (std::vector<std::int64_t>{0, 0, 33'333'333, 0}));
  ASSERT_EQ(times.in_log_ns.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(times.in_log_ns)) << "no step back between episodes";
}

TEST_F(LogsTest, PlotsSayWhatIsNotThere) {
  const std::string path = folder_.file("a.log", kWhole);
  EXPECT_NE(plot_log_as_svg({path, {"theta"}, {}}).bytes.find("<svg"), std::string::npos);
  EXPECT_NE(plot_log_as_svg({path, {"theta"}, 9}).problem.find("episodes are 0 to 1"),
            std::string::npos);
  EXPECT_NE(plot_log_as_text({path, {"no"}, {}}, 60, true).problem.find("error: "),
            std::string::npos);
  EXPECT_FALSE(plot_log_as_text({path, {"u"}, 0}, 60, false).bytes.empty());
}

/// The axis has a unit only if all channels of the plot have it.
TEST_F(LogsTest, UnitsThatDifferAreInTheLegend) {
  const std::string path = folder_.file("a.log", kWhole);
  const auto svg = [&](const char* channels, const char* theta, const char* u) {
    const auto whole = [&](const std::string& part) {
      trace_log::Log all = log();
      Naming naming;
      return all.channels[*channel_named(all, part, naming)].name;
    };
    PlotRequest request{path, {channels}, {}};
    request.units = {{whole("theta"), theta}, {whole("u"), u}};
    return plot_log_as_svg(request).bytes;
  };
  EXPECT_NE(svg("theta", "rad", "").find(">[rad]<"), std::string::npos);
  EXPECT_NE(svg("theta,u", "V", "V").find(">[V]<"), std::string::npos);
  for (const auto& [theta, u] : {std::pair{"", "V"}, std::pair{"rad", ""}, std::pair{"rad", "V"}}) {
    const std::string both = svg("theta,u", theta, u);
    for (const std::string unit : {theta, u}) {
      if (unit.empty()) continue;
      EXPECT_EQ(both.find(">[" + unit + "]<"), std::string::npos) << "the axis would be wrong";
      EXPECT_NE(both.find(" [" + unit + "]<"), std::string::npos) << "the legend has it";
    }
  }
}

TEST_F(LogsTest, ThinnedLinesKeepEveryPeak) {
  PlotLine line;
  for (int i = 0; i < 10'000; ++i) {
    line.time_s.push_back(i);
    line.value.push_back(i == 4'321 ? 99.0 : i % 7);
  }
  const auto kept = thinned(line, {0, 9'999}, 50);
  EXPECT_LE(kept.size(), 4U * 51U);
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  EXPECT_NE(std::ranges::find(kept, 4'321U), kept.end());
}

TEST_F(LogsTest, MarksAreRoundAndWithin) {
  for (const PlotRange& range : {PlotRange{0, 1}, PlotRange{-3.7, 1e5}, PlotRange{1e-9, 3e-9}}) {
    const auto marks = marks_of(range, 5);
    ASSERT_GE(marks.size(), 2U);
    for (const PlotMark& mark : marks)
      EXPECT_TRUE(mark.value >= range.low - 1e-12 && mark.value <= range.high * (1 + 1e-9))
          << mark.text;
  }
}

TEST(Bytes, TheChecksumIsThatOfTheStandard) {
  EXPECT_EQ(crc32_of("123456789"), 0xcbf43926U);
  std::string bytes;
  append(bytes, std::uint16_t{0x1234});
  append(bytes, std::uint8_t{0xff});
  EXPECT_EQ(bytes, "\x34\x12\xff");
}

}  // namespace
}  // namespace eagerx::gen
