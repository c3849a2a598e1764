// Reads a CSV of actions. Everything is read and checked before the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// A problem with the file of actions; `exit_code` is kBadActions or kBadFile. Empty text: no
/// problem.
struct ActionProblem {
  std::string text;
  int exit_code = 0;
};

/// One cell of a CSV file, with its place: lines and columns from 1, columns in bytes.
struct Cell {
  std::string_view text;
  std::size_t line;
  std::size_t column;
};

/// The text of a CSV file cut into rows of cells. No quotes: it holds numbers and plain names.
class CsvFile {
 public:
  /// False if `path` cannot be read; `problem` then says why.
  bool read(const std::string& path, ActionProblem& problem);

  const std::vector<std::vector<Cell>>& rows() const { return rows_; }
  std::size_t lines() const { return lines_; }

  /// "path:line:column: text"
  ActionProblem at(std::size_t line, std::size_t column, const std::string& text) const;

 private:
  void add_row(std::string_view line, std::size_t number);

  std::string path_;
  std::string text_;
  std::vector<std::vector<Cell>> rows_;
  std::size_t lines_ = 0;
};

/// The actions of an episode, one for each step.
class ActionTable {
 public:
  /// `zero`: an action of `bytes` that does nothing.
  ActionTable(const std::vector<Field>& actions, const void* zero, std::size_t bytes);

  /// Reads and checks `path`; an episode needs `steps` rows, more are fine.
  ActionProblem load(const std::string& path, std::uint64_t steps);

  std::uint64_t size() const { return count_; }
  const void* operator[](std::uint64_t step) const { return rows_.data() + step * bytes_; }

 private:
  /// Takes a row with as many cells as there are columns. Returns the first cell that is not a
  /// number its action can hold, or null.
  const Cell* add(const std::vector<Cell>& row);

  const std::vector<Field>& actions_;
  std::vector<std::string> columns_;  // `name`, or `name[0]`, `name[1]` …
  std::vector<std::byte> zero_;
  std::size_t bytes_;
  std::vector<std::byte> rows_;  // [count][bytes]
  std::uint64_t count_ = 0;
};

}  // namespace eagerx::linux_sim
