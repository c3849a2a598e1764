// Faults of what an agent sees and gives.
#include "targets/common/fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace eagerx::target {
namespace {

using Kind = Fault::Kind;

TEST(Faults, AreWrittenWithAKindAStepAndALength) {
  const auto all = parse_fault("angle[0]=offset:-1e+2@40+5");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->name, "angle[0]");
  EXPECT_EQ(all->kind, Kind::offset);
  EXPECT_EQ(all->number, -100.0);
  EXPECT_EQ(all->begins, Seq{40});
  EXPECT_EQ(all->steps, 5U);
  EXPECT_EQ(all->written, "angle[0]=offset:-1e+2+5");
  const auto least = parse_fault("u=silent");
  ASSERT_TRUE(least);
  EXPECT_FALSE(least->begins);
  EXPECT_FALSE(least->acts(0));
  EXPECT_EQ(parse_fault("u=value:1e+5")->steps, least->steps);
  EXPECT_EQ(parse_fault("u=nan+3")->steps, 3U);
}

TEST(Faults, OtherTextsAreNone) {
  for (const char* text :
       {"", "u", "=nan", "u=", "u=quiet", "u=offset", "u=offset:", "u=offset:x", "u=offset:nan",
        "u=value:1e300", "u=nan@", "u=nan@-1", "u=nan@1.5", "u=nan@3+", "u=nan+0", "u=nan+-1",
        "u=silent@3 ", "u=nan@99999999999999999999999"})
    EXPECT_FALSE(parse_fault(text)) << text;
}

TEST(Faults, ActFromAStepForNSteps) {
  const auto fault = parse_fault("u=nan@4+2");
  ASSERT_TRUE(fault);
  for (const Seq step : {0U, 3U, 6U, 7U}) EXPECT_FALSE(fault->acts(step)) << step;
  for (const Seq step : {4U, 5U}) EXPECT_TRUE(fault->acts(step)) << step;
  EXPECT_TRUE(parse_fault("u=nan@4")->acts(1'000'000'000'000));
}

const std::vector<FaultPlace> kPlaces{
    {.name = "angle", .is_action = false, .size = 2},
    {.name = "u", .is_action = false, .size = 1},
    {.name = "u", .is_action = true, .size = 1},
    {.name = "gear", .is_action = true, .size = 1, .is_real = false}};

/// The place, "NAME/first/size", or what is wrong.
std::string place(const char* text) {
  FaultProblem problem;
  const auto placed = place_fault(*parse_fault(text), kPlaces, problem);
  if (!placed) return problem.what + ": " + problem.help;
  return std::to_string(placed->place) + "/" + std::to_string(placed->first) + "/" +
         std::to_string(placed->size);
}

TEST(Faults, AreOfAnObservationAnActionOrOneNumber) {
  EXPECT_EQ(place("angle=nan"), "0/0/2");
  EXPECT_EQ(place("angle[1]=nan"), "0/1/1");
  EXPECT_EQ(place("observations.angle[0]=nan"), "0/0/1");
  EXPECT_EQ(place("actions.u=nan"), "2/0/1");
  EXPECT_EQ(place("gear=silent"), "3/0/1");
}

TEST(Faults, OfNothingAreRefused) {
  EXPECT_EQ(place("u=nan"),
            "`u` is an observation and an action: write `observations.u` or `actions.u`");
  EXPECT_EQ(place("gear=nan"), "`gear` has whole numbers: such a message can only be `silent`");
  for (const char* text : {"angle[2]=nan", "angle[]=nan", "angle[0=nan", "torque=nan", "ang=nan"})
    EXPECT_NE(place(text).find("available: observations.angle (2 numbers), observations.u"),
              std::string::npos)
        << place(text);
  for (const char* text : {"angles=nan", "anlge[1]=nan"})
    EXPECT_NE(place(text).find("did you mean `angle`?"), std::string::npos) << place(text);
}

std::vector<PlacedFault> faults_of(const std::vector<const char*>& texts) {
  std::vector<PlacedFault> result;
  for (const char* text : texts) {
    FaultProblem problem;
    result.push_back(place_fault(*parse_fault(text), kPlaces, problem).value());
  }
  return result;
}

TEST(Faults, SpoilTheNumbersThatTheyName) {
  const auto faults = faults_of({"angle=offset:0.5@2", "angle[1]=value:7@2", "actions.u=nan@2"});
  EXPECT_EQ(with_faults(faults, 0, 0, 1, 1.0F, 9.0F), 1.0F);
  EXPECT_EQ(with_faults(faults, 0, 0, 2, 1.0F, 9.0F), 1.5F);
  EXPECT_EQ(with_faults(faults, 0, 1, 2, 1.0F, 9.0F), 7.0F);
  EXPECT_EQ(with_faults(faults, 1, 0, 2, 1.0F, 9.0F), 1.0F);
  EXPECT_TRUE(std::isnan(with_faults(faults, 2, 0, 2, 1.0F, 9.0F)));
}

TEST(Faults, SilenceKeepsWhatWasThereBefore) {
  const auto faults = faults_of({"angle=offset:0.5@0", "angle=silent@0"});
  EXPECT_EQ(with_faults(faults, 0, 0, 3, 1.0F, 9.0F), 9.0F);
  EXPECT_EQ(with_faults(faults, 0, 0, 0, 1.0F, 9.0F), 1.0F) << "there is nothing before";
  EXPECT_EQ(with_faults(faults_of({"gear=silent@1"}), 3, 0, 1, 4, 2), 2);
}

}  // namespace
}  // namespace eagerx::target
