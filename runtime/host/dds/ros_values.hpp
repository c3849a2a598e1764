// Messages of ROS 2, as idlc makes them of messages.idl, and numbers of the trace in them.
#pragma once

#include <messages.h>

#include <cstddef>
#include <cstdint>
#include <runtime/host/dds/library.hpp>
#include <runtime/host/dds/stamp.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <vector>

namespace eagerx::ros {

inline builtin_interfaces_msg_dds__Time_ time_of(dds::Stamp stamp) {
  return {stamp.s, stamp.ns};
}

/// Lets `sequence` be these elements, which stay the caller's.
template <class Sequence, class T>
void point(Sequence& sequence, T* elements, std::size_t size) {
  const auto count = static_cast<std::uint32_t>(size);
  sequence = {count, count, elements, false};
}

using trace_log::value_of;

/// The types of one number and of many, and the library's descriptions of them.
template <class OneType, class ManyType>
struct Std {
  using One = OneType;
  using Many = ManyType;
  const dds::TopicType& one;
  const dds::TopicType& many;
};
template <class One, class Many>
Std<One, Many> std_of(const dds::TopicType& one, const dds::TopicType& many) {
  return {one, many};
}

/// Calls f(Std<…>) for this type of elements.
template <class F>
void with_dtype(trace_log::Dtype dtype, F&& f) {
  switch (dtype) {
    case trace_log::Dtype::float32:
      return f(std_of<std_msgs_msg_dds__Float32_, std_msgs_msg_dds__Float32MultiArray_>(
          std_msgs_msg_dds__Float32__desc, std_msgs_msg_dds__Float32MultiArray__desc));
    case trace_log::Dtype::float64:
      return f(std_of<std_msgs_msg_dds__Float64_, std_msgs_msg_dds__Float64MultiArray_>(
          std_msgs_msg_dds__Float64__desc, std_msgs_msg_dds__Float64MultiArray__desc));
    case trace_log::Dtype::int8:
      return f(std_of<std_msgs_msg_dds__Int8_, std_msgs_msg_dds__Int8MultiArray_>(
          std_msgs_msg_dds__Int8__desc, std_msgs_msg_dds__Int8MultiArray__desc));
    case trace_log::Dtype::int16:
      return f(std_of<std_msgs_msg_dds__Int16_, std_msgs_msg_dds__Int16MultiArray_>(
          std_msgs_msg_dds__Int16__desc, std_msgs_msg_dds__Int16MultiArray__desc));
    case trace_log::Dtype::int32:
      return f(std_of<std_msgs_msg_dds__Int32_, std_msgs_msg_dds__Int32MultiArray_>(
          std_msgs_msg_dds__Int32__desc, std_msgs_msg_dds__Int32MultiArray__desc));
    case trace_log::Dtype::int64:
      return f(std_of<std_msgs_msg_dds__Int64_, std_msgs_msg_dds__Int64MultiArray_>(
          std_msgs_msg_dds__Int64__desc, std_msgs_msg_dds__Int64MultiArray__desc));
    case trace_log::Dtype::uint8:
      return f(std_of<std_msgs_msg_dds__UInt8_, std_msgs_msg_dds__UInt8MultiArray_>(
          std_msgs_msg_dds__UInt8__desc, std_msgs_msg_dds__UInt8MultiArray__desc));
    case trace_log::Dtype::uint16:
      return f(std_of<std_msgs_msg_dds__UInt16_, std_msgs_msg_dds__UInt16MultiArray_>(
          std_msgs_msg_dds__UInt16__desc, std_msgs_msg_dds__UInt16MultiArray__desc));
    case trace_log::Dtype::uint32:
      return f(std_of<std_msgs_msg_dds__UInt32_, std_msgs_msg_dds__UInt32MultiArray_>(
          std_msgs_msg_dds__UInt32__desc, std_msgs_msg_dds__UInt32MultiArray__desc));
    case trace_log::Dtype::uint64:
      return f(std_of<std_msgs_msg_dds__UInt64_, std_msgs_msg_dds__UInt64MultiArray_>(
          std_msgs_msg_dds__UInt64__desc, std_msgs_msg_dds__UInt64MultiArray__desc));
    case trace_log::Dtype::boolean:
      return f(std_of<std_msgs_msg_dds__Bool_, std_msgs_msg_dds__UInt8MultiArray_>(
          std_msgs_msg_dds__Bool__desc,
          std_msgs_msg_dds__UInt8MultiArray__desc));  // ROS 2 has no array of them
  }
}

/// The names of the elements of a message: `NAME_0`, `NAME_1` …
class Names {
 public:
  void make(const std::string& name, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) texts_.push_back(name + "_" + std::to_string(i));
    for (std::string& text : texts_) pointers_.push_back(text.data());
  }
  template <class Sequence>
  void give(Sequence& sequence) {
    point(sequence, pointers_.data(), pointers_.size());
  }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

}  // namespace eagerx::ros
