#include "generator/frontend/read/memory.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

ReadMemory*& instance() {
  static ReadMemory* memory = nullptr;
  return memory;
}

bool begins_key(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

struct Line {
  std::string_view text;  // with its end
  std::size_t indent = 0;
  bool says_something = false;  // no blank line, no comment
  bool is_item = false;         // "- …"
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    const std::size_t size = newline == std::string_view::npos ? text.size() : newline + 1;
    Line line{text.substr(0, size), std::min(text.find_first_not_of(' '), size), false, false};
    const char first = line.indent < size ? text[line.indent] : '\n';
    line.says_something = first != '\n' && first != '#';
    line.is_item = first == '-' && line.indent + 1 < size &&
                   (text[line.indent + 1] == ' ' || text[line.indent + 1] == '\n');
    lines.push_back(line);
    text.remove_prefix(size);
  }
  return lines;
}

/// Lines [begin, end).
struct Piece {
  std::size_t begin = 0, end = 0;
};

/// The pieces that begin at lines for which `begins` holds; what is before the first is left out.
template <class Begins>
std::vector<Piece> cut(std::size_t begin, std::size_t end, const Begins& begins) {
  std::vector<Piece> pieces;
  for (std::size_t i = begin; i < end; ++i) {
    if (begins(i)) {
      if (!pieces.empty()) pieces.back().end = i;
      pieces.push_back({i, end});
    }
  }
  return pieces;
}

/// "nodes:", perhaps with a comment: all of its value is on other lines. The key; empty: it is not.
std::string_view key_alone(std::string_view line) {
  std::size_t end = 0;
  while (end < line.size() && (begins_key(line[end]) || (line[end] >= '0' && line[end] <= '9')))
    ++end;
  if (end >= line.size() || line[end] != ':') return {};
  const std::size_t next = line.find_first_not_of(' ', end + 1);
  const bool is_alone =
      next == std::string_view::npos || line[next] == '\n' || (line[next] == '#' && next > end + 1);
  return is_alone ? line.substr(0, end) : std::string_view();
}

void shift(YamlValue& value, FileId file, std::uint32_t lines) {
  value.span.file = file;
  value.span.line += lines;
  for (YamlValue& item : value.items) shift(item, file, lines);
  for (YamlValue::Entry& entry : value.entries) {
    entry.key_span.file = file;
    entry.key_span.line += lines;
    shift(entry.value, file, lines);
  }
}

}  // namespace

/// The parts that are known, in two generations: when the younger one is full, the elder one is
/// forgotten.
class ReadMemory::Parts {
 public:
  const YamlValue* find(std::string_view text) {
    const std::string key(text);
    if (const auto found = young_.find(key); found != young_.end()) return &found->second;
    auto old = old_.extract(key);
    if (old.empty()) return nullptr;
    return &keep(std::move(old.key()), std::move(old.mapped()));
  }
  const YamlValue& keep(std::string text, YamlValue value) {
    bytes_ += text.size();
    if (bytes_ > kMostBytes) {
      bytes_ = text.size();
      old_ = std::exchange(young_, {});
    }
    return young_.insert_or_assign(std::move(text), std::move(value)).first->second;
  }

 private:
  static constexpr std::size_t kMostBytes = 1U << 20U;  // of texts, in a generation
  std::unordered_map<std::string, YamlValue> young_, old_;
  std::size_t bytes_ = 0;
};

namespace {

/// One reading of one text.
template <class Parts>
class Assembly {
 public:
  Assembly(FileId file, std::string_view text, const ReadLimits& limits,
           const ReadMemory::Parse& parse, Parts& parts)
      : file_(file), lines_(lines_of(text)), limits_(limits), parse_(parse), parts_(parts) {}

  std::optional<YamlValue> all() {
    const bool is_clean = ranges::all_of(lines_, [](const Line& line) {
      return !line.says_something || line.indent > 0 || line.is_item || begins_key(line.text[0]);
    });
    const auto sections = cut(0, lines_.size(), [&](std::size_t i) {
      return lines_[i].says_something && lines_[i].indent == 0 && !lines_[i].is_item;
    });
    if (!is_clean || sections.empty()) return std::nullopt;
    if (std::any_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(sections[0].begin),
                    [](const Line& line) { return line.says_something; }))
      return std::nullopt;
    YamlValue root;
    root.kind = YamlKind::map;
    for (const Piece& section : sections) {
      if (!add_section(section, root)) return std::nullopt;
    }
    root.span = root.entries.front().key_span;
    return root;
  }

 private:
  [[nodiscard]] std::string_view text_of(const Piece& piece) const {
    const std::string_view last = lines_[piece.end - 1].text;
    const char* const begin = lines_[piece.begin].text.data();
    return {begin, static_cast<std::size_t>(last.data() + last.size() - begin)};
  }

  /// The one entry or item of a piece; nothing: it is something else.
  std::optional<YamlValue> part(const Piece& piece, YamlKind kind, std::size_t depth) {
    const std::string_view text = text_of(piece);
    const YamlValue* known = parts_.find(text);
    if (known == nullptr) {
      ReadLimits limits = limits_;
      limits.max_depth -= depth;
      auto parsed = parse_(text, limits);
      if (!parsed) return std::nullopt;
      known = &parts_.keep(std::string(text), std::move(*parsed));
    }
    const bool fits = known->kind == kind && known->items.size() + known->entries.size() == 1;
    if (!fits) return std::nullopt;
    YamlValue copy = *known;
    shift(copy, file_, static_cast<std::uint32_t>(piece.begin));
    return copy;
  }

  bool add_section(const Piece& section, YamlValue& root) {
    const auto pieces = entries_of(section);
    if (!pieces.empty()) return add_in_pieces(section, pieces, root);
    auto one = part(section, YamlKind::map, 0);
    return one && add(root, std::move(one->entries.front()), keys_);
  }

  /// Where a large section can be cut once more.
  [[nodiscard]] std::vector<Piece> entries_of(const Piece& section) const {
    constexpr std::size_t kLarge = 20;  // lines
    if (section.end - section.begin < kLarge || key_alone(lines_[section.begin].text).empty())
      return {};
    const auto first = std::find_if(lines_.begin() + static_cast<std::ptrdiff_t>(section.begin) + 1,
                                    lines_.begin() + static_cast<std::ptrdiff_t>(section.end),
                                    [](const Line& line) { return line.says_something; });
    if (first == lines_.begin() + static_cast<std::ptrdiff_t>(section.end)) return {};
    for (std::size_t i = section.begin + 1; i < section.end; ++i) {
      const Line& line = lines_[i];
      if (!line.says_something || line.indent > first->indent) continue;
      const bool is_alike = line.indent == first->indent && line.is_item == first->is_item &&
                            (line.is_item || begins_key(line.text[line.indent]));
      if (!is_alike) return {};
    }
    return cut(section.begin + 1, section.end, [&](std::size_t i) {
      return lines_[i].says_something && lines_[i].indent == first->indent;
    });
  }
  bool add_in_pieces(const Piece& section, const std::vector<Piece>& pieces, YamlValue& root) {
    const bool is_list = lines_[pieces.front().begin].is_item;
    YamlValue::Entry entry;
    entry.key = key_alone(lines_[section.begin].text);
    entry.key_span = {file_, static_cast<std::uint32_t>(section.begin + 1), 1,
                      static_cast<std::uint32_t>(entry.key.size())};
    entry.value.kind = is_list ? YamlKind::sequence : YamlKind::map;
    std::unordered_set<std::string> keys;
    for (const Piece& piece : pieces) {
      auto one = part(piece, entry.value.kind, 1);
      if (!one) return false;
      if (entry.value.items.empty() && entry.value.entries.empty()) entry.value.span = one->span;
      if (is_list) {
        entry.value.items.push_back(std::move(one->items.front()));
      } else if (!add(entry.value, std::move(one->entries.front()), keys)) {
        return false;
      }
    }
    return add(root, std::move(entry), keys_);
  }
  static bool add(YamlValue& map, YamlValue::Entry entry, std::unordered_set<std::string>& keys) {
    if (!keys.insert(entry.key).second) return false;
    map.entries.push_back(std::move(entry));
    return true;
  }

  const FileId file_;
  const std::vector<Line> lines_;
  const ReadLimits& limits_;
  const ReadMemory::Parse& parse_;
  Parts& parts_;
  std::unordered_set<std::string> keys_;
};

/// Aliases need what is elsewhere, and tabs may stand where lines are cut.
bool may_be_cut(std::string_view text) {
  constexpr std::size_t kMostBytes = 1U << 20U;
  if (text.size() > kMostBytes || text.find('\t') != std::string_view::npos) return false;
  return text.find(" &") == std::string_view::npos && text.find(" *") == std::string_view::npos;
}

}  // namespace

ReadMemory::ReadMemory() : parts_(std::make_unique<Parts>()) {
  instance() = this;
}
ReadMemory::~ReadMemory() {
  instance() = nullptr;
}
ReadMemory* ReadMemory::current() {
  return instance();
}

std::optional<YamlValue> ReadMemory::read(FileId file, std::string_view text,
                                          const ReadLimits& limits, const Parse& parse) {
  const ReadLimits usual;
  if (!may_be_cut(text) || limits.max_depth != usual.max_depth ||
      limits.max_values != usual.max_values)
    return std::nullopt;
  return Assembly<Parts>(file, text, limits, parse, *parts_).all();
}

}  // namespace eagerx::gen
