// The part of a JSON schema (draft-07, as `eagerx-gen schema` writes it) that applies at a place in
// a possibly incomplete file.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/outline/outline.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen::lsp {

/// All parts of a schema that speak of one value, those of types and alternatives included.
using Schemas = std::vector<const Json*>;

/// The schemas of the value at `path`. Contains all alternatives, even if they contradict each
/// other; of conditional schemas (`if`), those that apply to `top`.
Schemas schemas_at(const Json& schema, const OutlineNode& top, const OutlinePath& path);

struct SchemaKey {
  std::string name, about;
  bool required = false;
  bool is_map = false;   // its value can be nothing but a map
  bool is_list = false;  // or a list
};
/// The keys that such a map may have, in the order of the schema.
std::vector<SchemaKey> keys_in(const Schemas& schemas);

struct SchemaValue {
  std::string text, about;
};
/// The values of which it may be one, if there are only some.
std::vector<SchemaValue> values_in(const Schemas& schemas);

/// The hover text of the value; empty: none.
std::string about(const Schemas& schemas);

}  // namespace eagerx::gen::lsp
