// Which entities a graph may use, without reading the manifest of any other.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {

/// The texts and keys of graphs and manifests. Where an entity is used, its id is one of them; most
/// others are no ids and cost nothing.
class Mentions {
 public:
  void add(const std::string& text);
  /// All texts and keys in `yaml`.
  void add(const YamlValue& yaml);
  /// Those of a manifest: what an object says of an engine only if the engine is mentioned. Until
  /// then it waits, so the tree has to stay.
  void add_manifest(const YamlValue& manifest);
  /// A text that was not given out before; nullopt if there is no more.
  std::optional<std::string> next();

 private:
  std::set<std::string> texts_;
  std::vector<std::string> todo_;
  std::multimap<std::string, const YamlValue*> waiting_;  // by the engine
};

/// The id in a manifest's text, if there is exactly one line for it and the id is a plain word.
std::optional<std::string_view> declared_id(std::string_view text);

}  // namespace eagerx::gen
