// The server's interface to the rest of eagerx-gen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/tools/lsp/ports.hpp"
#include "generator/tools/lsp/resolved.hpp"

namespace eagerx::gen::lsp {

class Analyst {
 public:
  Analyst() = default;
  Analyst(const Analyst&) = delete;
  Analyst& operator=(const Analyst&) = delete;
  virtual ~Analyst() = default;

  struct Checked {
    SourceMap sources;
    Diagnostics diagnostics;
  };
  /// The problems that `eagerx-gen check` finds in a graph, or a manifest, of this text. The file
  /// itself is not looked at.
  virtual Checked check(const std::string& path, const std::string& text) = 0;
  /// The same of a text of no document: it is not remembered.
  virtual Checked try_out(const std::string& path, const std::string& text) = 0;
  /// The graph of its last text without an error; nullptr: there was none.
  virtual std::shared_ptr<const Resolved> resolved(const std::string& path) = 0;
  /// With the entities of the graph's library; valid until the next call.
  virtual const LibraryFacts& of_graph(const std::string& path, const std::string& text) = 0;
  virtual const LibraryFacts& of_manifests() = 0;

  /// Where an entity of a graph's library is written.
  struct EntityFiles {
    std::string manifest, header;  // header: of a node's class; empty: there is none
    bool is_own = false;           // in a folder of the user
  };
  virtual std::optional<EntityFiles> files_of(const std::string& path, const std::string& text,
                                              const std::string& id) = 0;
  /// All manifests of folders of the user in that library.
  virtual std::vector<std::string> own_manifests(const std::string& path,
                                                 const std::string& text) = 0;
  /// Folders of the user other than those that graphs name.
  [[nodiscard]] virtual std::vector<std::string> folders() const = 0;

  /// Sets the text that replaces a file on the disk; nullopt: uses the file again.
  virtual void set_text(const std::string& path, std::optional<std::string> text) = 0;
  /// That text.
  virtual std::optional<std::string> text_of(const std::string& path) = 0;
  /// Other files have changed: libraries, manifests, weight files.
  virtual void forget() = 0;
};

}  // namespace eagerx::gen::lsp
