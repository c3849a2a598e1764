// Made by make_messages of messages.idl, with Cyclone DDS's idlc.
#include <cstddef>
#include <runtime/host/dds/messages.hpp>

namespace eagerx::ros {
namespace {

constexpr std::uint32_t kBoolOps[] = {0x10e0000U, offsetof(Bool, data), 0x0U};
constexpr std::uint32_t kFloat32Ops[] = {0x1030002U, offsetof(Float32, data), 0x0U};
constexpr std::uint32_t kFloat64Ops[] = {0x1040002U, offsetof(Float64, data), 0x0U};
constexpr std::uint32_t kInt8Ops[] = {0x1010004U, offsetof(Int8, data), 0x0U};
constexpr std::uint32_t kInt16Ops[] = {0x1020004U, offsetof(Int16, data), 0x0U};
constexpr std::uint32_t kInt32Ops[] = {0x1030004U, offsetof(Int32, data), 0x0U};
constexpr std::uint32_t kInt64Ops[] = {0x1040004U, offsetof(Int64, data), 0x0U};
constexpr std::uint32_t kUInt8Ops[] = {0x1010000U, offsetof(UInt8, data), 0x0U};
constexpr std::uint32_t kUInt16Ops[] = {0x1020000U, offsetof(UInt16, data), 0x0U};
constexpr std::uint32_t kUInt32Ops[] = {0x1030000U, offsetof(UInt32, data), 0x0U};
constexpr std::uint32_t kUInt64Ops[] = {0x1040000U, offsetof(UInt64, data), 0x0U};
constexpr std::uint32_t kFloat32MultiArrayOps[] = {0x10d0000U,
                                                   offsetof(Float32MultiArray, layout),
                                                   0x30006U,
                                                   0x1070302U,
                                                   offsetof(Float32MultiArray, data),
                                                   0x0U,
                                                   0x1070a00U,
                                                   offsetof(MultiArrayLayout, dim),
                                                   sizeof(MultiArrayDimension),
                                                   0x40007U,
                                                   0x1030000U,
                                                   offsetof(MultiArrayLayout, data_offset),
                                                   0x0U,
                                                   0x1050000U,
                                                   offsetof(MultiArrayDimension, label),
                                                   0x1030000U,
                                                   offsetof(MultiArrayDimension, size),
                                                   0x1030000U,
                                                   offsetof(MultiArrayDimension, stride),
                                                   0x0U};
constexpr std::uint32_t kFloat64MultiArrayOps[] = {0x10d0000U,
                                                   offsetof(Float64MultiArray, layout),
                                                   0x30006U,
                                                   0x1070402U,
                                                   offsetof(Float64MultiArray, data),
                                                   0x0U,
                                                   0x1070a00U,
                                                   offsetof(MultiArrayLayout, dim),
                                                   sizeof(MultiArrayDimension),
                                                   0x40007U,
                                                   0x1030000U,
                                                   offsetof(MultiArrayLayout, data_offset),
                                                   0x0U,
                                                   0x1050000U,
                                                   offsetof(MultiArrayDimension, label),
                                                   0x1030000U,
                                                   offsetof(MultiArrayDimension, size),
                                                   0x1030000U,
                                                   offsetof(MultiArrayDimension, stride),
                                                   0x0U};
constexpr std::uint32_t kInt8MultiArrayOps[] = {0x10d0000U,
                                                offsetof(Int8MultiArray, layout),
                                                0x30006U,
                                                0x1070104U,
                                                offsetof(Int8MultiArray, data),
                                                0x0U,
                                                0x1070a00U,
                                                offsetof(MultiArrayLayout, dim),
                                                sizeof(MultiArrayDimension),
                                                0x40007U,
                                                0x1030000U,
                                                offsetof(MultiArrayLayout, data_offset),
                                                0x0U,
                                                0x1050000U,
                                                offsetof(MultiArrayDimension, label),
                                                0x1030000U,
                                                offsetof(MultiArrayDimension, size),
                                                0x1030000U,
                                                offsetof(MultiArrayDimension, stride),
                                                0x0U};
constexpr std::uint32_t kInt16MultiArrayOps[] = {0x10d0000U,
                                                 offsetof(Int16MultiArray, layout),
                                                 0x30006U,
                                                 0x1070204U,
                                                 offsetof(Int16MultiArray, data),
                                                 0x0U,
                                                 0x1070a00U,
                                                 offsetof(MultiArrayLayout, dim),
                                                 sizeof(MultiArrayDimension),
                                                 0x40007U,
                                                 0x1030000U,
                                                 offsetof(MultiArrayLayout, data_offset),
                                                 0x0U,
                                                 0x1050000U,
                                                 offsetof(MultiArrayDimension, label),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, size),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, stride),
                                                 0x0U};
constexpr std::uint32_t kInt32MultiArrayOps[] = {0x10d0000U,
                                                 offsetof(Int32MultiArray, layout),
                                                 0x30006U,
                                                 0x1070304U,
                                                 offsetof(Int32MultiArray, data),
                                                 0x0U,
                                                 0x1070a00U,
                                                 offsetof(MultiArrayLayout, dim),
                                                 sizeof(MultiArrayDimension),
                                                 0x40007U,
                                                 0x1030000U,
                                                 offsetof(MultiArrayLayout, data_offset),
                                                 0x0U,
                                                 0x1050000U,
                                                 offsetof(MultiArrayDimension, label),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, size),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, stride),
                                                 0x0U};
constexpr std::uint32_t kInt64MultiArrayOps[] = {0x10d0000U,
                                                 offsetof(Int64MultiArray, layout),
                                                 0x30006U,
                                                 0x1070404U,
                                                 offsetof(Int64MultiArray, data),
                                                 0x0U,
                                                 0x1070a00U,
                                                 offsetof(MultiArrayLayout, dim),
                                                 sizeof(MultiArrayDimension),
                                                 0x40007U,
                                                 0x1030000U,
                                                 offsetof(MultiArrayLayout, data_offset),
                                                 0x0U,
                                                 0x1050000U,
                                                 offsetof(MultiArrayDimension, label),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, size),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, stride),
                                                 0x0U};
constexpr std::uint32_t kUInt8MultiArrayOps[] = {0x10d0000U,
                                                 offsetof(UInt8MultiArray, layout),
                                                 0x30006U,
                                                 0x1070100U,
                                                 offsetof(UInt8MultiArray, data),
                                                 0x0U,
                                                 0x1070a00U,
                                                 offsetof(MultiArrayLayout, dim),
                                                 sizeof(MultiArrayDimension),
                                                 0x40007U,
                                                 0x1030000U,
                                                 offsetof(MultiArrayLayout, data_offset),
                                                 0x0U,
                                                 0x1050000U,
                                                 offsetof(MultiArrayDimension, label),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, size),
                                                 0x1030000U,
                                                 offsetof(MultiArrayDimension, stride),
                                                 0x0U};
constexpr std::uint32_t kUInt16MultiArrayOps[] = {0x10d0000U,
                                                  offsetof(UInt16MultiArray, layout),
                                                  0x30006U,
                                                  0x1070200U,
                                                  offsetof(UInt16MultiArray, data),
                                                  0x0U,
                                                  0x1070a00U,
                                                  offsetof(MultiArrayLayout, dim),
                                                  sizeof(MultiArrayDimension),
                                                  0x40007U,
                                                  0x1030000U,
                                                  offsetof(MultiArrayLayout, data_offset),
                                                  0x0U,
                                                  0x1050000U,
                                                  offsetof(MultiArrayDimension, label),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, size),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, stride),
                                                  0x0U};
constexpr std::uint32_t kUInt32MultiArrayOps[] = {0x10d0000U,
                                                  offsetof(UInt32MultiArray, layout),
                                                  0x30006U,
                                                  0x1070300U,
                                                  offsetof(UInt32MultiArray, data),
                                                  0x0U,
                                                  0x1070a00U,
                                                  offsetof(MultiArrayLayout, dim),
                                                  sizeof(MultiArrayDimension),
                                                  0x40007U,
                                                  0x1030000U,
                                                  offsetof(MultiArrayLayout, data_offset),
                                                  0x0U,
                                                  0x1050000U,
                                                  offsetof(MultiArrayDimension, label),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, size),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, stride),
                                                  0x0U};
constexpr std::uint32_t kUInt64MultiArrayOps[] = {0x10d0000U,
                                                  offsetof(UInt64MultiArray, layout),
                                                  0x30006U,
                                                  0x1070400U,
                                                  offsetof(UInt64MultiArray, data),
                                                  0x0U,
                                                  0x1070a00U,
                                                  offsetof(MultiArrayLayout, dim),
                                                  sizeof(MultiArrayDimension),
                                                  0x40007U,
                                                  0x1030000U,
                                                  offsetof(MultiArrayLayout, data_offset),
                                                  0x0U,
                                                  0x1050000U,
                                                  offsetof(MultiArrayDimension, label),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, size),
                                                  0x1030000U,
                                                  offsetof(MultiArrayDimension, stride),
                                                  0x0U};
constexpr std::uint32_t kJointStateOps[] = {0x10d0000U,
                                            offsetof(JointState, header),
                                            0x3000cU,
                                            0x1070500U,
                                            offsetof(JointState, name),
                                            0x1070402U,
                                            offsetof(JointState, position),
                                            0x1070402U,
                                            offsetof(JointState, velocity),
                                            0x1070402U,
                                            offsetof(JointState, effort),
                                            0x0U,
                                            0x10d0000U,
                                            offsetof(Header, stamp),
                                            0x30006U,
                                            0x1050000U,
                                            offsetof(Header, frame_id),
                                            0x0U,
                                            0x1030004U,
                                            offsetof(Time, sec),
                                            0x1030000U,
                                            offsetof(Time, nanosec),
                                            0x0U};
constexpr std::uint32_t kImuOps[] = {0x10d0000U,
                                     offsetof(Imu, header),
                                     0x30016U,
                                     0x10d0000U,
                                     offsetof(Imu, orientation),
                                     0x3001eU,
                                     0x1080402U,
                                     offsetof(Imu, orientation_covariance),
                                     9U,
                                     0x10d0000U,
                                     offsetof(Imu, angular_velocity),
                                     0x30021U,
                                     0x1080402U,
                                     offsetof(Imu, angular_velocity_covariance),
                                     9U,
                                     0x10d0000U,
                                     offsetof(Imu, linear_acceleration),
                                     0x3001bU,
                                     0x1080402U,
                                     offsetof(Imu, linear_acceleration_covariance),
                                     9U,
                                     0x0U,
                                     0x10d0000U,
                                     offsetof(Header, stamp),
                                     0x30006U,
                                     0x1050000U,
                                     offsetof(Header, frame_id),
                                     0x0U,
                                     0x1030004U,
                                     offsetof(Time, sec),
                                     0x1030000U,
                                     offsetof(Time, nanosec),
                                     0x0U,
                                     0x1040002U,
                                     offsetof(Quaternion, x),
                                     0x1040002U,
                                     offsetof(Quaternion, y),
                                     0x1040002U,
                                     offsetof(Quaternion, z),
                                     0x1040002U,
                                     offsetof(Quaternion, w),
                                     0x0U,
                                     0x1040002U,
                                     offsetof(Vector3, x),
                                     0x1040002U,
                                     offsetof(Vector3, y),
                                     0x1040002U,
                                     offsetof(Vector3, z),
                                     0x0U};
constexpr std::uint32_t kImageOps[] = {0x10d0000U,
                                       offsetof(Image, header),
                                       0x30010U,
                                       0x1030000U,
                                       offsetof(Image, height),
                                       0x1030000U,
                                       offsetof(Image, width),
                                       0x1050000U,
                                       offsetof(Image, encoding),
                                       0x1010000U,
                                       offsetof(Image, is_bigendian),
                                       0x1030000U,
                                       offsetof(Image, step),
                                       0x1070100U,
                                       offsetof(Image, data),
                                       0x0U,
                                       0x10d0000U,
                                       offsetof(Header, stamp),
                                       0x30006U,
                                       0x1050000U,
                                       offsetof(Header, frame_id),
                                       0x0U,
                                       0x1030004U,
                                       offsetof(Time, sec),
                                       0x1030000U,
                                       offsetof(Time, nanosec),
                                       0x0U};
constexpr std::uint32_t kClockOps[] = {
    0x10d0000U, offsetof(Clock, clock),  0x30004U, 0x0U, 0x1030004U, offsetof(Time, sec),
    0x1030000U, offsetof(Time, nanosec), 0x0U};

template <class Message>
constexpr dds::TopicType type_of(const char* name, std::uint32_t flags, std::uint32_t op_count,
                                 const std::uint32_t* ops) {
  return {.size = sizeof(Message),
          .align = alignof(Message),
          .flags = flags,
          .name = name,
          .op_count = op_count,
          .ops = ops};
}

}  // namespace

const dds::TopicType Bool::kType = type_of<Bool>("std_msgs::msg::dds_::Bool_", 16, 2, kBoolOps);
const dds::TopicType Float32::kType =
    type_of<Float32>("std_msgs::msg::dds_::Float32_", 16, 2, kFloat32Ops);
const dds::TopicType Float64::kType =
    type_of<Float64>("std_msgs::msg::dds_::Float64_", 16, 2, kFloat64Ops);
const dds::TopicType Int8::kType = type_of<Int8>("std_msgs::msg::dds_::Int8_", 16, 2, kInt8Ops);
const dds::TopicType Int16::kType = type_of<Int16>("std_msgs::msg::dds_::Int16_", 16, 2, kInt16Ops);
const dds::TopicType Int32::kType = type_of<Int32>("std_msgs::msg::dds_::Int32_", 16, 2, kInt32Ops);
const dds::TopicType Int64::kType = type_of<Int64>("std_msgs::msg::dds_::Int64_", 16, 2, kInt64Ops);
const dds::TopicType UInt8::kType = type_of<UInt8>("std_msgs::msg::dds_::UInt8_", 16, 2, kUInt8Ops);
const dds::TopicType UInt16::kType =
    type_of<UInt16>("std_msgs::msg::dds_::UInt16_", 16, 2, kUInt16Ops);
const dds::TopicType UInt32::kType =
    type_of<UInt32>("std_msgs::msg::dds_::UInt32_", 16, 2, kUInt32Ops);
const dds::TopicType UInt64::kType =
    type_of<UInt64>("std_msgs::msg::dds_::UInt64_", 16, 2, kUInt64Ops);
const dds::TopicType Float32MultiArray::kType = type_of<Float32MultiArray>(
    "std_msgs::msg::dds_::Float32MultiArray_", 0, 10, kFloat32MultiArrayOps);
const dds::TopicType Float64MultiArray::kType = type_of<Float64MultiArray>(
    "std_msgs::msg::dds_::Float64MultiArray_", 0, 10, kFloat64MultiArrayOps);
const dds::TopicType Int8MultiArray::kType =
    type_of<Int8MultiArray>("std_msgs::msg::dds_::Int8MultiArray_", 0, 10, kInt8MultiArrayOps);
const dds::TopicType Int16MultiArray::kType =
    type_of<Int16MultiArray>("std_msgs::msg::dds_::Int16MultiArray_", 0, 10, kInt16MultiArrayOps);
const dds::TopicType Int32MultiArray::kType =
    type_of<Int32MultiArray>("std_msgs::msg::dds_::Int32MultiArray_", 0, 10, kInt32MultiArrayOps);
const dds::TopicType Int64MultiArray::kType =
    type_of<Int64MultiArray>("std_msgs::msg::dds_::Int64MultiArray_", 0, 10, kInt64MultiArrayOps);
const dds::TopicType UInt8MultiArray::kType =
    type_of<UInt8MultiArray>("std_msgs::msg::dds_::UInt8MultiArray_", 0, 10, kUInt8MultiArrayOps);
const dds::TopicType UInt16MultiArray::kType = type_of<UInt16MultiArray>(
    "std_msgs::msg::dds_::UInt16MultiArray_", 0, 10, kUInt16MultiArrayOps);
const dds::TopicType UInt32MultiArray::kType = type_of<UInt32MultiArray>(
    "std_msgs::msg::dds_::UInt32MultiArray_", 0, 10, kUInt32MultiArrayOps);
const dds::TopicType UInt64MultiArray::kType = type_of<UInt64MultiArray>(
    "std_msgs::msg::dds_::UInt64MultiArray_", 0, 10, kUInt64MultiArrayOps);
const dds::TopicType JointState::kType =
    type_of<JointState>("sensor_msgs::msg::dds_::JointState_", 0, 12, kJointStateOps);
const dds::TopicType Imu::kType = type_of<Imu>("sensor_msgs::msg::dds_::Imu_", 0, 23, kImuOps);
const dds::TopicType Image::kType =
    type_of<Image>("sensor_msgs::msg::dds_::Image_", 0, 14, kImageOps);
const dds::TopicType Clock::kType =
    type_of<Clock>("rosgraph_msgs::msg::dds_::Clock_", 16, 5, kClockOps);

}  // namespace eagerx::ros
