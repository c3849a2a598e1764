// Small weight files, built in memory: safetensors and stored zip archives.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace eagerx::gen::test {

struct NamedValues {
  std::string name;
  std::vector<int> shape;
  std::vector<float> values;
};

inline std::string little(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

inline std::string bytes_of(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

/// `notes` is the inside of the metadata object.
inline std::string safetensors(const std::vector<NamedValues>& tensors,
                               const std::string& notes = {}) {
  std::string header = "{\"__metadata__\":{" + notes + "}";
  std::string data;
  for (const NamedValues& tensor : tensors) {
    const std::string bytes = bytes_of(tensor.values);
    header +=
        fmt::format(R"(,"{}":{{"dtype":"F32","shape":[{}],"data_offsets":[{},{}]}})", tensor.name,
                    fmt::join(tensor.shape, ","), data.size(), data.size() + bytes.size());
    data += bytes;
  }
  header += "}";
  return little(header.size(), 8) + header + data;
}

struct ZipEntry {
  std::string name, content;
};

inline std::string zip(const std::vector<ZipEntry>& entries) {
  std::string bytes;
  std::string directory;
  for (const ZipEntry& entry : entries) {
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(entry.content.data()),
                           static_cast<uInt>(entry.content.size()));
    const std::string common = little(0, 2) + little(0, 2) + little(0, 4) + little(crc, 4) +
                               little(entry.content.size(), 4) + little(entry.content.size(), 4) +
                               little(entry.name.size(), 2) + little(0, 2);
    directory += "PK\x01\x02" + little(20, 2) + little(20, 2) + common + little(0, 2) +
                 little(0, 2) + little(0, 2) + little(0, 4) + little(bytes.size(), 4) + entry.name;
    bytes += "PK\x03\x04" + little(20, 2) + common + entry.name + entry.content;
  }
  const std::size_t start = bytes.size();
  return bytes + directory + "PK\x05\x06" + little(0, 4) + little(entries.size(), 2) +
         little(entries.size(), 2) + little(directory.size(), 4) + little(start, 4) + little(0, 2);
}

/// One Linear: `name`.weight of ones and `name`.bias of zeros.
inline void add_linear(std::vector<NamedValues>& tensors, const std::string& name, int inputs,
                       int outputs) {
  tensors.push_back({name + ".weight",
                     {outputs, inputs},
                     std::vector<float>(static_cast<std::size_t>(inputs * outputs), 1.0F)});
  tensors.push_back(
      {name + ".bias", {outputs}, std::vector<float>(static_cast<std::size_t>(outputs), 0.0F)});
}

}  // namespace eagerx::gen::test
