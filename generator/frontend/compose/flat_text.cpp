#include "generator/frontend/compose/flat_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kWidth = 90;

class Writer {
 public:
  Writer(const SourceMap& sources, FileId file) : sources_(sources), file_(file) {}

  void entries(const YamlValue& map, std::size_t indent) {
    for (const auto& entry : map.entries) {
      const std::string key = fmt::format("{:{}}{}:", "", indent, yaml_scalar(entry.key));
      const YamlValue& value = entry.value;
      const std::string one_line = in_one_line(value);
      const bool short_enough = key.size() + one_line.size() < kWidth || value.is_scalar();
      const bool is_block = indent == 0 || !short_enough;
      if (is_block && value.is_map() && !value.entries.empty()) {
        line(key, entry.key_span);
        entries(value, indent + 2);
      } else if (is_block && value.is_sequence() && !value.items.empty() &&
                 !value.items.front().is_scalar()) {
        line(key, entry.key_span);
        for (const auto& item : value.items)
          line(fmt::format("{:{}}- {}", "", indent + 2, in_one_line(item)), place_of(item));
      } else {
        line(fmt::format("{}{}{}", key, one_line.empty() ? "" : " ", one_line), entry.key_span);
      }
    }
  }

  std::string take() { return std::move(text_); }

 private:
  static std::string in_one_line(const YamlValue& yaml) {
    if (yaml.is_null()) return {};
    if (yaml.is_scalar()) return yaml.quoted ? yaml_string(yaml.text) : yaml_scalar(yaml.text);
    std::string text;
    for (const auto& item : yaml.items)
      text += (text.empty() ? "" : ", ") + (item.is_null() ? "~" : in_one_line(item));
    if (yaml.is_sequence()) return "[" + text + "]";
    for (const auto& entry : yaml.entries)
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", yaml_scalar(entry.key),
                          entry.value.is_null() ? "~" : in_one_line(entry.value));
    return "{" + text + "}";
  }

  /// A connection is from where its first end is written.
  static Span place_of(const YamlValue& item) {
    return item.is_map() && !item.entries.empty() ? item.entries.front().key_span : item.span;
  }

  void line(std::string text, const Span& span) {
    const bool elsewhere = span.file != FileId::none && span.file != file_ && span.line > 0;
    if (elsewhere) {
      const std::string& name = sources_.name(span.file);
      text += fmt::format("{:{}}  # {}:{}", "", kColumn - std::min(text.size(), kColumn), name,
                          span.line);
    }
    text_ += text + "\n";
  }

  static constexpr std::size_t kColumn = 60;
  const SourceMap& sources_;
  FileId file_;
  std::string text_;
};

}  // namespace

std::string flat_text(const YamlValue& root, const SourceMap& sources) {
  Writer writer(sources, root.span.file);
  writer.entries(root, 0);
  return writer.take();
}

}  // namespace eagerx::gen
