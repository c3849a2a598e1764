// Values as bytes, for checkpoints and for other ranks.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace eagerx::train {

/// Visits values in an order: writes them.
class Writer {
 public:
  std::string bytes;

  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) (*this)(value);
  }
};

/// The same, and reads them. False in `complete` if there are not enough.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  bool complete = true;

  template <class T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    complete = complete && bytes_.size() >= sizeof value;
    if (!complete) return;
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  void operator()(bool& value) {
    std::uint8_t byte = 0;
    (*this)(byte);
    complete = complete && byte <= 1;
    value = byte == 1;
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    std::uint64_t count = 0;
    (*this)(count);
    complete = complete && count <= bytes_.size() / sizeof(T);
    if (!complete) return;
    values.resize(count);
    for (T& value : values) (*this)(value);
  }

 private:
  std::string_view bytes_;
};

}  // namespace eagerx::train
