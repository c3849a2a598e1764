#include "generator/tools/serve/state_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "generator/frontend/outline/fixes.hpp"
#include "generator/frontend/outline/lines.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen::serve {
namespace {

using Kind = OutlineNode::Kind;
constexpr std::size_t kMostProblems = 500;

/// As it is written, on one line.
std::string written(const OutlineNode& node, std::string_view text, const OutlineEntry& entry) {
  if (node.kind == Kind::scalar) return node.text;
  if (node.kind == Kind::nothing || !node.flow) return {};
  const std::size_t begin = text.find_first_of("{[", entry.key_place.end);
  std::string value(text.substr(begin, std::min(entry.whole.end, text.size()) - begin));
  while (!value.empty() && (value.back() == ' ' || value.back() == '\r')) value.pop_back();
  return value;
}

std::size_t line_at(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, at), '\n'));
}

std::string text_of_key(const OutlineNode& node, std::string_view key) {
  const OutlineNode* const found = node.find(key);
  return found != nullptr ? found->text : std::string();
}

/// The names in a list or a mapping of such.
Json names_json(const OutlineNode& node) {
  Json names = Json::list();
  for (const OutlineEntry& entry : node.entries) {
    const std::string& name = entry.key.empty() ? entry.value.text : entry.key;
    if (!name.empty()) names.push_back(name);
  }
  return names;
}

class Outliner {
 public:
  explicit Outliner(std::string_view text) : text_(text), top_(outline_of(text)) {}

  Json all() const {
    Json json{{"name", text_of_key(top_, "name")}, {"rate", text_of_key(top_, "rate")}};
    const OutlineNode* const engine = top_.find("engine");
    json["engine"] = engine == nullptr ? Json(nullptr)
                                       : Json{{"type", text_of_key(*engine, "type")},
                                              {"rate", text_of_key(*engine, "rate")}};
    for (const char* const section : {"objects", "nodes", "actions", "observations"})
      json[section] = entries(section);
    json["connections"] = connections();
    const OutlineNode* const render = top_.find("render");
    json["render"] = render == nullptr ? "" : text_of_key(*render, "source");
    return json;
  }

 private:
  [[nodiscard]] Json entries(const char* section) const {
    Json list = Json::list();
    const OutlineNode* const all = top_.find(section);
    if (all == nullptr) return list;
    for (const OutlineEntry& entry : all->entries) {
      const std::string& name = entry.key.empty() ? entry.value.text : entry.key;
      if (name.empty()) continue;
      Json one{{"name", name}, {"path", Json(std::vector<std::string>{section, name})}};
      one["line"] = line_at(text_, entry.whole.begin);
      for (const char* const key : {"type", "rate", "count"})
        one[key] = text_of_key(entry.value, key);
      Json ports = Json::object();
      for (const char* const side : {"sensors", "actuators", "inputs", "outputs"}) {
        if (const OutlineNode* const chosen = entry.value.find(side))
          ports[side] = names_json(*chosen);
      }
      one["ports"] = std::move(ports);
      list.push_back(std::move(one));
    }
    return list;
  }

  [[nodiscard]] Json connections() const {
    Json list = Json::list();
    const OutlineNode* const all = top_.find("connections");
    if (all == nullptr) return list;
    for (std::size_t i = 0; i < all->entries.size(); ++i) {
      const OutlineEntry& entry = all->entries[i];
      Json keys = Json::object();
      for (const OutlineEntry& key : entry.value.entries) {
        if (key.key != "from" && key.key != "to" && !key.key.empty())
          keys[key.key] = written(key.value, text_, key);
      }
      list.push_back(Json{{"from", text_of_key(entry.value, "from")},
                          {"to", text_of_key(entry.value, "to")},
                          {"path", path_json({"connections", i})},
                          {"line", line_at(text_, entry.whole.begin)},
                          {"keys", std::move(keys)}});
    }
    return list;
  }

  std::string_view text_;
  OutlineNode top_;
};

/// As it is nested, texts without quotes.
Json tree_of(const OutlineNode& node) {
  if (node.kind == Kind::scalar) return node.text;
  if (node.kind == Kind::nothing) return nullptr;
  Json json = node.kind == Kind::list ? Json::list() : Json::object();
  for (const OutlineEntry& entry : node.entries) {
    if (node.kind == Kind::list) {
      json.push_back(tree_of(entry.value));
    } else if (entry.has_colon) {
      json[entry.key] = tree_of(entry.value);
    }
  }
  return json;
}

/// The innermost key, value or item that has a byte.
OutlinePath path_at(const OutlineNode& top, std::size_t at) {
  OutlinePath path;
  for (const OutlineNode* node = &top; node != nullptr;) {
    const OutlineNode* inner = nullptr;
    for (std::size_t i = 0; i < node->entries.size(); ++i) {
      const OutlineEntry& entry = node->entries[i];
      if (at < entry.whole.begin || at >= entry.whole.end) continue;
      if (node->kind == Kind::map) {
        path.emplace_back(entry.key);
      } else {
        path.emplace_back(i);
      }
      inner = &entry.value;
      break;
    }
    node = inner;
  }
  return path;
}

/// UTF-16 code units before each of some bytes, asked for in any order.
class Utf16 {
 public:
  explicit Utf16(std::string_view text) : text_(text) {}
  std::size_t at(std::size_t byte) {
    if (byte < byte_) byte_ = units_ = 0;
    while (byte_ < byte && byte_ < text_.size()) {
      const auto point = decode_utf8(text_, byte_);
      units_ += point.value > 0xFFFF ? 2 : 1;
      byte_ += point.size;
    }
    return units_;
  }

 private:
  std::string_view text_;
  std::size_t byte_ = 0, units_ = 0;
};

const char* name_of(Severity severity) {
  if (severity == Severity::error) return "error";
  return severity == Severity::warning ? "warning" : "note";
}

}  // namespace

Json outline_json(std::string_view text) {
  return Outliner(text).all();
}

Json tree_json(std::string_view text) {
  return tree_of(outline_of(text));
}

Json problems_json(const Workshop::Checked& checked, const std::string& path,
                   std::string_view text) {
  const auto own = static_cast<FileId>(0);
  const bool has_own = checked.sources.name(own) == path;
  const OutlineNode top = outline_of(text);
  Utf16 units(text);
  Json list = Json::list();
  std::size_t count = 0;
  for (const Diagnostic& problem : checked.diagnostics.all()) {
    if (++count > kMostProblems) break;
    Json notes = Json::list();
    for (const auto& note : problem.notes) notes.push_back(note.message);
    Span place = problem.span;
    std::string elsewhere;
    if (place.file != FileId::none && place.file != own) {
      if (checked.sources.name(place.file) != path) elsewhere = checked.sources.name(place.file);
      place = has_own ? checked.sources.place_in(own, place) : Span{};
    }
    Json json{{"code", problem.code},       {"severity", name_of(problem.severity)},
              {"message", problem.message}, {"help", problem.help.text},
              {"notes", std::move(notes)},  {"line", place.line},
              {"column", place.column},     {"length", place.length}};
    const bool has_place = place.line > 0;
    const Bytes bytes = has_place ? bytes_of(text, place) : Bytes{};
    json["begin"] = units.at(bytes.begin);
    json["end"] = units.at(bytes.end);
    json["path"] = has_place ? path_json(path_at(top, bytes.begin)) : Json::list();
    json["file"] = elsewhere;
    const auto fix = problem.span.file == own ? fix_of(problem, text) : std::nullopt;
    json["fix"] = fix ? Json(fix->reason) : Json(nullptr);
    list.push_back(std::move(json));
  }
  return list;
}

Json path_json(const OutlinePath& path) {
  Json list = Json::list();
  for (const auto& step : path) {
    if (const auto* const key = std::get_if<std::string>(&step)) {
      list.push_back(*key);
    } else {
      list.push_back(std::get<std::size_t>(step));
    }
  }
  return list;
}

std::optional<OutlinePath> path_of(const Json* json) {
  constexpr std::size_t kLongest = 64;
  const auto* const steps = json != nullptr ? json->as<Json::List>() : nullptr;
  if (steps == nullptr || steps->size() > kLongest) return std::nullopt;
  OutlinePath path;
  for (const Json& step : *steps) {
    if (const auto* const key = step.as<std::string>()) {
      path.emplace_back(*key);
    } else if (const auto* const place = step.as<std::int64_t>(); place != nullptr && *place >= 0) {
      path.emplace_back(static_cast<std::size_t>(*place));
    } else {
      return std::nullopt;
    }
  }
  return path;
}

}  // namespace eagerx::gen::serve
