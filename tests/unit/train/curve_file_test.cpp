// The table of a learning curve while it grows.
#include "targets/environments/train/curve_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

class TrainCurveFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  TestFolder folder_;
};

TEST_F(TrainCurveFile, IsWrittenAtOnceAndThenEachSecond) {
  CurveFile file(path("curve.csv"));
  const auto grown = [&](double now_s, const char* text) {
    EXPECT_EQ(file.grow(now_s, [&] { return text; }), "");
    return read_file(path("curve.csv"));
  };
  EXPECT_EQ(grown(0.3, "one"), "one");
  EXPECT_EQ(grown(1.2, "two"), "one");
  EXPECT_EQ(grown(1.3, "three"), "three");
}

TEST_F(TrainCurveFile, AFullDiskIsReportedOnceAndTriedAgain) {
  CurveFile file(path("curve.csv"));
  const auto text = [] { return "rows"; };
  fs::create_directories(path("curve.csv"));  // nothing can be written there
  EXPECT_NE(file.grow(0.0, text).find("cannot write"), std::string::npos);
  EXPECT_EQ(file.grow(2.0, text), "");
  fs::remove(path("curve.csv"));
  EXPECT_EQ(file.grow(4.0, text), "");
  EXPECT_EQ(read_file(path("curve.csv")), "rows");
}

// At 9028afbf, a FIFO or device was replaced by a file.
TEST_F(TrainCurveFile, WhatCannotBeReadAgainGetsTheCompleteTableOnly) {
  ASSERT_EQ(mkfifo(path("fifo").c_str(), 0600), 0);
  const int reader = open(path("fifo").c_str(), O_RDONLY | O_NONBLOCK);
  CurveFile file(path("fifo"));
  EXPECT_EQ(file.grow(0.0, [] { return "begun"; }), "");
  file.write([] { return "complete"; });
  std::array<char, 64> bytes{};
  const ssize_t count = read(reader, bytes.data(), bytes.size());
  EXPECT_EQ(std::string(bytes.data(), count < 0 ? 0 : static_cast<std::size_t>(count)), "complete");
  close(reader);
}

TEST_F(TrainCurveFile, WithoutANameThereIsNone) {
  EXPECT_EQ(CurveFile("").grow(0.0, []() -> std::string { throw 1; }), "");
}

// Before, the table was written at the end only: a training that a reward ends had none.
TEST_F(TrainCurveFile, ATrainingThatBreaksHasRowsOfBefore) {
  Options options;
  options.settings = even_settings();
  options.output = path("policy.safetensors");
  options.csv = path("curve.csv");
  options.settings.net_arch = {8, 8};
  options.settings.stagger = false;  // the library counts whole episodes
  options.threads = 1;
  options.is_quiet = true;
  const Library library(EAGERX_TEST_PENDULUM);
  setenv("EAGERX_TEST_BREAKS", "rollout", 1);
  EXPECT_THROW(Training(options, library).run(Interrupt(false)), Problem);
  unsetenv("EAGERX_TEST_BREAKS");
  EXPECT_FALSE(fs::exists(options.output));
  EXPECT_TRUE(read_file(options.csv).starts_with("steps,return,"));
  EXPECT_NE(read_file(options.csv).find("\n8192,"), std::string::npos);
}

}  // namespace
}  // namespace eagerx::train
