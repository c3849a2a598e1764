// Zip archives, such as files of Stable-Baselines3, torch.save and npz. Unpacks only the requested
// members, and never writes files.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

class Archive {
 public:
  /// Reads the directory of the archive. E0621 if it is damaged.
  static std::optional<Archive> open(std::string_view bytes, PolicyProblem& problem);

  [[nodiscard]] bool has(std::string_view name) const { return entries_.count(name) > 0; }
  /// Names in order.
  [[nodiscard]] std::vector<std::string> names() const;
  /// The entry's bytes. Stored ones are a view into the archive, compressed ones are unpacked into
  /// `buffer`. E0621 if it is missing, damaged, or too large.
  std::optional<std::string_view> read(std::string_view name, std::string& buffer,
                                       PolicyProblem& problem) const;

 private:
  struct Entry {
    std::uint32_t method = 0;  // 0 stored, 8 deflated
    std::uint32_t flags = 0;
    std::uint32_t crc = 0;
    std::size_t packed = 0, size = 0;
    std::size_t header = 0;  // position of the local header
  };
  std::string_view bytes_;
  std::map<std::string, Entry, std::less<>> entries_;
};

/// Adds `more` unpacked bytes to `sum`. E0621, with `help`, if the sum exceeds the limit: many
/// names may refer to the same entry.
bool count_unpacked(std::size_t more, std::size_t& sum, const char* help, PolicyProblem& problem);

}  // namespace eagerx::gen
