// eagerx-gen serve: serves the page of a graph on this machine, and edits the graph's file as the
// page requests.
#include "generator/tools/serve/serve.hpp"

#include <unistd.h>

#include <climits>
#include <filesystem>
#include <map>
#include <utility>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/entity_json.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/library/schema.hpp"
#include "generator/frontend/outline/outline.hpp"
#include "generator/support/files/files.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/tools/commands/partial_graph.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/lsp/schema_view.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct ServeCommandOptions : LibraryOptions {
  std::string graph;
  std::optional<std::uint64_t> port;
};

Json key_json(const lsp::SchemaKey& key, const lsp::Schemas& value) {
  Json json{{"name", key.name}, {"about", key.about}, {"required", key.required}};
  json["kind"] = key.is_map ? "map" : key.is_list ? "list" : "";
  Json& values = json["values"] = Json::list();
  for (const lsp::SchemaValue& each : lsp::values_in(value))
    values.push_back(Json{{"text", each.text}, {"about", each.about}});
  return json;
}

/// The keys of an entry of each section.
Json sections_json(const Json& schema) {
  const OutlineNode nothing;
  const std::pair<const char*, OutlinePath> sections[] = {
      {"top", {}},
      {"engine", {"engine"}},
      {"objects", {"objects", "entry"}},
      {"nodes", {"nodes", "entry"}},
      {"actions", {"actions", "entry"}},
      {"observations", {"observations", "entry"}},
      {"connections", {"connections", std::size_t{0}}},
      {"render", {"render"}},
      {"agent", {"agent"}},
      {"task", {"task"}}};
  Json json = Json::object();
  for (const auto& [name, path] : sections) {
    Json& keys = json[name] = Json::list();
    for (const lsp::SchemaKey& key : lsp::keys_in(lsp::schemas_at(schema, nothing, path))) {
      OutlinePath inner = path;
      inner.emplace_back(key.name);
      keys.push_back(key_json(key, lsp::schemas_at(schema, nothing, inner)));
    }
  }
  return Json{{"sections", std::move(json)}};
}

/// The rest of eagerx-gen, as the server needs it.
class ServeWorkshop final : public serve::Workshop {
 public:
  explicit ServeWorkshop(LibraryOptions options) : options_(std::move(options)) {}

  Checked check(const std::string& path, const std::string& text) override {
    Run run;
    GraphOptions options;
    static_cast<LibraryOptions&>(options) = options_;
    options.graph = path;
    forget_files();  // every check is a run of its own
    const bool good = check_text(run, options, text);
    run.diagnostics.drop_repeats();
    run.diagnostics.sort_by_place();
    std::optional<Json> page;
    if (good) page = page_of_run(run);
    return {std::move(run.sources), std::move(run.diagnostics), std::move(page)};
  }

  std::optional<std::string> page(const Json& data, std::string& problem) override {
    Diagnostics diagnostics;
    const PageForm form{{"edit_view.mjs", "edit_loop.mjs", "main.mjs"}, true, true};
    const std::string folder = (fs::path(data_root()) / "templates" / "page").string();
    auto text = page_of(folder, form, data, diagnostics);
    if (!text && !diagnostics.all().empty()) problem = diagnostics.all().front().message;
    return text;
  }

  Json library(const std::string& path, const std::string& text) override {
    Run run;
    load(run, with_folders_of(options_, path, text));
    return library_json(run.library);
  }
  Json schema(const std::string& path, const std::string& text) override {
    Run run;
    load(run, with_folders_of(options_, path, text));
    return sections_json(graph_schema(run.library));
  }

  [[nodiscard]] std::string http_module() const override {
    return helper_program("eagerx-http.so");
  }
  [[nodiscard]] std::vector<std::string> self() const override {
    std::error_code error;
    std::vector<std::string> words = {fs::read_symlink("/proc/self/exe", error).string()};
    for (const std::string& folder : options_.paths) {
      words.emplace_back("--path");
      words.push_back(absolute_path(folder).string());
    }
    return words;
  }

 private:
  static Json page_of_run(const Run& run) {
    Diagnostics of_budget;  // which have been reported
    const PlanInfo info = info_of(*run.plan, run.spec->budget, of_budget);
    PageContents contents;
    contents.spec = &*run.spec;
    contents.policies = &run.policies;
    contents.info = &info;
    contents.sources = &run.sources;
    contents.diagnostics = &run.diagnostics;
    return page_json(contents);
  }

  const LibraryOptions options_;
};

int perform(const ServeCommandOptions& options) {
  ServeWorkshop workshop(options);
  return serve::serve(workshop, {options.graph, static_cast<int>(options.port.value_or(0))});
}

Command table(ServeCommandOptions& options) {
  constexpr std::uint64_t kFirstPort = 1, kLastPort = 65535;
  return {
      .name = "serve",
      .about = "edit, run and train a graph in a browser",
      .examples = {{"open the printed address; the file need not exist",
                    "eagerx-gen serve pendulum.yaml"},
                   {"with your own entities, at a fixed port",
                    "eagerx-gen serve pendulum.yaml --path my_models --port 8080"}},
      .arguments = {required(reads(text("graph", options.graph, "file to change", "GRAPH.yaml"))),
                    whole("--port", options.port, "port on 127.0.0.1 (default: a free one)",
                          kFirstPort, kLastPort),
                    library(options)},
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command serve_command() {
  return with_options<ServeCommandOptions>(table);
}

}  // namespace eagerx::gen
