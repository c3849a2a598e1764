// The report of a campaign.
#include "targets/environments/campaign/report.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace eagerx::campaign {
namespace {

client::Space state(const char* name, const char* dtype, double low, double high) {
  client::Space space;
  space.name = name;
  space.dtype = dtype;
  space.low = {low};
  space.high = {high};
  space.is_scalar = true;
  return space;
}

struct Example {
  client::Description description;
  Plan plan;
  Results results{3, 3};

  Example() {
    description.graph = "g";
    description.states = {state("cart.mass", "float32", 0.0, 2.0),
                          state("gyro.seed", "uint32", 0.0, 4294967295.0),
                          state("cart/u/delay", "float64", 0.0, 0.2)};
    plan.runs = 3;
    plan.columns = client::column_names(description.states);
    plan.sampled = {{1, "gyro.seed", false, 0.0, 4294967295.0}};
    results.returns = {1.0, 2.0, 3.0};
    results.steps = {5, 5, 5};
    results.states = {double{0.1F}, 4044589560.0, 0.1,   //
                      double{0.2F}, 4044589561.0, 0.15,  //
                      double{1.5F}, 1.0,          0.2};
  }
  Report report() const { return {description, plan, results, "replay", 1, false}; }
};

TEST(CampaignReport, CsvHasEveryDigit) {
  const Example example;
  EXPECT_EQ(example.report().csv(),
            "run,return,steps,success,terminated,truncated,state:cart.mass,state:gyro.seed,"
            "state:cart/u/delay\n"
            "0,1,5,0,0,0,0.1,4044589560,0.1\n"
            "1,2,5,0,0,0,0.2,4044589561,0.15\n"
            "2,3,5,0,0,0,1.5,1,0.2\n");
}

TEST(CampaignReport, CommandHasEveryDigit) {
  const Example example;
  EXPECT_EQ(example.report().command(0),
            "replay --seed 1 --environment 0 --set gyro.seed=4044589560");
}

TEST(CampaignReport, SeedsHaveNoRank) {
  const Example example;
  const std::string text = example.report().text();
  const std::string ranks = text.substr(text.find("rank correlation"));
  EXPECT_NE(ranks.find("\ncart.mass"), std::string::npos) << ranks;
  EXPECT_NE(ranks.find("\ncart/u/delay"), std::string::npos) << ranks;
  EXPECT_EQ(ranks.find("\ngyro.seed"), std::string::npos) << ranks;
  EXPECT_EQ(example.report().json().find("\"name\": \"gyro.seed\""), std::string::npos);
}

}  // namespace
}  // namespace eagerx::campaign
