// Kinds of `eagerx-gen new`: each has a folder of templates in templates/new.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// A kind as its kind.yaml describes it.
struct Kind {
  std::string name;     // "reset-node": of its folder
  std::string folder;   // of its templates
  std::string about;    // one line
  std::string defines;  // what the new folder adds to a library: entity, target; empty: nothing
  std::string parent;   // where new folders go if nothing else is said; empty: here
  bool dashes = false;  // names are `my-board` instead of `my_board`

  /// "a node", "an engine"
  [[nodiscard]] std::string with_article() const;
};

/// Names of all kinds, sorted; empty if the templates are not found.
std::vector<std::string> kinds_of_new();

/// Reads a kind. Problems: E0301 an unknown kind, E02xx errors in its kind.yaml.
std::optional<Kind> read_kind(const std::string& name, SourceMap& sources,
                              Diagnostics& diagnostics);

}  // namespace eagerx::gen
