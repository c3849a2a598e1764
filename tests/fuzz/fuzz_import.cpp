// Any bytes as a file that EAGERx saved: no crash, no endless work, and either a graph or a reason.
// An imported graph can be written, and its text means the same graph.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "generator/frontend/import/import.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace {

using namespace eagerx::gen;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

const std::string kRoot = EAGERX_SOURCE_DIR;

void require(bool holds) {
  if (!holds) std::abort();
}

const Library& library() {
  static SourceMap sources;
  static Diagnostics diagnostics;
  static const Library kLibrary = load_library(
      {{kRoot + "/models", {}}, {kRoot + "/tests/data/import/models", {}}}, sources, diagnostics);
  require(!diagnostics.has_errors());
  return kLibrary;
}

void run(const std::string& text, Diagnostics& diagnostics, SourceMap& sources) {
  ReadLimits limits;
  limits.max_values = 5000;
  const YamlValue tree =
      read_yaml_text("fuzz.yaml", text, sources, diagnostics, Tags::accept, limits);
  if (diagnostics.has_errors() || !is_saved_graph(tree)) return;
  const auto imported = import_graph(tree, "fuzz.yaml", library(), {}, diagnostics);
  require(imported.has_value() != diagnostics.has_errors());
  if (!imported) return;
  Diagnostics again;
  const YamlValue own = read_yaml_text("own.yaml", write_graph(*imported), sources, again);
  const auto spec = again.has_errors() ? std::nullopt : read_graph_spec(own, "own.yaml", again);
  require(spec.has_value() && !again.has_errors());
  Diagnostics first, second;
  require(resolve(imported->spec, library(), {}, first).has_value() ==
          resolve(*spec, library(), {}, second).has_value());
  require(first.error_count() == second.error_count());
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SourceMap sources;
  Diagnostics diagnostics;
  run(std::string(reinterpret_cast<const char*>(data), size), diagnostics, sources);
  diagnostics.sort_by_place();
  render_text(diagnostics, sources, false);
  return 0;
}
