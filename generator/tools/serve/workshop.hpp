// The server's interface to the rest of eagerx-gen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen::serve {

class Workshop {
 public:
  Workshop() = default;
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  virtual ~Workshop() = default;

  struct Checked {
    SourceMap sources;  // the graph's own text is its first
    Diagnostics diagnostics;
    std::optional<Json> page;  // what the report would show; nothing: there are errors
  };
  /// The problems that `eagerx-gen check` finds in a graph of this text. The file itself is not
  /// looked at.
  virtual Checked check(const std::string& path, const std::string& text) = 0;
  /// The page that edits, with these data, or nothing: `problem` says why.
  virtual std::optional<std::string> page(const Json& data, std::string& problem) = 0;
  /// `{"entities": […], "targets": […]}` of the graph's library.
  virtual Json library(const std::string& path, const std::string& text) = 0;
  /// `{"sections": {…}}`: the keys that entries may have.
  virtual Json schema(const std::string& path, const std::string& text) = 0;
  /// The file of the module with the server (http.hpp).
  [[nodiscard]] virtual std::string http_module() const = 0;
  /// The command line that starts eagerx-gen itself.
  [[nodiscard]] virtual std::vector<std::string> self() const = 0;
};

}  // namespace eagerx::gen::serve
