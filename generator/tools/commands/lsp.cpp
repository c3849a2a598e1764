// eagerx-gen lsp: the language server of graph files.
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/manifest_check.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/library/schema.hpp"
#include "generator/frontend/read/memory.hpp"
#include "generator/support/files/files.hpp"
#include "generator/support/files/unsaved.hpp"
#include "generator/tools/commands/partial_graph.hpp"
#include "generator/tools/commands/resolved_facts.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/lsp/server.hpp"
#include "generator/tools/lsp/stream.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The rest of eagerx-gen, as the server needs it.
class Workshop final : public lsp::Analyst {
 public:
  explicit Workshop(LibraryOptions options) : options_(std::move(options)) {}

  Checked check(const std::string& path, const std::string& text) override {
    auto run = run_of(path, text);
    Checked checked{std::move(run->sources), std::move(run->diagnostics)};
    if (run->plan && !checked.diagnostics.has_errors()) good_[path] = {std::move(run), nullptr};
    return checked;
  }
  Checked try_out(const std::string& path, const std::string& text) override {
    auto run = run_of(path, text);
    return {std::move(run->sources), std::move(run->diagnostics)};
  }
  std::shared_ptr<const lsp::Resolved> resolved(const std::string& path) override {
    const auto found = good_.find(path);
    if (found == good_.end()) return nullptr;
    Good& good = found->second;
    if (!good.facts) {
      good.facts = std::make_shared<const lsp::Resolved>(resolved_facts(*good.run));
      good.run.reset();
    }
    return good.facts;
  }

  const lsp::LibraryFacts& of_graph(const std::string& path, const std::string& text) override {
    return library_of(path, text).facts;
  }
  const lsp::LibraryFacts& of_manifests() override {
    if (!of_manifests_) of_manifests_ = lsp::LibraryFacts{manifest_schema()};
    return *of_manifests_;
  }
  std::optional<EntityFiles> files_of(const std::string& path, const std::string& text,
                                      const std::string& id) override {
    const Known& known = library_of(path, text);
    const auto found = known.files.find(id);
    return found != known.files.end() ? std::optional(found->second) : std::nullopt;
  }
  std::vector<std::string> own_manifests(const std::string& path,
                                         const std::string& text) override {
    return library_of(path, text).own_manifests;
  }
  [[nodiscard]] std::vector<std::string> folders() const override {
    std::vector<std::string> result;
    for (const std::string& path : options_.paths) result.push_back(whole(path));
    return result;
  }

  void set_text(const std::string& path, std::optional<std::string> text) override {
    if (path.empty()) return;
    if (!text) good_.erase(path);
    set_unsaved(path, std::move(text));
  }
  std::optional<std::string> text_of(const std::string& path) override {
    if (auto text = unsaved_text(path)) return text;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  void forget() override { known_.clear(); }

 private:
  struct Known {
    lsp::LibraryFacts facts;
    std::map<std::string, EntityFiles> files;  // of entities, by their ids
    std::vector<std::string> own_manifests;
  };
  /// The last text of a graph that had no error, and what is made of it once somebody asks.
  struct Good {
    std::unique_ptr<Run> run;
    std::shared_ptr<const lsp::Resolved> facts;
  };
  static constexpr std::size_t kMostLibraries = 20;

  static std::string whole(const std::string& path) {
    std::error_code ignored;
    return fs::absolute(path, ignored).lexically_normal().string();
  }

  [[nodiscard]] std::unique_ptr<Run> run_of(const std::string& path, const std::string& text) {
    auto run = std::make_unique<Run>();
    GraphOptions options;
    static_cast<LibraryOptions&>(options) = options_;
    options.graph = path;
    forget_files();  // every check is a run of its own
    if (is_manifest(path)) {
      check_manifest(*run, options, path, text);
    } else {
      check_text(*run, options, text);
    }
    run->diagnostics.drop_repeats();
    run->diagnostics.sort_by_place();
    return run;
  }

  /// The whole library of a graph, read once for all that have the same folders.
  const Known& library_of(const std::string& path, const std::string& text) {
    const LibraryOptions options = with_folders_of(options_, path, text);
    if (known_.size() > kMostLibraries) known_.clear();
    const auto [place, is_new] = known_.try_emplace(options.paths);
    if (is_new) place->second = read_library(options);
    return place->second;
  }
  static Known read_library(const LibraryOptions& options) {
    Run run;
    load(run, options);
    Known known{{graph_schema(run.library)}, {}, {}};
    for (const auto& [id, entity] : run.library.all_entities()) {
      const std::string header =
          entity.cpp.include.empty()
              ? std::string()
              : (fs::path(entity.include_root) / entity.cpp.include).string();
      known.files.emplace(id, EntityFiles{whole(entity.path), header, entity.own});
      for (const PortManifest& target : entity.reset_targets)
        known.facts.reset_targets[id].push_back(target.name.value);
    }
    known.own_manifests = manifests_below(options.paths);
    return known;
  }
  static std::vector<std::string> manifests_below(const std::vector<std::string>& folders) {
    std::vector<std::string> found;
    for (const std::string& folder : folders) {
      std::error_code error;
      fs::recursive_directory_iterator walk(whole(folder),
                                            fs::directory_options::skip_permission_denied, error);
      for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
        if (walk->path().filename() == "manifest.yaml") found.push_back(walk->path().string());
      }
    }
    std::ranges::sort(found);
    return found;
  }

  const LibraryOptions options_;
  std::map<std::vector<std::string>, Known> known_;
  std::map<std::string, Good> good_;  // by the paths of graphs
  std::optional<lsp::LibraryFacts> of_manifests_;
};

/// False: the reader is gone.
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
  const ReadMemory memory;  // of files that are read again at every change
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
          "error: the input is not a message of the Language Server Protocol\nhelp: `eagerx-gen "
          "lsp` "
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
  return {
      .name = "lsp",
      .about = "serve an editor over the Language Server Protocol, on standard input and output",
      .examples = {{"command for an editor's settings, for graphs and manifests", "eagerx-gen lsp"},
                   {"with your own entities", "eagerx-gen lsp --path my_models"}},
      .arguments = {library(options)},
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command lsp_command() {
  return with_options<LibraryOptions>(table);
}

}  // namespace eagerx::gen
