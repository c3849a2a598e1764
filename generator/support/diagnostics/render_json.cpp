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

/// Edits where something is replaced; tools/edit makes such of all others.
Json to_json(const Fix& fix, const Diagnostic& diagnostic, const SourceMap& sources) {
  Json edits = Json::list();
  for (const FixEdit& edit : fix.edits) {
    if (edit.kind != FixEdit::Kind::replace) continue;
    const Span& span = edit.span.file == FileId::none ? diagnostic.span : edit.span;
    edits.push_back(Json{{"span", to_json(span, sources)}, {"text", edit.text}});
  }
  return Json{{"title", fix.title}, {"certain", fix.certain}, {"edits", std::move(edits)}};
}

Json to_json(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json notes = Json::list();
  for (const Diagnostic::Note& note : notes_with_uses(diagnostic, sources)) {
    notes.push_back(Json{
        {"message", note.message}, {"span", to_json(note.span, sources)}, {"label", note.label}});
  }
  Json fixes = Json::list();
  for (const Fix& fix : diagnostic.help.fixes) fixes.push_back(to_json(fix, diagnostic, sources));
  return Json{{"severity", to_string(diagnostic.severity)},
              {"code", diagnostic.code},
              {"message", diagnostic.message},
              {"span", to_json(diagnostic.span, sources)},
              {"label", diagnostic.label},
              {"notes", notes},
              {"help", diagnostic.help.text},
              {"fixes", std::move(fixes)},
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
