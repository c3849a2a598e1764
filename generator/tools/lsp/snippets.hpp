// Snippets of LSP for entities in a graph, with places to fill in.
#pragma once

#include <string>

#include "generator/frontend/outline/outline.hpp"
#include "generator/tools/lsp/ports.hpp"

namespace eagerx::gen::lsp {

/// After `type: `: the id, and the keys and parameters that its manifest requires and that `owner`,
/// the map with the type, lacks. In braces on the same line, else on lines indented by `indent`.
/// Only the id if nothing is missing.
struct SnippetPlace {
  const OutlineNode& graph;
  const OutlinePath& owner;  // of the map with the type: {"nodes", "smooth"}
  bool in_braces = false;
  std::size_t indent = 0;  // of that map's keys
};
std::string type_snippet(const LibraryFacts& library, const SnippetPlace& place,
                         const std::string& id);

/// A new object or node in `section`: `name: {type: Id, rate: …}`.
std::string entity_snippet(const LibraryFacts& library, const OutlineNode& graph,
                           const std::string& section, const std::string& id);

}  // namespace eagerx::gen::lsp
