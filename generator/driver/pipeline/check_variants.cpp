#include "generator/driver/pipeline/check_variants.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "generator/frontend/compose/variants.hpp"

namespace eagerx::gen {
namespace {

/// The same problem, though a file was read twice.
using Problem = std::tuple<std::string, std::string, std::string, std::uint32_t, std::uint32_t>;

Problem problem_of(const Diagnostic& each, const SourceMap& sources) {
  return {each.code, each.message, sources.name(each.span.file), each.span.line, each.span.column};
}

}  // namespace

std::size_t check_variants(Run& run, const GraphOptions& options) {
  Diagnostics again;  // files that it extends were read before
  const std::vector<std::string> variants =
      variants_of(run.written, options.graph, run.sources, again);
  std::set<Problem> known;
  for (const Diagnostic& each : run.diagnostics.all()) known.insert(problem_of(each, run.sources));
  for (const std::string& variant : variants) {
    GraphOptions chosen = options;
    chosen.variant = variant;
    Run other;
    other.sources = std::move(run.sources);
    other.written = run.written;
    make_spec(other, chosen);
    for (Diagnostic each : other.diagnostics.all()) {
      if (!known.insert(problem_of(each, other.sources)).second) continue;
      each.notes.push_back({fmt::format("with `--variant {}`", variant), {}, ""});
      run.diagnostics.take(std::move(each));
    }
    run.sources = std::move(other.sources);
  }
  return variants.size();
}

}  // namespace eagerx::gen
