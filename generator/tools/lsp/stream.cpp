#include "generator/tools/lsp/stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace eagerx::gen::lsp {
namespace {

constexpr std::string_view kEndOfHeader = "\r\n\r\n";

bool is_length(std::string_view name) {
  constexpr std::string_view kName = "content-length";
  return std::ranges::equal(name, kName,
                            [](unsigned char a, char b) { return std::tolower(a) == b; });
}

}  // namespace

void MessageReader::add(std::string_view bytes) {
  if (!broken_) buffer_ += bytes;
}

bool MessageReader::read_header() {
  const std::size_t end = buffer_.find(kEndOfHeader);
  if (end == std::string::npos) {
    broken_ = buffer_.size() > kMostHeader;
    return false;
  }
  std::string_view header = std::string_view(buffer_).substr(0, end);
  while (!header.empty()) {
    const std::string_view line = header.substr(0, header.find("\r\n"));
    header.remove_prefix(std::min(header.size(), line.size() + 2));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_length(line.substr(0, colon))) continue;
    std::string_view number = line.substr(colon + 1);
    number.remove_prefix(std::min(number.find_first_not_of(' '), number.size()));
    std::size_t length = 0;
    const auto [rest, error] =
        std::from_chars(number.data(), number.data() + number.size(), length);
    if (error == std::errc() && rest == number.data() + number.size()) length_ = length;
  }
  broken_ = !length_ || *length_ > kMostContent;
  buffer_.erase(0, end + kEndOfHeader.size());
  return !broken_;
}

std::optional<std::string> MessageReader::next() {
  if (broken_ || (!length_ && !read_header())) return std::nullopt;
  if (buffer_.size() < *length_) return std::nullopt;
  std::string content = buffer_.substr(0, *length_);
  buffer_.erase(0, *length_);
  length_.reset();
  return content;
}

std::string message_of(std::string_view content) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", content.size(), content);
}

}  // namespace eagerx::gen::lsp
