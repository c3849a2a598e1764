// Rows in the answer of eagerx_describe().
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <targets/environments/base/columns.hpp>
#include <vector>

namespace eagerx::environments {

/// Of one message.
struct MessageType {
  std::vector<std::size_t> shape;
  std::string dtype;  // as graphs and numpy write it: "float32", "bool"
};

/// One object for each field of a row, in the order of the columns.
class Fields {
 public:
  /// `columns` stay valid.
  explicit Fields(const Columns& columns) : columns_(columns) {}

  /// `windows` above 1: number of messages, the first number of the shape. `low` and `high`:
  /// bounds of the elements of one message.
  void add(const char* name, const MessageType& type, std::uint32_t windows,
           const std::vector<double>& low, const std::vector<double>& high);
  /// Without bounds.
  void add(const char* name, const MessageType& type);

  /// As JSON's list.
  std::string list() const;

 private:
  const Columns& columns_;
  std::vector<std::string> texts_;
};

}  // namespace eagerx::environments
