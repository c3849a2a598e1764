// Writes the rows of a program's table: a TextFile without its headers.
#pragma once

#include <cstdint>
#include <string_view>

namespace eagerx::host {
class TextFile;
}

namespace eagerx::linux_sim {

class TableWriter {
 public:
  explicit TableWriter(host::TextFile& file) : file_(file) {}
  void text(std::string_view text);
  void number(bool value);
  void number(std::int8_t value);
  void number(std::int16_t value);
  void number(std::int32_t value);
  void number(std::int64_t value);
  void number(std::uint8_t value);
  void number(std::uint16_t value);
  void number(std::uint32_t value);
  void number(std::uint64_t value);
  void number(float value);
  void number(double value);

 private:
  host::TextFile& file_;
};

}  // namespace eagerx::linux_sim
