#include "generator/tools/lsp/complete.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/lsp/schema_view.hpp"
#include "generator/tools/lsp/snippets.hpp"

namespace eagerx::gen::lsp {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// 0: begins with what was typed; 1: contains it; 2: neither.
int distance(const std::string& label, const std::string& typed) {
  const std::string word = lower(label), part = lower(typed);
  if (word.starts_with(part)) return 0;
  return word.find(part) == std::string::npos ? 2 : 1;
}

std::string key_of(const OutlinePath& path, std::size_t from_end) {
  if (path.size() < from_end) return {};
  const auto* const key = std::get_if<std::string>(&path[path.size() - from_end]);
  return key != nullptr ? *key : std::string();
}

/// One begins with the other's first letters, or contains it.
bool are_alike(const std::string& type, const std::string& name) {
  constexpr std::size_t kLetters = 4;
  const std::string a = lower(type), b = lower(name);
  if (a.empty() || b.empty()) return false;
  return a.starts_with(b.substr(0, kLetters)) || a.find(b) != std::string::npos ||
         b.find(a) != std::string::npos;
}

/// The ids of entities in a graph.
std::vector<std::string> types_in(const OutlineNode& node) {
  std::vector<std::string> types;
  if (const OutlineNode* const type = node.find("type"); type != nullptr && !type->text.empty())
    types.push_back(type->text);
  for (const OutlineEntry& entry : node.entries) {
    for (std::string& type : types_in(entry.value)) types.push_back(std::move(type));
  }
  return types;
}

class Completer {
 public:
  Completer(const LibraryFacts& library, std::string_view text, std::size_t at, bool snippets)
      : library_(library),
        text_(text),
        top_(outline_of(text)),
        cursor_(cursor_at(text, at)),
        snippets_(snippets) {}

  Completion all() {
    if (cursor_.is_key || cursor_.may_be_key) keys();
    if (!cursor_.is_key) {
      if (!ports()) values();
    }
    const auto distance_of = [&](const Proposal& each) {
      return distance(each.filter.empty() ? each.label : each.filter, cursor_.typed);
    };
    std::ranges::stable_sort(proposals_, std::less{}, distance_of);
    std::erase_if(proposals_, [&](const Proposal& each) { return distance_of(each) == 2; });
    return {cursor_.word, std::move(proposals_)};
  }

 private:
  void keys() {
    const OutlineNode* const map = node_at(top_, cursor_.path);
    std::vector<SchemaKey> missing = keys_in(schemas_at(library_.schema, top_, cursor_.path));
    // People write keys in the order of the format: what comes next is what the last one is before.
    const auto last = ranges::find(missing, key_before(map), &SchemaKey::name);
    if (last != missing.end()) std::rotate(missing.begin(), std::next(last), missing.end());
    std::erase_if(missing, [&](const SchemaKey& key) { return is_written(map, key.name); });
    if (!cursor_.path.empty())
      std::ranges::stable_sort(missing, std::greater{}, &SchemaKey::required);
    for (SchemaKey& key : missing) {
      std::string insert = key.name + (has_colon() ? "" : ": ");
      proposals_.push_back(
          {std::move(key.name), std::move(insert), std::move(key.about), Proposal::Kind::key});
    }
    if (snippets_ && cursor_.path.size() == 1) new_entities(key_of(cursor_.path, 1));
  }
  /// A whole object or node where the name of one is expected.
  void new_entities(const std::string& section) {
    if ((section != "objects" && section != "nodes") || has_colon()) return;
    for (SchemaValue& type : values_in(schemas_at(library_.schema, top_, {section, "x", "type"}))) {
      if (distance(type.text, cursor_.typed) == 2) continue;
      std::string insert = entity_snippet(library_, top_, section, type.text);
      proposals_.push_back({fmt::format("name: {{type: {}, …}}", type.text), std::move(insert),
                            std::move(type.about), Proposal::Kind::snippet, type.text});
    }
  }
  [[nodiscard]] std::string key_before(const OutlineNode* map) const {
    std::string key;
    if (map == nullptr) return key;
    for (const OutlineEntry& entry : map->entries) {
      if (entry.has_colon && entry.key_place.end < cursor_.word.begin) key = entry.key;
    }
    return key;
  }
  /// Elsewhere than under the cursor.
  [[nodiscard]] bool is_written(const OutlineNode* map, const std::string& key) const {
    return map != nullptr && map->kind == OutlineNode::Kind::map &&
           ranges::any_of(map->entries, [&](const OutlineEntry& entry) {
             return entry.key == key && (entry.key_place.end < cursor_.word.begin ||
                                         entry.key_place.begin > cursor_.word.end);
           });
  }
  [[nodiscard]] bool has_colon() const {
    const std::size_t next = text_.find_first_not_of(' ', cursor_.word.end);
    return next != std::string_view::npos && text_[next] == ':';
  }

  void values() {
    std::vector<SchemaValue> values = values_in(schemas_at(library_.schema, top_, cursor_.path));
    if (key_of(cursor_.path, 1) == "type") {
      // `course: {type: Course}`; then what the graph has already.
      const std::string owner = key_of(cursor_.path, 2);
      const std::vector<std::string> used = types_in(top_);
      std::ranges::stable_sort(values, std::less{}, [&](const SchemaValue& value) {
        if (are_alike(value.text, owner)) return 0;
        return ranges::contains(used, value.text) ? 1 : 2;
      });
    }
    for (SchemaValue& value : values) {
      proposals_.push_back({value.text, value.text, value.about, Proposal::Kind::value});
      if (snippets_ && key_of(cursor_.path, 1) == "type") with_what_it_needs(value);
    }
  }
  void with_what_it_needs(const SchemaValue& type) {
    if (distance(type.text, cursor_.typed) == 2) return;
    const OutlinePath owner(cursor_.path.begin(), std::prev(cursor_.path.end()));
    const OutlineNode* const map = node_at(top_, owner);
    if (map == nullptr) return;
    const std::size_t indent = map->entries.empty() ? 0 : column_of(map->entries.front().key_place);
    std::string insert = type_snippet(library_, {top_, owner, map->flow, indent}, type.text);
    if (insert == type.text) return;
    proposals_.push_back(
        {type.text + " …", std::move(insert), type.about, Proposal::Kind::snippet, type.text});
  }
  [[nodiscard]] std::size_t column_of(Bytes place) const {
    const std::size_t newline =
        place.begin == 0 ? std::string_view::npos : text_.rfind('\n', place.begin - 1);
    return newline == std::string_view::npos ? place.begin : place.begin - newline - 1;
  }

  /// False: no name of a port stands here.
  bool ports() {
    const std::string key = key_of(cursor_.path, 1);
    const bool in_connection = key_of(cursor_.path, 3) == "connections" && cursor_.path.size() == 3;
    if (in_connection && (key == "from" || key == "to")) {
      add_ports(key == "from" ? PortSide::sends : PortSide::receives);
      return true;
    }
    if (key == "like" && key_of(cursor_.path, 2) == "space") {
      add_ports(PortSide::receives);
      add_ports(PortSide::sends);
      return true;
    }
    return false;
  }
  void add_ports(PortSide side) {
    std::vector<NamedPort> ports = ports_of(library_, top_);
    std::erase_if(ports, [&](const NamedPort& port) { return port.side != side; });
    // First what is in no connection yet, and what the graph has chosen to have.
    const auto taken = connected(top_, side);
    std::ranges::stable_sort(ports, std::less{}, [&](const NamedPort& port) {
      const bool is_taken = ranges::contains(taken, port.name);
      return (is_taken ? 2 : 0) + (port.is_chosen ? 0 : 1);
    });
    for (NamedPort& port : ports)
      proposals_.push_back({port.name, port.name, std::move(port.about), Proposal::Kind::port});
  }

  const LibraryFacts& library_;
  std::string_view text_;
  OutlineNode top_;
  Cursor cursor_;
  bool snippets_;
  std::vector<Proposal> proposals_;
};

}  // namespace

Completion complete(const LibraryFacts& library, std::string_view text, std::size_t at,
                    bool snippets) {
  return Completer(library, text, at, snippets).all();
}

namespace {

void append(std::string& text, const std::string& more) {
  if (!more.empty()) text += (text.empty() ? "" : "\n\n") + more;
}

/// The last good text's description of a word: a port, by which a connection ends, an object or a
/// node.
std::string resolved_about(const Resolved& resolved, const Cursor& cursor,
                           const std::string& word) {
  const std::string name = without_indices(word);
  std::string text;
  const auto add = [&](const auto& map, const std::string& key) {
    if (const auto found = map.find(key); found != map.end()) append(text, found->second);
  };
  const bool is_owner = cursor.is_key && cursor.path.size() == 1 &&
                        (key_of(cursor.path, 1) == "objects" || key_of(cursor.path, 1) == "nodes");
  if (is_owner) add(resolved.owners, name);
  if (!cursor.is_key && key_of(cursor.path, 1) == "type" && cursor.path.size() == 3)
    add(resolved.owners, without_indices(key_of(cursor.path, 2)));
  if (cursor.is_key) return text;
  const auto connection = resolved.connections.find(name);
  if (key_of(cursor.path, 1) == "to" && connection != resolved.connections.end())
    append(text, connection->second.about);
  else
    add(resolved.ports, name);
  return text;
}

/// The library's description of a word.
std::string library_about(const LibraryFacts& library, const OutlineNode& top, const Cursor& cursor,
                          const std::string& word) {
  if (cursor.is_key) {
    OutlinePath path = cursor.path;
    path.emplace_back(word);
    return about(schemas_at(library.schema, top, path));
  }
  for (const SchemaValue& value : values_in(schemas_at(library.schema, top, cursor.path))) {
    if (value.text == word && !value.about.empty()) return value.about;
  }
  for (const NamedPort& port : ports_of(library, top)) {
    if (port.name == word && !port.about.empty()) return port.about;
  }
  return {};
}

}  // namespace

Hover hover(const LibraryFacts& library, std::string_view text, std::size_t at,
            const Resolved* resolved) {
  const OutlineNode top = outline_of(text);
  const Cursor cursor = cursor_at(text, at);
  const std::string word(text.substr(cursor.word.begin, cursor.word.end - cursor.word.begin));
  if (word.empty()) return {};
  std::string said = library_about(library, top, cursor, word);
  if (!said.empty()) said = "**" + word + "**: " + said;
  if (resolved != nullptr) append(said, resolved_about(*resolved, cursor, word));
  return {cursor.word, std::move(said)};
}

}  // namespace eagerx::gen::lsp
