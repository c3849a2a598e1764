#include "generator/frontend/outline/fixes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/frontend/outline/insert.hpp"
#include "generator/frontend/outline/lines.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

using EditKind = FixEdit::Kind;

/// Without holes: what is to be written there is left open.
std::string opened(std::string text) {
  constexpr std::string_view kHole = "…";
  for (std::size_t at = text.find(kHole); at != std::string::npos; at = text.find(kHole, at))
    text.erase(at, kHole.size());
  return text;
}

const OutlineEntry* entry_of(const OutlineNode& map, std::string_view key) {
  const auto found = ranges::find(map.entries, key, &OutlineEntry::key);
  return found != map.entries.end() ? &*found : nullptr;
}

/// One fix on its way into a text.
class Layout {
 public:
  Layout(const Diagnostic& diagnostic, std::string_view text)
      : own_(diagnostic.span), text_(text), top_(outline_of(text)) {}

  std::optional<Edit> of(const Fix& fix) {
    title_ = fix.title;
    std::vector<Splice> splices;
    for (const FixEdit& edit : fix.edits) {
      auto splice = of(edit);
      if (!splice) return std::nullopt;
      splices.push_back(std::move(*splice));
    }
    return splices.empty() ? std::nullopt
                           : std::optional(Edit{std::move(title_), std::move(splices)});
  }

 private:
  std::optional<Splice> of(const FixEdit& edit) {
    const Span& span = edit.span.file == FileId::none ? own_ : edit.span;
    if (span.line == 0 || span.file != own_.file) return std::nullopt;
    place_ = bytes_of(text_, span);
    const bool covers = span.length > 0;
    switch (edit.kind) {
      case EditKind::replace:
        return covers ? std::optional(Splice{place_, edit.text}) : std::nullopt;
      case EditKind::number:
        return covers && is_number() ? std::optional(Splice{place_, edit.text}) : std::nullopt;
      case EditKind::value:
        return covers ? in_place_of_list(edit.text) : std::nullopt;
      case EditKind::remove:
        return covers ? std::optional(without_blanks()) : std::nullopt;
      case EditKind::top_value:
        return top_value(edit);
      case EditKind::missing:
        return missing(edit.name);
      case EditKind::connection:
        return on_connection(edit);
      case EditKind::parameter:
        return parameter(edit.name);
      case EditKind::top_item:
        return top_item(edit);
      case EditKind::port:
        return port(edit);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_number() const {
    return text_.substr(place_.begin, place_.end - place_.begin)
               .find_first_not_of("0123456789.eE+-") == std::string_view::npos;
  }

  [[nodiscard]] Splice without_blanks() const {
    Bytes place = place_;
    while (place.end < text_.size() && text_[place.end] == ' ') ++place.end;
    return {place, ""};
  }

  /// A list in brackets that begins here; of one of lines the whole is more than a place.
  [[nodiscard]] std::optional<Splice> in_place_of_list(const std::string& value) const {
    if (text_.substr(place_.begin, 1) != "[") return std::nullopt;
    for (const OutlineEntry* const each : entries_around(top_, place_.begin)) {
      if (each->value.kind != OutlineNode::Kind::list || !each->value.flow) continue;
      if (each->key.empty() || text_.find('[', each->key_place.end) != place_.begin) continue;
      return Splice{{place_.begin, end_of(text_, *each)}, value};
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Splice> top_value(const FixEdit& edit) const {
    const OutlineNode* const value = top_.find(edit.name);
    if (value == nullptr || value->kind != OutlineNode::Kind::scalar) return std::nullopt;
    return Splice{value->place, edit.text};
  }

  /// The map that begins here, or the graph. A rate is probably the graph's.
  std::optional<Splice> missing(const std::string& key) {
    const OutlineNode* const rate = top_.find("rate");
    const std::string value = key == "rate" && rate != nullptr ? rate->text : "";
    if (!value.empty()) title_ = fmt::format("Add `{}: {}`", key, value);
    if (const OutlineEntry* const owner = map_here()) return with_key(text_, *owner, key, value);
    const bool is_top = top_.kind == OutlineNode::Kind::map && !top_.entries.empty() &&
                        top_.entries.front().key_place.begin == place_.begin;
    if (!is_top) return std::nullopt;
    return with_section(text_, key, value);
  }

  [[nodiscard]] std::optional<Splice> on_connection(const FixEdit& edit) const {
    const OutlineEntry* connection = nullptr;
    for (const OutlineEntry* const each : entries_around(top_, place_.begin)) {
      if (each->key.empty() && each->value.kind == OutlineNode::Kind::map) connection = each;
    }
    if (connection == nullptr || connection->value.find(edit.name) != nullptr) return std::nullopt;
    return with_key(text_, *connection, edit.name, edit.text);
  }

  [[nodiscard]] std::optional<Splice> parameter(const std::string& name) const {
    const OutlineEntry* entity = nullptr;
    for (const OutlineEntry* const each : entries_around(top_, place_.begin)) {
      if (each->value.find("type") != nullptr) entity = each;
    }
    if (entity == nullptr) return std::nullopt;
    const OutlineEntry* const config = entry_of(entity->value, "config");
    return config != nullptr ? with_key(text_, *config, name, "")
                             : with_key(text_, *entity, "config", fmt::format("{{{}: }}", name));
  }

  [[nodiscard]] std::optional<Splice> top_item(const FixEdit& edit) const {
    const OutlineEntry* const list = entry_of(top_, edit.name);
    const std::string item = opened(edit.text);
    if (list != nullptr) return with_item(text_, *list, item);
    return with_section(text_, edit.name,
                        item.starts_with('{') ? "\n  - " + item : fmt::format("[{}]", item));
  }

  [[nodiscard]] std::optional<Splice> port(const FixEdit& edit) const {
    const std::string owner = edit.owner.substr(0, edit.owner.find('['));
    for (const char* const section : {"objects", "nodes"}) {
      const OutlineNode* const all = top_.find(section);
      const OutlineEntry* const entity = all != nullptr ? entry_of(*all, owner) : nullptr;
      const OutlineEntry* const list =
          entity != nullptr ? entry_of(entity->value, edit.name) : nullptr;
      if (list == nullptr) continue;
      return list->value.kind == OutlineNode::Kind::map ? with_key(text_, *list, edit.text, "")
                                                        : with_item(text_, *list, edit.text);
    }
    return std::nullopt;
  }

  /// The map whose first token stands here; nullptr for the whole file.
  [[nodiscard]] const OutlineEntry* map_here() const {
    const std::size_t at = place_.begin;
    for (const OutlineEntry* const each : entries_around(top_, at)) {
      if (each->value.kind != OutlineNode::Kind::map) continue;
      const OutlineNode& map = each->value;
      const std::size_t key_end = each->key.empty() ? each->whole.begin : each->key_place.end;
      const std::size_t begin = map.flow              ? text_.find('{', key_end)
                                : map.entries.empty() ? at + 1
                                                      : map.entries.front().key_place.begin;
      if (begin == at) return each;
    }
    return nullptr;
  }

  const Span own_;
  std::string_view text_;
  const OutlineNode top_;
  std::string title_;
  Bytes place_;
};

/// The place of some bytes of one line.
Span span_of(std::string_view text, FileId file, Bytes bytes) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::size_t line = bytes.begin == 0 ? std::string_view::npos : text.rfind('\n', bytes.begin - 1);
  line = line == std::string_view::npos ? 0 : line + 1;
  if (line == 0 && text.starts_with(kByteOrderMark)) line = kByteOrderMark.size();
  const auto count = [&](std::size_t begin, std::size_t end) {
    return static_cast<std::uint32_t>(count_code_points(text.substr(begin, end - begin)));
  };
  const auto lines =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bytes.begin), '\n');
  return {file, static_cast<std::uint32_t>(lines) + 1, count(line, bytes.begin) + 1,
          count(bytes.begin, bytes.end)};
}

}  // namespace

std::vector<TextFix> fixes_of(const Diagnostic& diagnostic, std::string_view text) {
  if (diagnostic.help.fixes.empty()) return {};
  Layout layout(diagnostic, text);
  std::vector<TextFix> result;
  for (const Fix& fix : diagnostic.help.fixes) {
    if (auto edit = layout.of(fix)) result.push_back({std::move(*edit), fix.certain});
  }
  return result;
}

std::optional<Edit> fix_of(const Diagnostic& diagnostic, std::string_view text) {
  const std::vector<TextFix> fixes = fixes_of(diagnostic, text);
  const auto certain = ranges::find_if(fixes, &TextFix::is_certain);
  return certain != fixes.end() ? std::optional(certain->edit) : std::nullopt;
}

void place_fixes(Diagnostics& diagnostics, const SourceMap& sources) {
  for (Diagnostic& each : diagnostics.all()) {
    const std::string& text = sources.text(each.span.file);
    std::vector<Fix> placed;
    for (TextFix& fix : fixes_of(each, text)) {
      Fix& literal = placed.emplace_back(Fix{fix.edit.reason, {}, fix.is_certain});
      for (Splice& splice : fix.edit.splices)
        literal.edits.push_back({EditKind::replace, std::move(splice.text), "", "",
                                 span_of(text, each.span.file, splice.place)});
    }
    each.help.fixes = std::move(placed);
  }
}

}  // namespace eagerx::gen
