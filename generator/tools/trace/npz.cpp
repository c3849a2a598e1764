#include <fmt/format.h>

#include "generator/tools/trace/bytes.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

/// A zip file of stored entries (PKWARE's APPNOTE 6.3): numpy.savez writes the same.
class Zip {
 public:
  void add(const std::string& name, const std::string& bytes) {
    const std::uint32_t crc = crc32_of(bytes);
    std::string entry;
    append(entry, std::uint16_t{20});      // version that reads it: 2.0
    append(entry, std::uint16_t{0x0800});  // names are UTF-8
    append(entry, std::uint16_t{0});       // stored
    append(entry, std::uint16_t{0});       // 00:00
    append(entry, std::uint16_t{0x0021});  // 1980-01-01
    append(entry, crc);
    append(entry, static_cast<std::uint32_t>(bytes.size()));
    append(entry, static_cast<std::uint32_t>(bytes.size()));
    append(entry, static_cast<std::uint16_t>(name.size()));
    append(entry, std::uint16_t{0});  // nothing extra
    const std::size_t offset = file_.size();
    file_ += "PK\x03\x04" + entry + name + bytes;
    directory_ += "PK\x01\x02";
    append(directory_, std::uint16_t{20});
    directory_ += entry;
    append(directory_, std::uint16_t{0});  // no comment
    append(directory_, std::uint16_t{0});  // the first disk
    append(directory_, std::uint16_t{0});
    append(directory_, std::uint32_t{0});
    append(directory_, static_cast<std::uint32_t>(offset));
    directory_ += name;
    ++entries_;
  }

  std::string finish() && {
    std::string end = "PK\x05\x06";
    append(end, std::uint32_t{0});  // disks
    append(end, entries_);
    append(end, entries_);
    append(end, static_cast<std::uint32_t>(directory_.size()));
    append(end, static_cast<std::uint32_t>(file_.size()));
    append(end, std::uint16_t{0});
    return std::move(file_) + directory_ + end;
  }

 private:
  std::string file_, directory_;
  std::uint16_t entries_ = 0;
};

/// NumPy's format 1.0 (numpy.lib.format).
std::string npy(std::string_view type, const std::string& shape, const std::string& data) {
  constexpr std::size_t kAlignment = 64, kBefore = 10;
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  while ((kBefore + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  append(file, static_cast<std::uint16_t>(header.size()));
  return file + header + data;
}

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
  Zip zip;
  for (std::size_t c = 0; c < arrays.size(); ++c) {
    const auto& channel = log.channels[c];
    const Arrays& from = arrays[c];
    const std::string shape = channel.size == 1
                                  ? fmt::format("{},", from.messages)
                                  : fmt::format("{}, {}", from.messages, channel.size);
    const std::string rows = fmt::format("{},", from.messages);
    zip.add(channel.name + ".npy", npy(type_of(channel.dtype).name, shape, from.values));
    zip.add(channel.name + ".episode.npy", npy("<u4", rows, from.episode));
    zip.add(channel.name + ".tick.npy", npy("<u8", rows, from.tick));
    zip.add(channel.name + ".time_s.npy", npy("<f8", rows, from.time_s));
  }
  return std::move(zip).finish();
}

}  // namespace eagerx::gen
