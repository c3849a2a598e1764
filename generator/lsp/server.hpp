// The language server of graph files: what an editor asks, and what it is told.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"
#include "generator/json/json.hpp"
#include "generator/lsp/ports.hpp"
#include "generator/lsp/text.hpp"

namespace eagerx::gen::lsp {

/// What the server needs of the rest of eagerx-gen.
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
  /// What `eagerx-gen check` finds in a graph of this text. The file itself is not looked at.
  virtual Checked check(const std::string& path, const std::string& text) = 0;
  /// With the entities of the graph's library; valid until the next call.
  virtual const LibraryFacts& of_graph(const std::string& path, const std::string& text) = 0;
  virtual const LibraryFacts& of_manifests() = 0;
  /// The manifest of an entity, by its id, as the graph finds it; empty: there is none.
  virtual std::string manifest_of(const std::string& path, const std::string& text,
                                  const std::string& id) = 0;
  /// Other files have changed: libraries, manifests, weight files.
  virtual void forget() = 0;
};

/// LSP 3.17. Messages go in, and what is to be sent comes out, in its order.
class Server {
 public:
  explicit Server(Analyst& analyst) : analyst_(analyst) {}

  /// Takes one message; what is no JSON-RPC gets an answer that says so.
  void take(std::string_view content);
  /// Checks the documents that were changed since. Whoever calls this first takes all messages that
  /// are there, so that nobody waits for the check of a text that is no more.
  void check_changed();
  /// What is to be sent: the contents of messages.
  std::vector<std::string> take_answers();
  [[nodiscard]] bool has_ended() const { return ended_; }
  /// 0 after `shutdown`, else 1, as the protocol asks for.
  [[nodiscard]] int exit_code() const { return shut_down_ ? 0 : 1; }

 private:
  struct Document {
    std::string uri, path, text;
    std::int64_t version = 0;
    bool changed = false;
    std::vector<std::string> told;  // URIs that have diagnostics because of this document
    Diagnostics diagnostics;        // of the last check
    SourceMap sources;
  };

  /// A result, or why there is none.
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

  Json initialize();
  void open(const Json& params);
  void change(const Json& params);
  void close(const Json& params);
  Json completion(const Document& document, Position position);
  Json hover_text(const Document& document, Position position);
  Json definition(const Document& document, Position position);
  static Json references(const Document& document, Position position);
  static Json prepare_rename(const Document& document, Position position);
  Answer renamed(const Document& document, Position position, const std::string& to);
  static Json symbols(const Document& document);
  static Json actions(const Document& document, const Json& params);
  void check(Document& document);
  /// Tells of the diagnostics that are in other files than the document, too.
  void publish(Document& document);

  [[nodiscard]] Document* document_of(const Json& params);
  [[nodiscard]] const LibraryFacts& library_of(const Document& document);

  Analyst& analyst_;
  std::map<std::string, Document, std::less<>> documents_;  // by URI
  std::vector<std::string> answers_;
  bool initialized_ = false, shut_down_ = false, ended_ = false;
};

}  // namespace eagerx::gen::lsp
