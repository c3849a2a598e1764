#include <eagerx/link/telemetry.hpp>
#include <runtime/host/telemetry/layout.hpp>
#include <runtime/host/trace/channel_name.hpp>

namespace eagerx::telemetry {
namespace {

constexpr std::size_t kMostGroups = link::kNoGroup;

std::string problem_with(const Channel& channel, std::size_t record_bytes) {
  std::string name = trace_log::problem_with_channel_name(channel.name);
  if (!name.empty()) return name;
  std::uint64_t size = 1;
  for (const std::uint64_t length : channel.shape) {
    if (length == 0 || length > link::kMostRecordBytes) return "a shape is none";
    size *= length;
    if (size > link::kMostRecordBytes) return "a message is longer than a record";
  }
  if (size != channel.size) return "a shape is not that of its elements";
  if (channel.offset < link::kRecordHeaderBytes || channel.offset > record_bytes ||
      size * bytes_of(channel.dtype) > record_bytes - channel.offset)
    return "`" + channel.name + "` is not within its record";
  return {};
}

}  // namespace

std::size_t bytes_of(trace_log::Dtype dtype) {
  using trace_log::Dtype;
  switch (dtype) {
    case Dtype::float64:
    case Dtype::int64:
    case Dtype::uint64:
      return 8;
    case Dtype::float32:
    case Dtype::int32:
    case Dtype::uint32:
      return 4;
    case Dtype::int16:
    case Dtype::uint16:
      return 2;
    case Dtype::int8:
    case Dtype::uint8:
    case Dtype::boolean:
      break;
  }
  return 1;
}

std::string problem_with(const Layout& layout) {
  if (layout.groups.empty() || layout.groups.size() > kMostGroups)
    return "there are no groups, or too many";
  for (const Group& group : layout.groups) {
    if (group.bytes < link::kRecordHeaderBytes || group.bytes > link::kMostRecordBytes)
      return "a record is too short or too long";
    if (group.channels.empty() || group.channels.size() > link::kMostRecordChannels)
      return "a record has no channels, or too many";
    if (group.rate_num == 0 || group.rate_den == 0 || group.every == 0) return "a rate is none";
    for (const Channel& channel : group.channels) {
      std::string problem = problem_with(channel, group.bytes);
      if (!problem.empty()) return problem;
    }
  }
  return {};
}

}  // namespace eagerx::telemetry
