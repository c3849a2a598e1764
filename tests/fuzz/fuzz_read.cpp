// Any bytes as a YAML file: no crash, no endless work, and spans that point into the text.
//
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I. tests/fuzz/fuzz_read.cpp
//       generator/frontend/read/*.cpp generator/support/diagnostics/*.cpp -lyaml-cpp -lfmt -o
//       fuzz_read
//   ./fuzz_read -max_len=4096 -timeout=5 -dict=tests/fuzz/yaml.dict corpus/ tests/data/read/
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace {

using eagerx::gen::Diagnostic;
using eagerx::gen::Diagnostics;
using eagerx::gen::FileId;
using eagerx::gen::Rational;
using eagerx::gen::ReadLimits;
using eagerx::gen::SourceMap;
using eagerx::gen::Span;
using eagerx::gen::Tags;
using eagerx::gen::YamlValue;

void require(bool holds) {
  if (!holds) std::abort();
}

void check_span(const Span& span, const SourceMap& sources) {
  if (span.file == FileId::none || span.line == 0) return;
  const std::string_view line = sources.line(span.file, span.line);
  const std::size_t length = eagerx::gen::count_code_points(line);
  require(span.column >= 1 && span.length >= 1);
  require(span.column <= length + 1);
  require(span.column + span.length <= length + 2);  // at most one past the end
}

void check_scalar(const std::string& text) {
  const auto rational = Rational::parse(text);
  if (rational) require(Rational::parse(rational->to_string()) == rational);
  const auto whole = eagerx::gen::parse_int(text);
  if (whole) require(rational == Rational(*whole) && eagerx::gen::parse_number(text).has_value());
}

void check_node(const YamlValue& node, const SourceMap& sources) {
  require(node.span.file != FileId::none);
  check_span(node.span, sources);
  if (node.is_scalar()) check_scalar(node.text);
  for (const YamlValue& item : node.items) check_node(item, sources);
  for (const YamlValue::Entry& entry : node.entries) {
    check_span(entry.key_span, sources);
    check_node(entry.value, sources);
    require(node.find(entry.key) == &entry.value);  // no duplicate keys
  }
}

void read(const std::string& text, Tags tags) {
  ReadLimits limits;
  limits.max_values = 2000;
  limits.max_bytes = 1U << 16U;
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue root =
      eagerx::gen::read_yaml_text("fuzz.yaml", text, sources, diagnostics, tags, limits);
  require(root.is_null() == diagnostics.has_errors());
  if (!root.is_null()) check_node(root, sources);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    require(diagnostic.code.starts_with("E01") && !diagnostic.message.empty());
    check_span(diagnostic.span, sources);
    for (const Diagnostic::Note& note : diagnostic.notes) check_span(note.span, sources);
  }
  render_text(diagnostics, sources, true);
  render_json(diagnostics, sources);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_scalar(text);
  read(text, Tags::refuse);
  read(text, Tags::accept);
  return 0;
}
