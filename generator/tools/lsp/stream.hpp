// Messages over two pipes: LSP's base protocol.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen::lsp {

/// LSP 3.17, "Base Protocol": a header with `Content-Length`, an empty line, the content.
class MessageReader {
 public:
  static constexpr std::size_t kMostHeader = 4096, kMostContent = 64U << 20U;  // bytes

  /// Takes bytes as they come.
  void add(std::string_view bytes);
  /// The content of the next message, if it is complete.
  std::optional<std::string> next();
  /// The stream is none of this protocol, or a message is larger than any may be: it ends here.
  [[nodiscard]] bool is_broken() const { return broken_; }

 private:
  bool read_header();

  std::string buffer_;
  std::optional<std::size_t> length_;  // of the content that is awaited
  bool broken_ = false;
};

std::string message_of(std::string_view content);

}  // namespace eagerx::gen::lsp
