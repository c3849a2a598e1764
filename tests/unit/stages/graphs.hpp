// Shared by tests of stages: a graph, and a folder for files.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {

/// A pendulum that a filter drives; `more` are further keys.
inline std::string swing(const std::string& rate_of_filter = "30", const std::string& more = "") {
  return "name: swing\nrate: 30\nengine: {type: OdeEngine, rate: 30}\n"
         "objects:\n  pendulum: {type: Pendulum}\n"
         "nodes:\n  smooth: {type: ButterworthFilter, rate: " +
         rate_of_filter +
         ", config: {order: 2, cutoff_hz: 6}}\n"
         "actions:\n  voltage: {space: {like: pendulum.u}}\n"
         "observations: [angle]\n"
         "connections:\n"
         "  - {from: actions.voltage, to: smooth.signal}\n"
         "  - {from: smooth.filtered, to: pendulum.u}\n"
         "  - {from: pendulum.theta, to: observations.angle}\n" +
         more;
}

/// A folder for files of a test, which is removed.
class TestFolder {
 public:
  TestFolder() {
    std::string name = testing::TempDir() + "eagerx-stages-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  /// The path of a file with this text.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
    return path_ + "/" + name;
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace eagerx::gen
