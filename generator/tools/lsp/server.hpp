// The language server of graph files: requests of an editor and their answers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/outline.hpp"
#include "generator/support/json/json.hpp"
#include "generator/tools/edit/edit.hpp"
#include "generator/tools/lsp/analyst.hpp"
#include "generator/tools/lsp/text.hpp"

namespace eagerx::gen::lsp {

/// LSP 3.17. Takes messages, and returns the messages to send, in order.
class Server {
 public:
  explicit Server(Analyst& analyst) : analyst_(analyst) {}

  /// Takes one message; invalid JSON-RPC is answered with an error.
  void take(std::string_view content);
  /// Checks the documents that were changed since. The first call takes all messages that are
  /// there, so that no request waits for the check of an outdated text.
  void check_changed();
  /// The messages to send.
  std::vector<std::string> take_answers();
  [[nodiscard]] bool has_ended() const { return ended_; }
  /// 0 after `shutdown`, else 1, as the protocol requires.
  [[nodiscard]] int exit_code() const { return shut_down_ ? 0 : 1; }

 private:
  struct Document {
    std::string uri, path, text;
    std::int64_t version = 0;
    bool changed = false;
    std::vector<std::string> reported;  // URIs that have diagnostics because of this document
    Diagnostics diagnostics;            // of the last check
    SourceMap sources;
  };

  /// A result or an error.
  struct Answer {
    Json result;
    int error = 0;  // of JSON-RPC; 0: none
    std::string message = {};
  };

  Answer answer(const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  void send(const std::string& method, Json params);
  void respond(const Json& id, Answer answer);
  void refuse(const Json& id, int code, const std::string& message);

  Answer at_position(const std::string& method, const Document& document, const Json& params);
  Answer of_document(const std::string& method, const Document& document, const Json& params);
  Json initialize(const Json& params);
  /// Asks the editor to tell of files that change, and to ask for hints again.
  void initialized();
  void ask(const std::string& method, Json params);
  void open(const Json& params);
  void change(const Json& params);
  void close(const Json& params);
  Json completion(const Document& document, Position position);
  Json hover_text(const Document& document, Position position);
  Json definition(const Document& document, Position position);
  static Json references(const Document& document, Position position);
  Json prepare_rename(const Document& document, Position position);
  Answer renamed(const Document& document, Position position, const std::string& to);
  static Json actions(const Document& document, const Json& params);
  Json hints(const Document& document, const Json& params);
  void check(Document& document);
  /// All documents that a change of this one may concern.
  void mark_users_of(const Document& document);
  /// Tells of the diagnostics that are in other files than the document, too.
  void publish(Document& document);

  // A new name of a port: port_rename.cpp.
  struct PortToRename {
    std::string id, port, manifest, header;
    Bytes place;
  };
  std::optional<PortToRename> port_at(const Document& document, Position position);
  Answer port_renamed(const PortToRename& port, const std::string& to);
  struct Change {
    std::string path, uri, text;
    std::vector<Splice> splices;
  };
  std::vector<Change> changes_of(const PortToRename& port, const std::string& to);
  std::string why_not(const std::vector<Change>& changes);

  [[nodiscard]] Document* document_of(const Json& params);
  [[nodiscard]] const LibraryFacts& library_of(const Document& document);

  Analyst& analyst_;
  std::map<std::string, Document, std::less<>> documents_;  // by URI
  std::vector<std::string> answers_;
  bool initialized_ = false, shut_down_ = false, ended_ = false;
  // Capabilities of the editor:
  bool takes_snippets_ = false, watches_ = false, watches_folders_ = false, refreshes_ = false;
  int asked_ = 0;  // requests to the editor
};

}  // namespace eagerx::gen::lsp
