#include "generator/frontend/read/locator.hpp"

#include <algorithm>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kBlank = " \t";
constexpr std::string_view kWordEnd = " \t\n,[]{}";

constexpr std::size_t kStride = 64;  // every place of a file is counted from one of these

/// Every byte of UTF-8 but a continuation byte begins a code point.
bool begins_code_point(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

Locator::Locator(FileId file, std::string_view text) : file_(file), text_(text), line_starts_{0} {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % kStride == 0) counts_.push_back(count);
    if (begins_code_point(text[i])) ++count;
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
  if (text.size() % kStride == 0) counts_.push_back(count);
}

std::size_t Locator::code_points_before(std::size_t offset) const {
  const std::size_t block = offset / kStride;
  const std::string_view rest = text_.substr(block * kStride, offset % kStride);
  const auto more = std::ranges::count_if(rest, begins_code_point);
  return counts_[block] + static_cast<std::size_t>(more);
}

Span Locator::span(Extent extent) const {
  const std::size_t begin = std::min(extent.begin, text_.size());
  const std::size_t end = std::clamp(extent.end, begin, line_end(begin));
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), begin);
  const std::size_t before = code_points_before(begin);
  const std::size_t column = before - code_points_before(*std::prev(after)) + 1;
  const std::size_t length = std::max<std::size_t>(code_points_before(end) - before, 1);
  return {file_, static_cast<std::uint32_t>(after - line_starts_.begin()),
          static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(length)};
}

std::size_t Locator::line_begin(std::size_t offset) const {
  return *std::prev(std::upper_bound(line_starts_.begin(), line_starts_.end(), offset));
}

std::size_t Locator::line_end(std::size_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return next == line_starts_.end() ? text_.size() : *next - 1;
}

std::size_t Locator::skip_blank(std::size_t offset) const {
  while (offset < text_.size()) {
    const bool comment_may_start =
        offset == 0 || is_blank(text_[offset - 1]) || text_[offset - 1] == '\n';
    if (is_blank(text_[offset]) || text_[offset] == '\n') {
      ++offset;
    } else if (text_[offset] == '#' && comment_may_start) {
      offset = line_end(offset);
    } else {
      break;
    }
  }
  return offset;
}

Extent Locator::word(std::size_t begin) const {
  return {begin, std::min(text_.find_first_of(kWordEnd, begin), text_.size())};
}

std::size_t Locator::tag_end(std::size_t begin) const {
  if (at(begin + 1) != '<') return word(begin).end;
  const std::size_t close = text_.find('>', begin);
  return close == std::string_view::npos ? word(begin).end : close + 1;
}

Properties Locator::properties(std::size_t offset) const {
  Properties result;
  result.all = {offset, offset};
  while (at(offset) == '!' || at(offset) == '&') {
    const bool is_tag = at(offset) == '!';
    const std::size_t end = is_tag ? tag_end(offset) : word(offset).end;
    if (is_tag) result.tag = {offset, end};
    result.all.end = end;
    offset = skip_blank(end);
  }
  result.content = offset;
  return result;
}

std::size_t Locator::quoted_end(std::size_t begin) const {
  const char quote = text_[begin];
  for (std::size_t i = begin + 1; i < text_.size(); ++i) {
    if (quote == '"' && text_[i] == '\\') {
      ++i;
    } else if (text_[i] == quote) {
      if (quote == '"' || at(i + 1) != '\'') return i + 1;
      ++i;  // '' stands for one quote
    }
  }
  return std::string_view::npos;
}

Extent Locator::scalar(const Properties& properties, std::string_view value) const {
  const std::size_t begin = properties.content;
  const bool has_properties = properties.all.end > properties.all.begin;
  // Nothing written: what follows the tag is the next key or item, on another line or behind a
  // comma.
  if (has_properties && value.empty() && !text_at_same_line(properties)) return properties.all;
  const char first = at(begin);
  if (first == '\'' || first == '"') return {begin, std::min(quoted_end(begin), text_.size())};
  if (first == '|' || first == '>') return {begin, word(begin).end};
  if (text_.substr(std::min(begin, text_.size())).starts_with(value)) {
    return {begin, begin + value.size()};
  }
  // A plain scalar over several lines: what is on the first one, without a comment.
  const std::string_view line = text_.substr(begin, line_end(begin) - begin);
  std::size_t size = std::min(line.find(" #"), line.size());
  while (size > 0 && is_blank(line[size - 1])) --size;
  return {begin, begin + size};
}

bool Locator::text_at_same_line(const Properties& properties) const {
  constexpr std::string_view kNotPlain = "'\"|>";
  return kNotPlain.find(at(properties.content)) != std::string_view::npos &&
         line_begin(properties.content) == line_begin(properties.all.begin);
}

std::size_t Locator::dash_before(std::size_t offset) const {
  std::size_t end = std::min(offset, text_.size());
  while (end > 0) {
    const std::size_t begin = line_begin(end - 1);
    std::string_view line = text_.substr(begin, end - begin);
    if (line.starts_with('#')) line = {};
    line = line.substr(0, std::min(line.find(" #"), line.size()));
    const std::size_t last = line.find_last_not_of(" \t\n");
    if (last != std::string_view::npos) {
      return line[last] == '-' ? begin + last : std::string_view::npos;
    }
    end = begin;
  }
  return std::string_view::npos;
}

Extent Locator::null_at(std::size_t offset) const {
  const std::size_t end = std::min(text_.find_first_of(" \t\n,[]{}:", offset), text_.size());
  const bool is_null = end > offset && is_null_text(text_.substr(offset, end - offset));
  return {offset, is_null ? end : offset};
}

bool Locator::colon_follows(std::size_t offset) const {
  const std::size_t next = text_.find_first_not_of(kBlank, offset);
  return next < text_.size() && text_[next] == ':';
}

}  // namespace eagerx::gen
