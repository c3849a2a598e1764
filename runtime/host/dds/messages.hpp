// Made by make_messages of messages.idl, with Cyclone DDS's idlc.
#pragma once

#include <cstdint>
#include <runtime/host/dds/library.hpp>

namespace eagerx::ros {

using dds::Sequence;

struct Time {
  std::int32_t sec;
  std::uint32_t nanosec;
};
struct Header {
  Time stamp;
  char* frame_id;
};
struct Bool {
  bool data;
  static const dds::TopicType kType;
};
struct Float32 {
  float data;
  static const dds::TopicType kType;
};
struct Float64 {
  double data;
  static const dds::TopicType kType;
};
struct Int8 {
  std::int8_t data;
  static const dds::TopicType kType;
};
struct Int16 {
  std::int16_t data;
  static const dds::TopicType kType;
};
struct Int32 {
  std::int32_t data;
  static const dds::TopicType kType;
};
struct Int64 {
  std::int64_t data;
  static const dds::TopicType kType;
};
struct UInt8 {
  std::uint8_t data;
  static const dds::TopicType kType;
};
struct UInt16 {
  std::uint16_t data;
  static const dds::TopicType kType;
};
struct UInt32 {
  std::uint32_t data;
  static const dds::TopicType kType;
};
struct UInt64 {
  std::uint64_t data;
  static const dds::TopicType kType;
};
struct MultiArrayDimension {
  char* label;
  std::uint32_t size;
  std::uint32_t stride;
};
struct MultiArrayLayout {
  Sequence<MultiArrayDimension> dim;
  std::uint32_t data_offset;
};
struct Float32MultiArray {
  MultiArrayLayout layout;
  Sequence<float> data;
  static const dds::TopicType kType;
};
struct Float64MultiArray {
  MultiArrayLayout layout;
  Sequence<double> data;
  static const dds::TopicType kType;
};
struct Int8MultiArray {
  MultiArrayLayout layout;
  Sequence<std::int8_t> data;
  static const dds::TopicType kType;
};
struct Int16MultiArray {
  MultiArrayLayout layout;
  Sequence<std::int16_t> data;
  static const dds::TopicType kType;
};
struct Int32MultiArray {
  MultiArrayLayout layout;
  Sequence<std::int32_t> data;
  static const dds::TopicType kType;
};
struct Int64MultiArray {
  MultiArrayLayout layout;
  Sequence<std::int64_t> data;
  static const dds::TopicType kType;
};
struct UInt8MultiArray {
  MultiArrayLayout layout;
  Sequence<std::uint8_t> data;
  static const dds::TopicType kType;
};
struct UInt16MultiArray {
  MultiArrayLayout layout;
  Sequence<std::uint16_t> data;
  static const dds::TopicType kType;
};
struct UInt32MultiArray {
  MultiArrayLayout layout;
  Sequence<std::uint32_t> data;
  static const dds::TopicType kType;
};
struct UInt64MultiArray {
  MultiArrayLayout layout;
  Sequence<std::uint64_t> data;
  static const dds::TopicType kType;
};
struct Vector3 {
  double x;
  double y;
  double z;
};
struct Quaternion {
  double x;
  double y;
  double z;
  double w;
};
struct JointState {
  Header header;
  Sequence<char*> name;
  Sequence<double> position;
  Sequence<double> velocity;
  Sequence<double> effort;
  static const dds::TopicType kType;
};
struct Imu {
  Header header;
  Quaternion orientation;
  double orientation_covariance[9];
  Vector3 angular_velocity;
  double angular_velocity_covariance[9];
  Vector3 linear_acceleration;
  double linear_acceleration_covariance[9];
  static const dds::TopicType kType;
};
struct Image {
  Header header;
  std::uint32_t height;
  std::uint32_t width;
  char* encoding;
  std::uint8_t is_bigendian;
  std::uint32_t step;
  Sequence<std::uint8_t> data;
  static const dds::TopicType kType;
};
struct Clock {
  Time clock;
  static const dds::TopicType kType;
};

}  // namespace eagerx::ros
