// Assigns the columns of a row to fields.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace eagerx::environments {

/// First columns of fields. Fields are numbered in the graph's order; columns are in the order of
/// their names, because gymnasium.spaces.Dict sorts its keys and policies take them so.
class Columns {
 public:
  void add(const char* name, std::size_t numbers);
  /// Behind the last add().
  void arrange();

  std::size_t first(std::size_t field) const { return first_[field]; }
  /// Of a row.
  std::size_t numbers() const { return numbers_; }
  /// Fields in the order of their columns.
  const std::vector<std::size_t>& order() const { return order_; }

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> sizes_, first_, order_;
  std::size_t numbers_ = 0;
};

}  // namespace eagerx::environments
