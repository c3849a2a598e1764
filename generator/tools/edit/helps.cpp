#include "generator/tools/edit/helps.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/edit/insert.hpp"
#include "generator/tools/outline/lines.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kHole = "…";  // in a help: what only its reader knows

/// What stands in backticks.
std::vector<std::string> quoted_in(std::string_view help) {
  std::vector<std::string> found;
  for (std::size_t begin = help.find('`'); begin != std::string_view::npos;) {
    const std::size_t end = help.find('`', begin + 1);
    if (end == std::string_view::npos) break;
    found.emplace_back(help.substr(begin + 1, end - begin - 1));
    begin = help.find('`', end + 1);
  }
  return found;
}

bool has_hole(std::string_view text) {
  return text.find(kHole) != std::string_view::npos;
}

/// Without holes: what is to be written there is left open.
std::string opened(std::string text) {
  for (std::size_t at = text.find(kHole); at != std::string::npos; at = text.find(kHole, at))
    text.erase(at, kHole.size());
  return text;
}

class Reader {
 public:
  Reader(const Diagnostic& diagnostic, std::string_view text)
      : diagnostic_(diagnostic),
        text_(text),
        help_(diagnostic.help),
        place_(bytes_of(text, diagnostic.span)) {}

  std::vector<Help> all() {
    if (help_.empty() || diagnostic_.span.line == 0) return {};
    if (diagnostic_.span.length > 0) in_place();
    if (helps_.empty() || diagnostic_.severity == Severity::warning) added();
    return std::move(helps_);
  }

 private:
  [[nodiscard]] bool says(std::string_view words) const {
    return help_.find(words) != std::string_view::npos;
  }
  [[nodiscard]] std::string here() const {
    return std::string(text_.substr(place_.begin, place_.end - place_.begin));
  }
  void replace(std::string word) {
    std::string reason = fmt::format("Change to `{}`", word);
    helps_.push_back({{std::move(reason), {{place_, std::move(word)}}}, true});
  }
  void add(std::string reason, std::optional<Splice> splice, bool is_certain = false) {
    if (splice) helps_.push_back({{std::move(reason), {std::move(*splice)}}, is_certain});
  }

  /// What takes the place of what is wrong.
  void in_place() {
    const std::vector<std::string> words = quoted_in(help_);
    constexpr std::array kWritten = {"E0203", "E0204", "E0209", "E0322", "E0323"};
    if (const std::size_t found = help_.find("did you mean `"); found != std::string_view::npos) {
      if (!quoted_in(help_.substr(found)).empty()) replace(quoted_in(help_.substr(found)).front());
    } else if (help_.starts_with("write `") && !words.empty() && !has_hole(words.front()) &&
               ranges::contains(kWritten, diagnostic_.code)) {
      written_instead(words.front());
    } else if (help_.starts_with("put it in quotes")) {
      replace(fmt::format("\"{}\"", here()));
    } else if (says("quotes make it a text: leave them out")) {
      const std::string word = here();
      if (word.size() > 2 && word.front() == word.back()) replace(word.substr(1, word.size() - 2));
    } else if (const std::size_t meant = help_.find("write `rate: "); meant != std::string::npos) {
      meant_rate(quoted_in(help_.substr(meant)));
    } else if (help_ == "leave the tag out") {
      Bytes place = place_;
      while (place.end < text_.size() && text_[place.end] == ' ') ++place.end;
      helps_.push_back({{"Leave the tag out", {{place, ""}}}, true});
    }
  }
  /// "numbers without a unit are in Hz: write `rate: 0.5 Hz` if that is meant": a number in its
  /// place.
  void meant_rate(const std::vector<std::string>& words) {
    constexpr std::string_view kKey = "rate: ";
    const bool is_number = here().find_first_not_of("0123456789.eE+-") == std::string::npos;
    if (words.empty() || !is_number || has_hole(words.front())) return;
    replace(words.front().substr(kKey.size()));
    helps_.back().is_certain = false;
  }
  /// A number with its unit; or key and value, where they were written without a blank.
  void written_instead(const std::string& word) {
    const bool is_pair = word.find(": ") != std::string::npos;
    if (!is_pair || here().find(':') != std::string::npos) replace(word);
  }

  /// What is added elsewhere.
  void added() {
    top_ = outline_of(text_);
    if (help_.starts_with("add `") && says("to the connection")) {
      processors();
    } else if (help_.starts_with("add a connection `{")) {
      connection();
    } else if (help_.starts_with("add `config: {")) {
      parameter();
    } else if (help_.starts_with("add it to `") || says("to that list")) {
      to_a_list();
    } else if (help_.starts_with("add `skip: true`")) {
      skipped();
    } else if (help_.starts_with("add `") && says(":`,")) {
      missing_key();
    }
    if (diagnostic_.severity == Severity::warning) allowed();
  }

  /// "…; else `allow: [W0115]`"
  void allowed() {
    const std::string key = fmt::format("allow: [{}]", diagnostic_.code);
    if (!says(key)) return;
    const OutlineEntry* const all = entry_of(top_, "allow");
    add(fmt::format("Allow {} in this graph", diagnostic_.code),
        all != nullptr ? with_item(text_, *all, diagnostic_.code)
                       : with_section(text_, "allow", fmt::format("[{}]", diagnostic_.code)));
  }

  /// "add `processor: A` or `processor: B` to the connection"
  void processors() {
    const OutlineEntry* const item = item_at(place_.begin);
    if (item == nullptr) return;
    constexpr std::string_view kKey = "processor: ";
    for (const std::string& pair : quoted_in(help_)) {
      if (pair.starts_with(kKey) && !has_hole(pair))
        add(fmt::format("Put `{}` on the connection", pair.substr(kKey.size())),
            with_key(text_, *item, "processor", pair.substr(kKey.size())));
    }
  }
  /// "add `skip: true` to one of these connections": its own, or those of its notes.
  void skipped() {
    std::vector<Span> spans = {diagnostic_.span};
    for (const Diagnostic::Note& note : diagnostic_.notes) {
      if (note.span.file == diagnostic_.span.file) spans.push_back(note.span);
    }
    for (const Span& span : spans) {
      const OutlineEntry* const item = item_at(bytes_of(text_, span).begin);
      if (item == nullptr || item->value.find("skip") != nullptr) continue;
      add(fmt::format("Skip `{}` → `{}` (line {})", word_of(*item, "from"), word_of(*item, "to"),
                      span.line),
          with_key(text_, *item, "skip", "true"));
    }
  }
  /// "add a connection `{from: …, to: smooth.signal}`"
  void connection() {
    const std::string item = quoted_in(help_).front();
    const std::string reason = fmt::format("Add `{}`", item);
    const OutlineEntry* const all = entry_of(top_, "connections");
    add(reason, all == nullptr ? with_section(text_, "connections", "\n  - " + opened(item))
                               : with_item(text_, *all, opened(item)));
  }
  /// "add `config: {cutoff_hz: …}`: corner frequencies (Hz)"
  void parameter() {
    constexpr std::string_view kBegin = "config: {";
    const std::string word = quoted_in(help_).front();
    const std::size_t colon = word.find(": ", kBegin.size());
    if (colon == std::string::npos) return;
    const std::string name = word.substr(kBegin.size(), colon - kBegin.size());
    const OutlineEntry* const owner = owner_at(place_.begin);
    if (owner == nullptr) return;
    const OutlineEntry* const config = entry_of(owner->value, "config");
    add(fmt::format("Add the parameter `{}`", name),
        config != nullptr ? with_key(text_, *config, name, "")
                          : with_key(text_, *owner, "config", fmt::format("{{{}: }}", name)));
  }
  /// "add it to `inputs:` of `smooth`, or …", "add `theta` to that list, …": the port that is named
  /// where the problem is.
  void to_a_list() {
    const std::string port = port_here();
    const OutlineEntry* const owner = owner_named();
    if (owner == nullptr || port.empty()) return;
    for (const std::string& word : quoted_in(help_ + " " + diagnostic_.message)) {
      if (!word.ends_with(':')) continue;
      const OutlineEntry* const list = entry_of(owner->value, word.substr(0, word.size() - 1));
      if (list == nullptr) continue;
      const bool is_map = list->value.kind == OutlineNode::Kind::map;
      add(fmt::format("Add `{}` to `{}` of `{}`", port, word, owner->key),
          is_map ? with_key(text_, *list, port, "") : with_item(text_, *list, port));
      return;
    }
  }
  /// "add `rate:`, its rate in Hz": of the map that begins here.
  void missing_key() {
    const std::string word = quoted_in(help_).front();
    if (!word.ends_with(':')) return;
    const std::string key = word.substr(0, word.size() - 1);
    const OutlineNode* const rate = top_.find("rate");
    const std::string value = key == "rate" && rate != nullptr ? rate->text : "";
    const std::string reason = fmt::format("Add `{}{}`", word, value.empty() ? "" : " " + value);
    if (const OutlineEntry* const owner = map_at(place_.begin)) {
      add(reason, with_key(text_, *owner, key, value));
    } else if (top_.kind == OutlineNode::Kind::map) {
      add(reason, with_section(text_, key, value));
    }
  }

  /// The item of a list that has byte `at`: a connection.
  [[nodiscard]] const OutlineEntry* item_at(std::size_t at) const {
    const OutlineEntry* found = nullptr;
    for (const OutlineEntry* const each : entries_around(top_, at)) {
      if (each->key.empty() && each->value.kind == OutlineNode::Kind::map) found = each;
    }
    return found;
  }
  /// The smallest thing with a type around byte `at`.
  [[nodiscard]] const OutlineEntry* owner_at(std::size_t at) const {
    const OutlineEntry* found = nullptr;
    for (const OutlineEntry* const each : entries_around(top_, at)) {
      if (each->value.find("type") != nullptr) found = each;
    }
    return found;
  }
  /// The map whose first token stands at byte `at`; nullptr for the whole file.
  [[nodiscard]] const OutlineEntry* map_at(std::size_t at) const {
    for (const OutlineEntry* const each : entries_around(top_, at)) {
      if (each->value.kind != OutlineNode::Kind::map) continue;
      const OutlineNode& map = each->value;
      const std::size_t begin = map.flow              ? text_.find('{', each->key_place.end)
                                : map.entries.empty() ? at + 1
                                                      : map.entries.front().key_place.begin;
      if (begin == at) return each;
    }
    return nullptr;
  }
  static const OutlineEntry* entry_of(const OutlineNode& map, std::string_view key) {
    const auto found = ranges::find(map.entries, key, &OutlineEntry::key);
    return found != map.entries.end() ? &*found : nullptr;
  }
  static std::string word_of(const OutlineEntry& map, std::string_view key) {
    const OutlineNode* const value = map.value.find(key);
    return value != nullptr ? value->text : std::string();
  }
  /// The last part of "pendulum.theta", or of the name in the message.
  [[nodiscard]] std::string port_here() const {
    std::string word = here();
    if (word.find('.') == std::string::npos) {
      const std::vector<std::string> words = quoted_in(diagnostic_.message);
      if (words.empty()) return {};
      word = words.front();
    }
    const std::size_t dot = word.rfind('.');
    return dot == std::string::npos ? std::string() : word.substr(dot + 1);
  }
  /// The object or node of that port.
  [[nodiscard]] const OutlineEntry* owner_named() const {
    std::string word = here();
    word = word.substr(0, word.find_first_of(".["));
    for (const char* const section : {"objects", "nodes"}) {
      const OutlineNode* const all = top_.find(section);
      const OutlineEntry* const owner = all != nullptr ? entry_of(*all, word) : nullptr;
      if (owner != nullptr) return owner;
    }
    return nullptr;
  }

  const Diagnostic& diagnostic_;
  std::string_view text_;
  const std::string help_;
  const Bytes place_;
  OutlineNode top_;
  std::vector<Help> helps_;
};

}  // namespace

std::vector<Help> helps_of(const Diagnostic& diagnostic, std::string_view text) {
  return Reader(diagnostic, text).all();
}

std::optional<Edit> fix_of(const Diagnostic& diagnostic, std::string_view text) {
  const std::vector<Help> helps = helps_of(diagnostic, text);
  const auto certain = ranges::find_if(helps, &Help::is_certain);
  return certain != helps.end() ? std::optional(certain->edit) : std::nullopt;
}

}  // namespace eagerx::gen
