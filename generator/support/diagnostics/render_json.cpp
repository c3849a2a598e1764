#include <string>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

/// Object, or null where there is no place. Line 0: the whole file.
Json to_json(const Span& span, const SourceMap& sources) {
  if (span.file == FileId::none) return nullptr;
  return Json{{"file", sources.name(span.file)},
              {"line", span.line},
              {"column", span.column},
              {"length", span.length}};
}

const char* to_string(Severity severity) {
  if (severity == Severity::error) return "error";
  return severity == Severity::warning ? "warning" : "note";
}

Json to_json(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json notes = Json::list();
  for (const Diagnostic::Note& note : notes_with_uses(diagnostic, sources)) {
    notes.push_back(Json{
        {"message", note.message}, {"span", to_json(note.span, sources)}, {"label", note.label}});
  }
  return Json{{"severity", to_string(diagnostic.severity)},
              {"code", diagnostic.code},
              {"message", diagnostic.message},
              {"span", to_json(diagnostic.span, sources)},
              {"label", diagnostic.label},
              {"notes", notes},
              {"help", diagnostic.help},
              {"io", diagnostic.io}};
}

}  // namespace

std::string render_json(const Diagnostics& diagnostics, const SourceMap& sources) {
  Json result = Json::list();
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    result.push_back(to_json(diagnostic, sources));
  }
  return dump_json(result) + "\n";
}

}  // namespace eagerx::gen
