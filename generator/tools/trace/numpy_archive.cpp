#include "generator/tools/trace/numpy_archive.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/tools/trace/bytes.hpp"

namespace eagerx::gen {

void NumpyArchive::add(const std::string& name, std::string_view type, std::string_view shape,
                       const std::string& data) {
  constexpr std::size_t kAlignment = 64, kBefore = 10;
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  while ((kBefore + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  append(file, static_cast<std::uint16_t>(header.size()));
  add_entry(name + ".npy", file + header + data);
}

void NumpyArchive::add_entry(const std::string& name, const std::string& bytes) {
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

std::string NumpyArchive::finish() && {
  std::string end = "PK\x05\x06";
  append(end, std::uint32_t{0});  // disks
  append(end, entries_);
  append(end, entries_);
  append(end, static_cast<std::uint32_t>(directory_.size()));
  append(end, static_cast<std::uint32_t>(file_.size()));
  append(end, std::uint16_t{0});
  return std::move(file_) + directory_ + end;
}

}  // namespace eagerx::gen
