// Files of a training on the page: records, tables of curves, results of sweeps; and invalid files.
#include "generator/tools/training/training.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "generator/tools/training/curves.hpp"
#include "generator/tools/training/settings.hpp"
#include "generator/tools/training/tables.hpp"

namespace eagerx::gen {
namespace {

const std::string kTrainingHead =
    R"({"eagerx_training":1,"graph":"arm","rate":30,"algorithm":"ppo","settings":"layers 8; clip 0.20; batch_size 256","seed":1,"seeds":1,"steps":100,"has_success":true,"terms":["angle","effort"]})"
    "\n";
const std::string kTrainingRow = R"({"seed":1,"steps":10,"return":-5.5})"
                                 "\n";
const std::string kTrainingEnd =
    R"({"seed":1,"ended":"success","steps":10,"seconds":2.5,"kernels":"avx2","time":{"threads":2,"simulation_s":1,"inference_s":0.5,"learning_s":2,"evaluation_s":1,"waiting_s":0.5,"steps":10,"samples":20,"inference_gflop":1,"learning_gflop":6},"policy":"p.safetensors","policy_hash":"0x1","evaluation":{"episodes":3,"successes":2,"return":-2,"lowest":-4,"highest":1,"steps":7,"terms":[-3,1],"saturated":0.1},"signs":[],"episodes":[["13835058055282163712",0,-4,7,1],["13835058055282163712",1,1,7,0],["13835058055282163713",2,-3,7,1]]})"
    "\n";

class Training : public testing::Test {
 protected:
  Training() {
    std::string draft =
        (std::filesystem::temp_directory_path() / "eagerx_training_XXXXXX").string();
    folder_ = mkdtemp(draft.data());
  }
  ~Training() override { std::filesystem::remove_all(folder_); }

  std::optional<TrainingRecord> read(const std::string& text) {
    const std::string path = (folder_ / "file").string();
    std::ofstream(path, std::ios::binary) << text;
    diagnostics_ = {};
    return read_training(path, sources_, diagnostics_);
  }
  /// The problem of a file that is none, with its line.
  std::string problem(const std::string& text) {
    const auto record = read(text);
    if (record || diagnostics_.error_count() != 1) return "no problem, or several";
    const Diagnostic& first = diagnostics_.all().front();
    EXPECT_EQ(first.code, "E0363");
    EXPECT_TRUE(first.io);
    return std::to_string(first.span.line) + first.message.substr(first.message.rfind(": "));
  }

  std::filesystem::path folder_;
  SourceMap sources_;
  Diagnostics diagnostics_;
};

std::vector<double> numbers(const Json* json) {
  std::vector<double> all;
  for (const Json& item : *json->as<Json::List>()) all.push_back(number_of(&item).value_or(NAN));
  return all;
}

/// The line `name` of the chart `chart`.
const Json& line(const Json& page, const std::string& chart, const std::string& name) {
  for (const Json& each : *member(&page, "charts")->as<Json::List>()) {
    if (text_of(member(&each, "name")) != chart) continue;
    for (const Json& one : *member(&each, "lines")->as<Json::List>())
      if (text_of(member(&one, "name")) == name) return one;
  }
  static const Json nothing;
  ADD_FAILURE() << "there is no line " << name << " in " << chart;
  return nothing;
}

using Numbers = std::vector<double>;
constexpr const char* kNoisy = "last 100 episodes, with noise";
constexpr const char* kEvaluated = "evaluation, without noise";

TEST_F(Training, ARecord) {
  const auto record = read(
      kTrainingHead + kTrainingRow +
      R"({"seed":1,"steps":20,"return":-4,"eval_return":-3,"evaluation_success":0.5,"terms":[-4,1]})"
      "\n" +
      kTrainingEnd);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->graph, "arm");
  EXPECT_EQ(record->policy, "p.safetensors");
  EXPECT_EQ(record->policy_hash, "0x1");
  EXPECT_EQ(numbers(member(&line(record->page, "Return", kNoisy), "y")), Numbers({-5.5, -4}));
  EXPECT_EQ(numbers(member(&line(record->page, "Return", kEvaluated), "x")), Numbers({20}));
  EXPECT_EQ(
      numbers(member(&line(record->page, "Terms of the return, in evaluations", "effort"), "y")),
      Numbers({1}));
  const Json& training = member(&record->page, "trainings")->as<Json::List>()->front();
  EXPECT_EQ(text_of(member(&training, "ended")), "success");
  ASSERT_EQ(record->episodes.size(), 3);
  EXPECT_EQ(record->episodes[2].seed, 13835058055282163713U) << "all 64 bits";
}

// Success counts before the return; the first of equal ones is shown.
TEST_F(Training, BestAndWorstEpisode) {
  const auto shown = best_and_worst({{1, 0, -4, 7, true},
                                     {1, 1, 9, 7, false},
                                     {1, 2, -3, 7, true},
                                     {1, 3, 9, 7, false},
                                     {1, 4, -3, 7, true}});
  EXPECT_EQ(shown.best.environment, 2);
  EXPECT_EQ(shown.worst.environment, 1);
}

TEST_F(Training, OneThatGoesOnHasNoEnd) {
  const auto record = read(kTrainingHead + kTrainingRow);
  ASSERT_TRUE(record);
  EXPECT_TRUE(record->policy.empty());
  const Json& training = member(&record->page, "trainings")->as<Json::List>()->front();
  EXPECT_TRUE(member(&training, "ended")->is<std::monostate>());
  EXPECT_EQ(number_of(member(&training, "steps")), 10);
  EXPECT_TRUE(read(kTrainingHead)) << "it has just begun";
}

TEST_F(Training, OneThatFailedSaysWhy) {
  const auto record = read(
      kTrainingHead + kTrainingRow +
      "{\"seed\":1,\"ended\":\"failed\",\"problem\":\"`task.x` is nan\",\"help\":\"max()\"}\n");
  ASSERT_TRUE(record);
  const Json& training = member(&record->page, "trainings")->as<Json::List>()->front();
  EXPECT_EQ(text_of(member(&training, "problem")), "`task.x` is nan");
}

TEST_F(Training, TheBestSeedIsShown) {
  std::string second = kTrainingEnd;
  second.replace(second.find("\"seed\":1"), 8, "\"seed\":2");
  second.replace(second.find("\"successes\":2"), 13, "\"successes\":3");
  second.replace(second.find("p.safe"), 6, "q.safe");
  const auto record = read(kTrainingHead + kTrainingEnd + second);
  ASSERT_TRUE(record);
  EXPECT_EQ(number_of(member(&record->page, "best")), 1);
  EXPECT_EQ(record->policy, "q.safetensors");
}

TEST_F(Training, RecordsThatAreNone) {
  EXPECT_EQ(problem(""), "0: nothing that a training has written begins so");
  EXPECT_EQ(problem("{"), "1: the file is cut off");
  EXPECT_EQ(problem("{}\n"), "1: no record of a training begins so");
  EXPECT_EQ(problem("{\"eagerx_training\":2}\n"),
            "1: another version of eagerx-gen has written it");
  EXPECT_EQ(problem(kTrainingHead + kTrainingRow.substr(0, 20)), "2: the file is cut off");
  EXPECT_EQ(problem(kTrainingHead + kTrainingRow.substr(0, 20) + "\n"),
            "2: it is not a JSON object");
  EXPECT_EQ(problem(kTrainingHead + kTrainingRow + kTrainingRow),
            "3: its steps are not more than those before");
  EXPECT_EQ(problem(kTrainingHead + kTrainingEnd + kTrainingRow),
            "3: this training had ended before");
  EXPECT_EQ(problem(kTrainingHead + "{\"seed\":1,\"steps\":\"ten\"}\n"),
            "2: `steps` is not a number");
  EXPECT_EQ(problem(kTrainingHead + "{\"seed\":-1,\"steps\":1}\n"),
            "2: `seed` is not a whole number from 0 to 4611686018427387904");
  EXPECT_EQ(problem(kTrainingHead + "{\"seed\":1,\"steps\":1,\"terms\":[1]}\n"),
            "2: `terms` are not 2 numbers");
  EXPECT_EQ(problem(kTrainingHead + "{\"seed\":1,\"ended\":\"well\"}\n"), "2: `ended`");
  std::string bad = kTrainingEnd;
  bad.replace(bad.find("13835058055282163713"), 20, "99999999999999999999");
  EXPECT_EQ(problem(kTrainingHead + bad),
            "2: an episode is not [seed, environment, return, steps, success]");
  std::string many = kTrainingHead;
  for (int i = 0; i <= 1000; ++i) many += "{\"seed\":" + std::to_string(i) + ",\"steps\":1}\n";
  EXPECT_EQ(problem(many), "1002: there are more trainings than may be");
  EXPECT_FALSE(read("\xff\xfe{"));
}

/// Cut anywhere, a record is one problem or a shorter record; nothing else.
TEST_F(Training, CutAnywhere) {
  const std::string whole = kTrainingHead + kTrainingRow + kTrainingEnd;
  std::size_t good = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const bool is_read = read(whole.substr(0, length)).has_value();
    good += is_read ? 1 : 0;
    EXPECT_EQ(diagnostics_.error_count(), is_read ? 0 : 1) << length;
  }
  EXPECT_EQ(good, 2) << "at the ends of its lines";
}

TEST_F(Training, ATableOfACurve) {
  for (const std::string columns :
       {"steps,return,success_rate,eval_return,eval_success_rate,std,learning_rate,approx_kl\n",
        "steps,return,success,evaluation_return,evaluation_success,deviation,step_size,"
        "divergence\n"}) {
    const auto record =
        read(columns + "8192,-10,,,,1,0.001,0.01\n16384,-8,,-7,0.5,0.9,0.001,0.02\n");
    ASSERT_TRUE(record);
    EXPECT_EQ(numbers(member(&line(record->page, "Return", kNoisy), "y")), Numbers({-10, -8}));
    EXPECT_EQ(numbers(member(&line(record->page, "Return", kEvaluated), "x")), Numbers({16384}));
    const char* const kDivergence = "KL divergence of an iteration";
    EXPECT_EQ(numbers(member(&line(record->page, kDivergence, kDivergence), "y")),
              Numbers({0.01, 0.02}));
    EXPECT_TRUE(record->episodes.empty());
  }
}

TEST_F(Training, StagesAreShown) {
  const auto record = read(
      "steps,return,stage,stage_success_rate,stage_return\n10,-9,1,,\n20,-8,1,0.5,-7\n30,-20,2,,"
      "\n");
  ASSERT_TRUE(record);
  const char* const kInStage = "in its stage, without noise";
  EXPECT_EQ(numbers(member(&line(record->page, "Return", kInStage), "x")), Numbers({20}));
  EXPECT_EQ(numbers(member(&line(record->page, "Success", kInStage), "y")), Numbers({0.5}));
  const char* const kStage = "Stage of the task, from 1";
  EXPECT_EQ(numbers(member(&line(record->page, kStage, kStage), "y")), Numbers({1, 1, 2}));
}

TEST_F(Training, TablesThatAreNone) {
  const std::string head = "seed,steps,return\n";
  EXPECT_EQ(problem("a,b\n1,2\n"), "1: nothing that a training has written begins so");
  EXPECT_EQ(problem(head + "1,10\n"), "2: it has 2 cells, and the first line has 3");
  EXPECT_EQ(problem(head + "1,10,-1\n1,20,x\n"), "3: `return` is not a number");
  EXPECT_EQ(problem(head + "1,10,nan\n"), "2: `return` is not a number");
  EXPECT_EQ(problem(head + "1,10,-1\n1,10,-1\n"), "3: its steps are not more than those before");
  EXPECT_EQ(problem(head + "1,10,-1"), "2: the file is cut off");
  EXPECT_EQ(problem(head + "one,10,-1\n"), "2: `seed` is not a whole number");
}

// One that has ended stays as it was: at 30 the first is still at -8.
TEST_F(Training, SeveralSeedsHaveABand) {
  const auto record = read("seed,steps,return\n1,10,-10\n1,20,-8\n2,10,-20\n2,20,\n2,30,-6\n");
  ASSERT_TRUE(record);
  const Json& band = line(record->page, "Return", kNoisy);
  EXPECT_EQ(numbers(member(&band, "x")), Numbers({10, 20, 30}));
  EXPECT_EQ(numbers(member(&band, "y")), Numbers({-15, -14, -7}));
  EXPECT_EQ(numbers(member(&band, "low")), Numbers({-20, -20, -8}));
  EXPECT_EQ(numbers(member(&band, "high")), Numbers({-10, -8, -6}));
}

TEST_F(Training, ALongCurveKeepsItsPeaks) {
  LearningCurve curve;
  for (int i = 0; i < 10'000; ++i) {
    curve.steps.push_back(i);
    for (auto& column : curve.columns) column.push_back(i == 4321 ? 100.0 : std::sin(i));
  }
  const Json charts = curve_charts({curve}, {});
  const Json& first = member(&charts.as<Json::List>()->front(), "lines")->as<Json::List>()->front();
  const Numbers high = numbers(member(&first, "high")), low = numbers(member(&first, "low"));
  EXPECT_LE(high.size(), 1000);
  EXPECT_EQ(*std::ranges::max_element(high), 100.0);
  EXPECT_LT(*std::ranges::min_element(low), -0.99);
  EXPECT_EQ(numbers(member(&first, "x")).back(), 9999) << "the last point is there";
}

TEST_F(Training, SettingsNextToTheirDefaults) {
  const Json settings = settings_json("layers 8; clip 0.20; batch_size 256; future 7", "ppo");
  const auto& rows = *settings.as<Json::List>();
  ASSERT_EQ(rows.size(), 3) << "not those of another algorithm";
  EXPECT_EQ(truth_of(member(&rows[0], "differs")), true);
  EXPECT_EQ(text_of(member(&rows[0], "default")), "64,64");
  EXPECT_EQ(truth_of(member(&rows[1], "differs")), false) << "0.20 is 0.2";
  EXPECT_TRUE(member(&rows[2], "default")->is<std::monostate>()) << "of another version";
  EXPECT_EQ(text_of(member(&rows[0], "name")), "net_arch") << "`layers` is its former name";
}

const std::string kSweep =
    "training,settings,seed,succeeds,steps,successes,episodes,return,processor_s,problem\n";

TEST_F(Training, ASweepHasTheBestFirst) {
  const auto record = read(kSweep +
                           "0123456789abcdef,\"clip=0.1 layers=8,8\",1,0,100,10,40,-9,1,\"\"\n"
                           "0123456789abcdee,\"clip=0.3 layers=8,8\",1,1,100,40,40,-5,1,\"\"\n"
                           "0123456789abcded,\"clip=0.3 layers=8,8\",2,0,100,20,40,-7,1,\"\"\n"
                           "0123456789abcdec,\"clip=0.1 layers=8,8\",2,0,0,0,0,0,0,\"x is nan\"\n");
  ASSERT_TRUE(record);
  const auto& cases = *member(&record->page, "cases")->as<Json::List>();
  ASSERT_EQ(cases.size(), 2);
  EXPECT_EQ(text_of(&member(&cases[0], "values")->as<Json::List>()->front()), "0.3");
  EXPECT_EQ(number_of(member(&cases[0], "return")), -6);
  EXPECT_EQ(number_of(member(&cases[1], "seeds")), 2) << "one of them broke";
  const auto& charts = *member(&record->page, "charts")->as<Json::List>();
  ASSERT_EQ(charts.size(), 1) << "layers are the same everywhere";
  EXPECT_EQ(text_of(&member(&charts[0], "labels")->as<Json::List>()->front()), "0.1");
}

/// A table of a sweep over `clip` with these values, each a training.
std::string sweep_over(const std::vector<std::string>& values) {
  std::string text(kSweepHeader);
  for (const std::string& value : values)
    text += "\n0123456789abcdef,\"clip=" + value + "\",1,1,100,3,4,-1,0.5,\"\"";
  return text + "\n";
}

// NaN has no order among numbers, so sorting must handle it.
TEST_F(Training, ASweepOverWhatIsNoNumber) {
  std::vector<std::string> values;
  for (int i = 0; i < 40; ++i) values.push_back(i % 3 == 1 ? "nan" : std::to_string(40 - i));
  const auto record = read(sweep_over(values));
  ASSERT_TRUE(record);
  const Json& chart = member(&record->page, "charts")->as<Json::List>()->front();
  const auto& labels = *member(&chart, "labels")->as<Json::List>();
  EXPECT_EQ(text_of(&labels.back()), "nan");
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < labels.size(); ++i) {
    EXPECT_GT(std::stod(text_of(&labels[i])), before);
    before = std::stod(text_of(&labels[i]));
  }
}

// With each row looked for among all others this takes minutes.
TEST_F(Training, ASweepOfManySettings) {
  std::vector<std::string> values;
  for (int i = 0; i < 100'000; ++i) values.push_back(std::to_string(i));
  const auto record = read(sweep_over(values));
  ASSERT_TRUE(record);
  EXPECT_EQ(member(&record->page, "cases")->as<Json::List>()->size(), values.size());
}

// Each of these short lines asks for a thousand numbers.
TEST_F(Training, ARecordThatAsksForTooMuchMemory) {
  std::string terms = R"("a0")";
  for (int i = 1; i < 1000; ++i) terms += ",\"a" + std::to_string(i) + '"';
  std::string text = kTrainingHead;
  const std::string named = R"("angle","effort")";
  text.replace(text.find(named), named.size(), terms);
  const std::size_t most = kMostNumbers / 1000 + 2;
  for (std::size_t i = 1; i <= most; ++i)
    text += R"({"seed":1,"steps":)" + std::to_string(i) + "}\n";
  EXPECT_NE(problem(text).find("there are more numbers than may be"), std::string::npos);
}

TEST_F(Training, SweepsThatAreNone) {
  EXPECT_EQ(problem(kSweep + "0,\"clip=0.1\",1,0,100\n"), "2: it has 5 cells instead of 10");
  EXPECT_EQ(problem(kSweep + "0,\"clip\",1,0,100,10,40,-9,1,\"\"\n"),
            "2: `settings` are not NAME=VALUE");
  EXPECT_EQ(problem(kSweep + "0,\"clip=1\",1,0,inf,10,40,-9,1,\"\"\n"),
            "2: `steps` is not a number");
  EXPECT_EQ(
      problem(kSweep + "0,\"clip=1\",1,0,1,10,40,-9,1,\"\"\n0,\"horizon=1\",1,0,1,1,1,1,1,\"\"\n"),
      "3: it has other settings");
}

}  // namespace
}  // namespace eagerx::gen
