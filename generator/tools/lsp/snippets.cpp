#include "generator/tools/lsp/snippets.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/lsp/schema_view.hpp"

namespace eagerx::gen::lsp {
namespace {

/// "ButterworthFilter" → "butterworth_filter"
std::string name_from(const std::string& id) {
  std::string name;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto c = static_cast<unsigned char>(id[i]);
    const bool begins =
        std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(id[i - 1])) != 0;
    if (begins) name += '_';
    name += static_cast<char>(std::tolower(c));
  }
  return name;
}

OutlineNode scalar(const std::string& text) {
  OutlineNode node;
  node.kind = OutlineNode::Kind::scalar;
  node.text = text;
  return node;
}

/// `node` with `type: id` in the map at `path`, from step `from` on; keys that are not there are
/// added.
OutlineNode with_type(OutlineNode node, const OutlinePath& path, std::size_t from,
                      const std::string& id) {
  const bool is_there = from == path.size();
  const auto* const step = is_there ? nullptr : std::get_if<std::string>(&path[from]);
  if (!is_there && step == nullptr) return node;
  const std::string key = is_there ? "type" : *step;
  node.kind = OutlineNode::Kind::map;
  auto entry = ranges::find(node.entries, key, &OutlineEntry::key);
  if (entry == node.entries.end()) {
    OutlineEntry added;
    added.key = key;
    added.has_colon = true;
    entry = node.entries.insert(node.entries.end(), std::move(added));
  }
  entry->value = is_there ? scalar(id) : with_type(std::move(entry->value), path, from + 1, id);
  return node;
}

/// The part of a graph on which the schema of one of its maps depends: the map and what is around
/// it, and words such as the graph's rate.
OutlineNode reduced(const OutlineNode& node, const OutlinePath& path, std::size_t from) {
  if (from == path.size()) return node;
  OutlineNode result;
  result.kind = node.kind;
  for (const OutlineEntry& entry : node.entries) {
    const auto* const step = std::get_if<std::string>(&path[from]);
    const bool is_way = step != nullptr && entry.key == *step;
    if (!is_way && entry.value.kind != OutlineNode::Kind::scalar) continue;
    OutlineEntry copy;
    copy.key = entry.key;
    copy.has_colon = entry.has_colon;
    copy.value = is_way ? reduced(entry.value, path, from + 1) : entry.value;
    result.entries.push_back(std::move(copy));
  }
  return result;
}

class Writer {
 public:
  Writer(const LibraryFacts& library, const OutlineNode& graph, const OutlinePath& owner,
         const std::string& id, int first_stop)
      : library_(library),
        graph_(with_type(reduced(graph, owner, 0), owner, 0, id)),
        owner_(owner),
        stop_(first_stop) {}

  /// `rate: ${1:30}`, `config: {cutoff_hz: $2}`: what is required and missing.
  std::vector<std::string> pairs() {
    std::vector<std::string> result;
    const OutlineNode* const map = node_at(graph_, owner_);
    for (const SchemaKey& key : missing(owner_, map)) {
      if (key.name != "type" && key.name != "config")
        result.push_back(fmt::format("{}: {}", key.name, value_of(key)));
    }
    const std::string parameters = config(map);
    if (!parameters.empty()) result.push_back(parameters);
    return result;
  }

 private:
  [[nodiscard]] std::vector<SchemaKey> missing(const OutlinePath& path,
                                               const OutlineNode* map) const {
    std::vector<SchemaKey> keys = keys_in(schemas_at(library_.schema, graph_, path));
    std::erase_if(keys, [&](const SchemaKey& key) {
      return !key.required || (map != nullptr && map->find(key.name) != nullptr);
    });
    return keys;
  }
  std::string config(const OutlineNode* map) {
    if (map != nullptr && map->find("config") != nullptr) return {};
    OutlinePath path = owner_;
    path.emplace_back("config");
    std::string text;
    for (const SchemaKey& key : missing(path, nullptr))
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key.name, value_of(key));
    return text.empty() ? text : fmt::format("config: {{{}}}", text);
  }
  std::string value_of(const SchemaKey& key) {
    const OutlineNode* const rate = graph_.find("rate");
    const int stop = stop_++;
    if (key.name == "rate" && rate != nullptr && !rate->text.empty())
      return fmt::format("${{{}:{}}}", stop, rate->text);
    if (key.is_map) return fmt::format("{{${}}}", stop);
    return key.is_list ? fmt::format("[${}]", stop) : fmt::format("${}", stop);
  }

  const LibraryFacts& library_;
  const OutlineNode graph_;
  const OutlinePath owner_;
  int stop_;
};

}  // namespace

std::string type_snippet(const LibraryFacts& library, const SnippetPlace& place,
                         const std::string& id) {
  std::string text = id;
  for (const std::string& pair : Writer(library, place.graph, place.owner, id, 1).pairs())
    text += (place.in_braces ? ", " : "\n" + std::string(place.indent, ' ')) + pair;
  return text;
}

std::string entity_snippet(const LibraryFacts& library, const OutlineNode& graph,
                           const std::string& section, const std::string& id) {
  const std::string name = name_from(id);
  std::string text = fmt::format("${{1:{}}}: {{type: {}", name, id);
  for (const std::string& pair : Writer(library, graph, {section, name}, id, 2).pairs())
    text += ", " + pair;
  return text + "}";
}

}  // namespace eagerx::gen::lsp
