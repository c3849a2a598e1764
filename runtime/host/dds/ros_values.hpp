// Numbers of the trace in messages of ROS 2.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <runtime/host/dds/messages.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace eagerx::ros {

constexpr std::int64_t kSecondInNs = 1'000'000'000;

inline Time time_of(std::int64_t ns) {
  return {static_cast<std::int32_t>(ns / kSecondInNs),
          static_cast<std::uint32_t>(ns % kSecondInNs)};
}

template <class T>
Sequence<T> sequence(T* elements, std::size_t size) {
  const auto count = static_cast<std::uint32_t>(size);
  return {count, count, elements, false};
}

using trace_log::value_of;

/// The types of one number and of many.
template <class OneType, class ManyType>
struct Std {
  using One = OneType;
  using Many = ManyType;
};

/// f(Std<…>) for what elements of this type are.
template <class F>
void with_dtype(trace_log::Dtype dtype, F&& f) {
  switch (dtype) {
    case trace_log::Dtype::float32:
      return f(Std<Float32, Float32MultiArray>());
    case trace_log::Dtype::float64:
      return f(Std<Float64, Float64MultiArray>());
    case trace_log::Dtype::int8:
      return f(Std<Int8, Int8MultiArray>());
    case trace_log::Dtype::int16:
      return f(Std<Int16, Int16MultiArray>());
    case trace_log::Dtype::int32:
      return f(Std<Int32, Int32MultiArray>());
    case trace_log::Dtype::int64:
      return f(Std<Int64, Int64MultiArray>());
    case trace_log::Dtype::uint8:
      return f(Std<UInt8, UInt8MultiArray>());
    case trace_log::Dtype::uint16:
      return f(Std<UInt16, UInt16MultiArray>());
    case trace_log::Dtype::uint32:
      return f(Std<UInt32, UInt32MultiArray>());
    case trace_log::Dtype::uint64:
      return f(Std<UInt64, UInt64MultiArray>());
    case trace_log::Dtype::boolean:
      return f(Std<Bool, UInt8MultiArray>());  // ROS 2 has no array of them
  }
}

/// The names of the elements of a message: `NAME_0`, `NAME_1` …
class Names {
 public:
  void make(const std::string& name, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) texts_.push_back(name + "_" + std::to_string(i));
    for (std::string& text : texts_) pointers_.push_back(text.data());
  }
  Sequence<char*> sequence() { return ros::sequence(pointers_.data(), pointers_.size()); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

}  // namespace eagerx::ros
