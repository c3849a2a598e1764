// Completions at the cursor.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/outline.hpp"
#include "generator/tools/lsp/ports.hpp"
#include "generator/tools/lsp/resolved.hpp"

namespace eagerx::gen::lsp {

struct Proposal {
  enum class Kind : std::uint8_t { key, value, port, snippet };
  std::string label;   // the word itself
  std::string insert;  // with what comes behind it: `rate: `
  std::string about;
  Kind kind = Kind::key;
  std::string filter = {};  // what is compared with what was typed; empty: the label
};

struct Completion {
  Bytes word;  // what is replaced
  std::vector<Proposal> proposals;
};

/// The keys, ids, parameters, ports and values of `library` that fit at byte `at`, the most likely
/// first: missing required keys, ports without a connection. Completions that begin with the typed
/// text come before those that only contain it. With `snippets`, also entities with all required
/// keys.
Completion complete(const LibraryFacts& library, std::string_view text, std::size_t at,
                    bool snippets = false);

/// The hover text of the key or value at byte `at`, in Markdown; empty: none. With a `resolved`
/// graph, also rates, spaces, delays and ages.
struct Hover {
  Bytes word;
  std::string text;
};
Hover hover(const LibraryFacts& library, std::string_view text, std::size_t at,
            const Resolved* resolved = nullptr);

}  // namespace eagerx::gen::lsp
