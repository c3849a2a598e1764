// Trainings of the tests' libraries.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {

/// The same pendulum with three voltages to choose from.
inline const Library& choices() {
  static const Library library(EAGERX_TEST_CHOICES);
  return library;
}

/// … and with a second number that halves them.
inline const Library& several() {
  static const Library library(EAGERX_TEST_SEVERAL);
  return library;
}

class TrainTraining : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(std::uint64_t iterations) const {
    Options result;
    result.settings = even_settings();
    result.library = EAGERX_TEST_PENDULUM;
    result.output = path("policy.safetensors");
    result.steps = iterations * kIteration;
    result.threads = 1;
    result.is_quiet = true;
    return result;
  }

  /// The bytes of the policy.
  std::string trained(const Options& options, const Library& library = pendulum()) const {
    Training(options, library).run(never);
    return read_file(options.output);
  }

 private:
  TestFolder folder_;
};

/// Quick, and does not succeed so soon.
inline Options small(Options options) {
  options.settings.net_arch = {8, 8};
  options.threads = 2;
  return options;
}

/// A column of a learning curve; NaN where it is empty.
inline std::vector<double> column_of(const std::string& csv, int column) {
  std::vector<double> result;
  std::istringstream rows(csv);
  std::string row, cell;
  std::getline(rows, row);  // names
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    for (int i = 0; i <= column; ++i) std::getline(cells, cell, ',');
    result.push_back(cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell));
  }
  return result;
}

}  // namespace eagerx::train
