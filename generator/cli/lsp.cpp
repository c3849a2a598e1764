// eagerx-gen lsp: the language server of graph files, for editors.
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <map>
#include <utility>

#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/files/files.hpp"
#include "generator/library/schema.hpp"
#include "generator/lsp/server.hpp"
#include "generator/lsp/stream.hpp"
#include "generator/outline/outline.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The rest of eagerx-gen, as the server needs it.
class Workshop final : public lsp::Analyst {
 public:
  explicit Workshop(LibraryOptions options) : options_(std::move(options)) {}

  Checked check(const std::string& path, const std::string& text) override {
    Run run;
    GraphOptions options;
    static_cast<LibraryOptions&>(options) = options_;
    options.graph = path;
    forget_files();  // every check is a run of its own
    check_text(run, options, text);
    run.diagnostics.drop_repeats();
    run.diagnostics.sort_by_place();
    return {std::move(run.sources), std::move(run.diagnostics)};
  }

  const lsp::LibraryFacts& of_graph(const std::string& path, const std::string& text) override {
    return library_of(path, text).facts;
  }
  const lsp::LibraryFacts& of_manifests() override {
    if (!of_manifests_) of_manifests_ = lsp::LibraryFacts{manifest_schema()};
    return *of_manifests_;
  }
  std::string manifest_of(const std::string& path, const std::string& text,
                          const std::string& id) override {
    const Known& known = library_of(path, text);
    const auto found = known.manifests.find(id);
    return found != known.manifests.end() ? found->second : std::string();
  }
  void forget() override { known_.clear(); }

 private:
  struct Known {
    lsp::LibraryFacts facts;
    std::map<std::string, std::string> manifests;  // of entities, by their ids
  };
  static constexpr std::size_t kMostLibraries = 20;

  /// The whole library of a graph, read once for all that have the same folders.
  const Known& library_of(const std::string& path, const std::string& text) {
    LibraryOptions options = options_;
    const OutlineNode outline = outline_of(text);
    if (const OutlineNode* const folders = outline.find("library")) {
      for (const OutlineEntry& each : folders->entries) {
        std::error_code ignored;
        const fs::path folder = fs::path(path).parent_path() / each.value.text;
        if (!each.value.text.empty() && fs::is_directory(folder, ignored))
          options.paths.push_back(folder.lexically_normal().string());
      }
    }
    if (known_.size() > kMostLibraries) known_.clear();
    const auto [place, is_new] = known_.try_emplace(options.paths);
    if (is_new) place->second = read_library(options);
    return place->second;
  }
  static Known read_library(const LibraryOptions& options) {
    Run run;
    load(run, options);
    Known known{{graph_schema(run.library)}, {}};
    for (const auto& [id, entity] : run.library.all_entities()) {
      known.manifests.emplace(id, fs::absolute(entity.path).string());
      for (const PortManifest& target : entity.reset_targets)
        known.facts.reset_targets[id].push_back(target.name.value);
    }
    return known;
  }

  const LibraryOptions options_;
  std::map<std::vector<std::string>, Known> known_;
  std::optional<lsp::LibraryFacts> of_manifests_;
};

/// False: nobody reads any more.
bool write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool has_more() {
  pollfd in{STDIN_FILENO, POLLIN, 0};
  return ::poll(&in, 1, 0) > 0;
}

int perform(const LibraryOptions& options) {
  constexpr std::size_t kBytesAtOnce = 65536;
  Workshop workshop(options);
  lsp::Server server(workshop);
  lsp::MessageReader messages;
  std::vector<char> bytes(kBytesAtOnce);
  const auto send = [&] {
    for (const std::string& each : server.take_answers()) {
      if (!write_all(lsp::message_of(each))) return false;
    }
    return true;
  };
  while (!server.has_ended()) {
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return kProblems;  // the editor is gone, and has not said `exit`
    messages.add({bytes.data(), static_cast<std::size_t>(size)});
    while (!server.has_ended()) {
      const auto content = messages.next();
      if (!content) break;
      server.take(*content);
      if (!send()) return kInputOutput;
    }
    if (messages.is_broken()) {
      complain(
          "error: what came is no message of the Language Server Protocol\nhelp: `eagerx-gen lsp` "
          "is started by an editor\n");
      return kProblems;
    }
    if (!has_more() && !server.has_ended()) {
      server.check_changed();
      if (!send()) return kInputOutput;
    }
  }
  return server.exit_code();
}

Command table(LibraryOptions& options) {
  return {.name = "lsp",
          .about = "serve an editor, by the Language Server Protocol on standard input and output",
          .examples = {{"what an editor starts for graph files and manifests", "eagerx-gen lsp"},
                       {"with entities of your own", "eagerx-gen lsp --path my_models"}},
          .arguments = {library(options)},
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command lsp_command() {
  return with_options<LibraryOptions>(table);
}

}  // namespace eagerx::gen
