// Reference data next to the tests.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace eagerx::models::testing {

using Row = std::vector<std::string>;

/// The rows of tests/data/models/`name` without the header line. A missing or empty file fails the
/// test.
inline std::vector<Row> read_csv(const std::string& name) {
  std::ifstream file(std::string(EAGERX_SOURCE_DIR "/tests/data/models/") + name);
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::stringstream cells(line);
    std::string cell;
    Row row;
    while (std::getline(cells, cell, ',')) row.push_back(cell);
    rows.push_back(row);
  }
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}

}  // namespace eagerx::models::testing
