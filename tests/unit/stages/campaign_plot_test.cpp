// Tables of campaigns as pictures.
#include <cmath>

#include "generator/tools/campaign/plot.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

const std::string kColumns = "run,return,steps,success,terminated,truncated";

class CampaignPlotTest : public testing::Test {
 protected:
  [[nodiscard]] std::optional<campaign::CampaignTable> table(const std::string& text) {
    return campaign::read_campaign(folder_.file("runs.csv", text), problem_);
  }
  /// 100 runs that succeed below a mass of 1; `more` return, `shift` of the mass.
  static std::string runs(double more, double shift) {
    std::string text = kColumns + ",state:pendulum.mass,state:pendulum.length\n";
    for (int i = 0; i < 100; ++i) {
      const double mass = 0.5 + 0.01 * i + shift;
      text += std::to_string(i) + "," + std::to_string(-mass + more) + ",30," +
              (mass < 1.0 ? "1" : "0") + ",0,1," + std::to_string(mass) + ",2\n";
    }
    return text;
  }
  static std::size_t count(const std::string& text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++found;
    return found;
  }

  const TestFolder folder_;
  std::string problem_;
};

TEST_F(CampaignPlotTest, ColumnsThatDifferAreKept) {
  const auto read = table(kColumns +
                          ",state:robot/body.mass,state:same,fault:a=silent\n"
                          "0,-1.5,10,1,0,1,0.5,2,\n1,nan,10,0,1,0,0.75,2,7\n");
  ASSERT_TRUE(read) << problem_;
  EXPECT_EQ(read->name, "runs");
  EXPECT_EQ(read->returns[0], -1.5);
  EXPECT_TRUE(std::isnan(read->returns[1]));
  EXPECT_EQ(read->successes, (std::vector<bool>{true, false}));
  ASSERT_EQ(read->sampled.size(), 2U);
  EXPECT_EQ(read->sampled[0].name, "robot/body.mass");
  EXPECT_EQ(read->sampled[1].name, "a=silent");
  EXPECT_TRUE(std::isnan(read->sampled[1].values[0]));
  EXPECT_FALSE(campaign::campaign_svg(*read).empty());
}

TEST_F(CampaignPlotTest, WhatIsNoTableIsReportedWithItsLine) {
  const std::string row = "0,-1.5,10,1,0,1\n";
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {"seed,steps\n", "line 1: this is not a table"},
           {kColumns + "\n", "there are no runs"},
           {kColumns + "\n0,-1.5,10\n", "line 2: it has 3 cells"},
           {kColumns + "\n" + row + row, "line 3: run 1 is expected"},
           {kColumns + "\n0,x,10,1,0,1\n", "line 2: `return` is not a number"},
           {kColumns + "\n0,1,10,yes,0,1\n", "line 2: `success` is 0 or 1"},
           {kColumns + ",state:a\n0,1,10,1,0,1,b\n", "line 2: `a` is not a number"}}) {
    problem_.clear();
    EXPECT_FALSE(table(text));
    EXPECT_NE(problem_.find(said), std::string::npos) << problem_;
  }
  EXPECT_FALSE(campaign::read_campaign(folder_.path() + "/none.csv", problem_));
  EXPECT_NE(problem_.find("cannot read"), std::string::npos);
}

TEST_F(CampaignPlotTest, SuccessIsInTenthsWithWilsonsInterval) {
  const auto read = table(runs(0.0, 0.0));
  ASSERT_TRUE(read) << problem_;
  const std::string svg = campaign::campaign_svg(*read);
  // Wilson (1927) for 50 of 100: (0.4038, 0.5962).
  EXPECT_NE(svg.find("50 of 100 succeed (50 %, 95 %: 40.38 to 59.62 %)"), std::string::npos) << svg;
  EXPECT_NE(svg.find("success over pendulum.mass"), std::string::npos);
  EXPECT_EQ(svg.find("pendulum.length"), std::string::npos);  // it does not differ
  EXPECT_EQ(count(svg, "<circle"), 10U);
  // The plot of the second panel reaches from y 270 (all) to 400 (none): five tenths at each.
  EXPECT_EQ(count(svg, "cy=\"270.0\""), 5U);
  EXPECT_EQ(count(svg, "cy=\"400.0\""), 5U);
}

TEST_F(CampaignPlotTest, TwoTablesArePairedRunByRun) {
  const std::string plain = folder_.file("plain.csv", runs(0.0, 0.0));
  const auto both = campaign::plot_campaigns({plain, folder_.file("fast.csv", runs(0.25, 0.0))});
  EXPECT_TRUE(both.problem.empty() && both.note.empty()) << both.problem << both.note;
  EXPECT_NE(both.bytes.find("return of fast minus plain, 100 pairs: mean 0.25 ± "),
            std::string::npos);
  EXPECT_NE(both.bytes.find("both 50, only plain 0, only fast 0, neither 50"), std::string::npos);
  const auto other = campaign::plot_campaigns({plain, folder_.file("o.csv", runs(0.0, 0.125))});
  EXPECT_NE(other.note.find("`pendulum.mass` differs within pairs"), std::string::npos);
}

}  // namespace
}  // namespace eagerx::gen
