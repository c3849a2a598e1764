#include <fmt/format.h>

#include "generator/tools/trace/bytes.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/numpy_archive.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

struct Type {
  const char* name;
  std::size_t bytes;
};
Type type_of(trace_log::Dtype dtype) {
  using trace_log::Dtype;
  switch (dtype) {
    case Dtype::float32:
      return {"<f4", 4};
    case Dtype::float64:
      return {"<f8", 8};
    case Dtype::int8:
      return {"|i1", 1};
    case Dtype::int16:
      return {"<i2", 2};
    case Dtype::int32:
      return {"<i4", 4};
    case Dtype::int64:
      return {"<i8", 8};
    case Dtype::uint8:
      return {"|u1", 1};
    case Dtype::uint16:
      return {"<u2", 2};
    case Dtype::uint32:
      return {"<u4", 4};
    case Dtype::uint64:
      return {"<u8", 8};
    case Dtype::boolean:
      break;
  }
  return {"|b1", 1};
}

/// The four arrays of a channel.
struct Arrays {
  std::string values, episode, tick, time_s;
  std::size_t messages = 0;
};

}  // namespace

std::string trace_npz(const Log& log) {
  const Timeline timeline = timeline_of(log);
  std::vector<Arrays> arrays(log.channels.size());
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    const auto& row = log.rows[i];
    const auto& channel = log.channels[row.channel];
    Arrays& to = arrays[row.channel];
    ++to.messages;
    for (std::uint64_t k = 0; k < channel.size; ++k) {
      std::string bits;
      append(bits, log.values_of(row)[k]);
      to.values += bits.substr(0, type_of(channel.dtype).bytes);
    }
    append(to.episode, row.episode);
    append(to.tick, row.seq);
    append(to.time_s,
           std::bit_cast<std::uint64_t>(static_cast<double>(timeline.in_episode_ns[i]) / 1e9));
  }
  NumpyArchive archive;
  for (std::size_t c = 0; c < arrays.size(); ++c) {
    const auto& channel = log.channels[c];
    const Arrays& from = arrays[c];
    const std::string shape = channel.size == 1
                                  ? fmt::format("{},", from.messages)
                                  : fmt::format("{}, {}", from.messages, channel.size);
    const std::string rows = fmt::format("{},", from.messages);
    archive.add(channel.name, type_of(channel.dtype).name, shape, from.values);
    archive.add(channel.name + ".episode", "<u4", rows, from.episode);
    archive.add(channel.name + ".tick", "<u8", rows, from.tick);
    archive.add(channel.name + ".time_s", "<f8", rows, from.time_s);
  }
  return std::move(archive).finish();
}

}  // namespace eagerx::gen
