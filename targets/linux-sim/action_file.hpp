// Reads a CSV of actions. Everything is read and checked before the run.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <string>
#include <string_view>
#include <type_traits>
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

/// Reads one number of type `T` exactly: no spaces inside, nothing after it, in range, finite.
template <class T>
bool parse_cell(std::string_view text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (text != "0" && text != "1") return false;
    value = text == "1";
    return true;
  } else {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return false;
    if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
    return true;
  }
}

/// Where the rows of a file of actions go; made by ActionTable, which knows the graph.
class ActionSink {
 public:
  ActionSink() = default;
  ActionSink(const ActionSink&) = delete;
  ActionSink& operator=(const ActionSink&) = delete;
  virtual ~ActionSink() = default;

  /// Takes a row with as many cells as there are columns. Returns the first cell that is not a
  /// number its action can hold, or null.
  virtual const Cell* add(const std::vector<Cell>& row) = 0;

  /// Reads and checks `path`; an episode needs `steps` rows, more are fine.
  ActionProblem load(const std::string& path, std::uint64_t steps);

 protected:
  /// Columns of an action: `name`, or `name[0]`, `name[1]` …
  void add_columns(const char* name, std::size_t size, bool scalar);

 private:
  std::vector<std::string> columns_;
};

/// The actions of an episode, one for each step.
template <class Graph>
class ActionTable final : public ActionSink {
 public:
  using Action = typename Graph::Action;

  ActionTable() {
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&...) {
      using Message = std::remove_cvref_t<decltype(message)>;
      add_columns(name, size_of<Message>, std::is_arithmetic_v<Message>);
    });
  }

  const Cell* add(const std::vector<Cell>& row) override {
    const Cell* cell = row.data();
    const Cell* bad = nullptr;
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char*, auto& message, const auto&...) {
      using Message = std::remove_cvref_t<decltype(message)>;
      for (std::size_t i = 0; i < size_of<Message>; ++i, ++cell) {
        if (!parse_cell(cell->text, element(message, i)) && bad == nullptr) bad = cell;
      }
    });
    actions_.push_back(action);
    return bad;
  }

  std::uint64_t size() const { return actions_.size(); }
  const Action& operator[](std::uint64_t step) const { return actions_[step]; }

 private:
  std::vector<Action> actions_;
};

}  // namespace eagerx::linux_sim
