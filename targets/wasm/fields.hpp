// Addresses and names of the numbers of a simulation that JavaScript reads and writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <string>
#include <string_view>
#include <targets/common/dtype.hpp>
#include <vector>

namespace eagerx::wasm {

/// As JSON has it.
inline std::string quoted(std::string_view text) {
  constexpr unsigned char kFirstPrintable = 0x20;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < kFirstPrintable ? ' ' : c;
  }
  return result + "\"";
}

/// Fields in a row of numbers, in the graph's order. `low` and `high` are the bounds of each
/// number, where all fields have a space.
class Fields {
 public:
  std::vector<double> values, low, high;

  template <class Message, class Space>
  void add(std::string_view name, const Space& space, std::size_t messages = 1) {
    add(name, target::dtype_of<ScalarOf<Message>>(), messages * size_of<Message>, messages);
    for (std::size_t m = 0; m < messages; ++m) {
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        low.push_back(static_cast<double>(element(space.low, i)));
        high.push_back(static_cast<double>(element(space.high, i)));
      }
    }
  }
  void add(std::string_view name, std::string_view dtype, std::size_t numbers,
           std::size_t messages = 1) {
    json_ += (json_.empty() ? "" : ", ") + std::string("{\"name\": ") + quoted(name) +
             ", \"dtype\": " + quoted(dtype) + ", \"first\": " + std::to_string(values.size()) +
             ", \"numbers\": " + std::to_string(numbers) +
             ", \"messages\": " + std::to_string(messages) + "}";
    values.resize(values.size() + numbers);
  }

  std::string list() const { return "[" + json_ + "]"; }

 private:
  std::string json_;
};

}  // namespace eagerx::wasm
