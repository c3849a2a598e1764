// The record of a training: what it says is what the training says elsewhere.
#include "targets/environments/train/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <runtime/host/base/hash.hpp>
#include <sstream>

#include "targets/environments/train/seeds.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

using nlohmann::json;

class TrainRecord : public testing::Test {
 protected:
  TrainRecord() {
    options_.output = folder_.path("policy.safetensors");
    options_.csv = folder_.path("curve.csv");
    options_.record = folder_.path("training.json");
    options_.settings.net_arch = {8, 8};
    options_.settings.stagger = false;
    options_.steps = 8192 * 7;
    options_.threads = 1;
    options_.is_quiet = true;
  }

  std::vector<json> lines() const {
    std::vector<json> all;
    std::istringstream text(read_file(options_.record));
    for (std::string line; std::getline(text, line);) all.push_back(json::parse(line));
    return all;
  }

  TestFolder folder_;
  Options options_;
};

/// The rows of the record as the table of --csv.
std::string table_of(const std::vector<json>& lines) {
  std::string text =
      "steps,return,success_rate,eval_return,eval_success_rate,std,learning_rate,approx_kl,"
      "stage,stage_success_rate,stage_return\n";
  for (const json& line : lines) {
    if (!line.contains("steps") || line.contains("ended") || line.contains("eagerx_training"))
      continue;
    text += std::to_string(line["steps"].get<std::uint64_t>());
    for (const char* name :
         {"return", "success_rate", "eval_return", "eval_success_rate", "std", "learning_rate",
          "approx_kl", "stage", "stage_success_rate", "stage_return"}) {
      char number[32] = "";
      if (line.contains(name)) snprintf(number, sizeof number, "%.7g", line[name].get<double>());
      text += std::string(",") + number;
    }
    text += "\n";
  }
  return text;
}

TEST_F(TrainRecord, HasTheCurveOfTheTable) {
  Training training(options_, pendulum());
  training.run(never);
  const std::vector<json> all = lines();
  EXPECT_EQ(table_of(all), read_file(options_.csv));
  EXPECT_EQ(all.front()["graph"], pendulum().description().graph);
  EXPECT_EQ(all.front()["settings"], text_of(options_.settings));
  const auto& terms = pendulum().description().terms;
  std::size_t iterations = 0, with_terms = 0;
  for (const json& line : all) {
    iterations += line.contains("std") ? 1 : 0;
    if (!line.contains("std") || !line.contains("terms")) continue;
    ++with_terms;
    EXPECT_EQ(line["terms"].size(), terms.size());
    double sum = 0.0;
    for (const double term : line["terms"]) sum += term;
    EXPECT_NEAR(sum, line["eval_return"].get<double>(), 1e-3 * std::abs(sum) + 1e-3);
  }
  EXPECT_GE(with_terms, 1);
  EXPECT_EQ(with_terms, iterations / options_.settings.eval_interval);
}

TEST_F(TrainRecord, HasTheEpisodesOfTheLastEvaluation) {
  Training training(options_, pendulum());
  training.run(never);
  const json end = lines().back();
  const Evaluation& evaluation = training.evaluation();
  EXPECT_EQ(end["ended"], "steps");
  EXPECT_EQ(end["policy_hash"], host::hex_text(host::fnv1a(read_file(options_.output))));
  ASSERT_EQ(end["episodes"].size(), 400);
  double sum = 0.0, low = INFINITY;
  for (const json& episode : end["episodes"]) {
    sum += episode[2].get<double>();
    low = std::min(low, episode[2].get<double>());
  }
  EXPECT_NEAR(sum / 400, evaluation.mean_return, 1e-9 * std::abs(sum));
  EXPECT_EQ(low, evaluation.lowest_return);
  // Four seeds that nothing else has, and environments from 0 on in each.
  EXPECT_EQ(end["episodes"][0][0], std::to_string(0xc000000000000000U));
  EXPECT_EQ(end["episodes"][399][0], std::to_string(0xc000000000000003U));
  EXPECT_EQ(end["episodes"][137][1], 37);
  EXPECT_FALSE(end["signs"].empty()) << "no episode has succeeded";
}

TEST_F(TrainRecord, SaysWhereTheTimeWent) {
  options_.settings.n_epochs = 3;
  options_.settings.kl_stop_factor = 0.0F;  // all epochs
  options_.threads = 2;
  Training(options_, pendulum()).run(never);
  const json end = lines().back(), &time = end["time"];
  EXPECT_EQ(time["threads"], 2);
  double sum_s = 0.0;
  for (const char* name :
       {"simulation_s", "inference_s", "learning_s", "evaluation_s", "waiting_s"}) {
    const double part_s = time[name].get<double>();
    // Waiting may be nothing; the rest is the work of threads, which none can exceed.
    EXPECT_GE(part_s, 0.0) << name;
    if (name != std::string("waiting_s")) {
      EXPECT_GT(part_s, 0.0) << name;
    }
    sum_s += part_s;
  }
  EXPECT_GE(sum_s, 2.0 * end["seconds"].get<double>() * (1.0 - 1e-9));
  EXPECT_EQ(time["steps"], end["steps"]);
  EXPECT_EQ(time["samples"], 3 * end["steps"].get<std::uint64_t>());
  // Actor 3-8-8-1 and critic 3-8-8-1: 113 numbers each.
  EXPECT_DOUBLE_EQ(time["inference_gflop"].get<double>(), 2e-9 * 226 * time["steps"].get<double>());
  EXPECT_DOUBLE_EQ(time["learning_gflop"].get<double>(),
                   6e-9 * 226 * time["samples"].get<double>());
}

TEST_F(TrainRecord, AResumedOneHasThePointsOfBefore) {
  options_.steps = 8192 * 3;
  options_.checkpoint = folder_.path("checkpoint");
  Training(options_, pendulum()).run(never);
  options_.steps = 8192 * 6;
  options_.resume = options_.checkpoint;
  options_.record = folder_.path("resumed.json");
  Training(options_, pendulum()).run(never);
  EXPECT_EQ(table_of(lines()), read_file(options_.csv));
  EXPECT_EQ(lines().front()["resume"], options_.resume);
}

TEST_F(TrainRecord, OneThatBreaksSaysWhy) {
  const Library library(EAGERX_TEST_PENDULUM);
  options_.steps = 8192 * 40;  // it breaks in the 32nd iteration
  setenv("EAGERX_TEST_BREAKS", "rollout", 1);
  EXPECT_THROW(Training(options_, library).run(never), Problem);
  unsetenv("EAGERX_TEST_BREAKS");
  const std::vector<json> all = lines();
  ASSERT_GT(all.size(), 2) << "the earlier points are there";
  EXPECT_EQ(all.back()["ended"], "failed");
  EXPECT_NE(all.back()["problem"].get<std::string>(), "");
}

TEST_F(TrainRecord, SeveralSeedsAreInOne) {
  options_.seeds = 3;
  options_.steps = 8192 * 2;
  train_seeds(options_, pendulum(), never);
  std::vector<std::uint64_t> ended;
  for (const json& line : lines()) {
    if (!line.contains("ended")) continue;
    ended.push_back(line["seed"].get<std::uint64_t>());
    const std::string path = line["policy"].get<std::string>();
    EXPECT_EQ(line["policy_hash"], host::hex_text(host::fnv1a(read_file(path))));
  }
  EXPECT_EQ(ended, (std::vector<std::uint64_t>{1, 2, 3}));
}

// Names of files may be any bytes, and JSON is UTF-8.
TEST_F(TrainRecord, NamesThatAreNoText) {
  options_.from = "\xff\"\n";
  Record record(options_, pendulum().description());
  record.fail(1, {}, Problem(kProblems, "\xfe is nan"));
  EXPECT_EQ(lines().size(), 2);
}

}  // namespace
}  // namespace eagerx::train
