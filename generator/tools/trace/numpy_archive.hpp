// A file of arrays that numpy.load() opens: .npz.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// A zip file of stored entries (PKWARE's APPNOTE 6.3), each in NumPy's format 1.0
/// (numpy.lib.format), like those of numpy.savez. The same bytes on every machine.
class NumpyArchive {
 public:
  /// `type`: that of numpy.dtype, such as "<f8". `shape`: its text between parentheses, "3, 2" or
  /// "3,". `data`: the elements, row after row, little-endian.
  void add(const std::string& name, std::string_view type, std::string_view shape,
           const std::string& data);
  std::string finish() &&;

 private:
  void add_entry(const std::string& name, const std::string& bytes);

  std::string file_, directory_;
  std::uint16_t entries_ = 0;
};

}  // namespace eagerx::gen
