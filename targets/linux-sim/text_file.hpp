// Text output that allocates once, when it is opened, and knows no locale.
#pragma once

#include <charconv>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace eagerx::linux_sim {

/// A file written through a fixed buffer. The first failed write is remembered and everything after
/// it is dropped, so that a full disk ends a run with one message.
class TextFile {
 public:
  TextFile() = default;
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  ~TextFile();

  /// Creates `path`, or takes the standard output for "-". False if that is not possible; see
  /// error().
  bool open(const std::string& path);
  bool is_open() const { return descriptor_ >= 0; }
  /// Writes what is left. False if anything was lost; see error().
  bool close();
  bool failed() const { return error_ != 0; }
  /// errno of the first failure, 0 without one.
  int error() const { return error_; }

  void text(std::string_view text);

  /// A number so that it reads back to the same bits: the shortest decimal; "nan" for every NaN.
  template <class T>
  void number(T value) {
    if (kBufferBytes - used_ < kLongestNumber) flush();
    if constexpr (std::is_same_v<T, bool>) {
      text(value ? "1" : "0");
    } else {
      if (value != value) return text("nan");
      char* const begin = buffer_.get() + used_;
      const std::to_chars_result result = std::to_chars(begin, begin + kLongestNumber, value);
      used_ += static_cast<std::size_t>(result.ptr - begin);
    }
  }

 private:
  static constexpr std::size_t kBufferBytes = std::size_t{1} << 16U;
  static constexpr std::size_t kLongestNumber = 32;  // -2.2250738585072014e-308 has 24

  void flush();

  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
  int descriptor_ = -1;
  int error_ = 0;
};

}  // namespace eagerx::linux_sim
