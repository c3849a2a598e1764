// Any bytes as a graph file, all the way to generated code in memory: no crash, no endless work,
// and either files or a reason.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>

#include "generator/backend/emit/emit.hpp"
#include "generator/frontend/compose/compose.hpp"
#include "generator/frontend/compose/flat_text.hpp"
#include "generator/frontend/compose/variants.hpp"
#include "generator/graph/plan/plan.hpp"

namespace {

using namespace eagerx::gen;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

const std::string kRoot = EAGERX_SOURCE_DIR;

void require(bool holds) {
  if (!holds) std::abort();
}

/// With the texts of its manifests: places in composites are places in these.
struct Loaded {
  SourceMap sources;
  Library library;
};

const Loaded& loaded() {
  static const Loaded kLoaded = [] {
    Loaded made;
    Diagnostics diagnostics;
    made.library = load_library({{kRoot + "/models", {}},
                                 {kRoot + "/targets", {}},
                                 {kRoot + "/tests/data/library", {}},
                                 {kRoot + "/tests/compose/entities", {}}},
                                made.sources, diagnostics);
    require(!diagnostics.has_errors());
    return made;
  }();
  return kLoaded;
}

const Library& library() {
  return loaded().library;
}

/// A gigabyte of text is what was asked for, but no test of the generator.
bool is_large(const Plan& plan) {
  std::uint64_t elements = 0;
  for (const auto& ring : plan.rings) elements += ring.space.size();
  return elements > 100'000;
}

void emit_all(const Plan& plan, Diagnostics& diagnostics) {
  EmitOptions options;
  options.templates = kRoot + "/templates";
  options.targets = {&library().targets.at("linux-sim")};
  options.version = "0.1.0";
  options.builtin_root = kRoot;
  options.output = "/out";
  const auto files = emit(plan, std::nullopt, {}, options, diagnostics);
  require(files.has_value() && !diagnostics.has_errors());
  std::set<std::string> paths;
  for (const auto& file : *files) {
    require(!file.text.empty() && paths.insert(file.path).second);
    require(file.path.find("..") == std::string::npos && file.path.front() != '/');
  }
}

void run(const std::string& text, Diagnostics& diagnostics, SourceMap& sources) {
  ReadLimits limits;
  limits.max_values = 5000;
  const YamlValue tree =
      read_yaml_text("fuzz.yaml", text, sources, diagnostics, Tags::refuse, limits);
  if (diagnostics.has_errors()) return;
  // Other files are not read here.
  const bool extends = text.find("extends") != std::string::npos;
  const YamlValue chosen =
      extends ? tree : choose_variant(tree, "fuzz.yaml", "a", sources, diagnostics);
  const FlatGraph flat = compose(chosen, library(), sources, diagnostics);
  flat_text(flat.root, sources);
  const auto spec = read_graph_spec(flat.root, "fuzz.yaml", diagnostics, flat.form);
  require(spec.has_value() || diagnostics.has_errors());
  if (!spec) return;
  const auto graph = resolve(*spec, library(), {}, diagnostics);
  require(graph.has_value() != diagnostics.has_errors());
  if (!graph) return;
  const auto plan = make_plan(*graph, diagnostics);
  require(plan.has_value() != diagnostics.has_errors());
  if (plan && graph->agent.kind != AgentSpec::Kind::policy && !is_large(*plan))
    emit_all(*plan, diagnostics);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SourceMap sources = loaded().sources;
  Diagnostics diagnostics;
  run(std::string(reinterpret_cast<const char*>(data), size), diagnostics, sources);
  diagnostics.sort_by_place();
  for (const auto& problem : diagnostics.all())
    require(!problem.code.empty() && !problem.message.empty());
  render_text(diagnostics, sources, false);
  return 0;
}
