#include "generator/support/diagnostics/diagnostics.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

Diagnostic make(Severity severity, std::string code, Span span, std::string message) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = std::move(code);
  diagnostic.message = std::move(message);
  diagnostic.span = span;
  return diagnostic;
}

}  // namespace

Diagnostic& Diagnostics::error(std::string code, Span span, std::string message) {
  ++errors_;
  return all_.emplace_back(make(Severity::error, std::move(code), span, std::move(message)));
}

Diagnostic& Diagnostics::warning(std::string code, Span span, std::string message) {
  return all_.emplace_back(make(Severity::warning, std::move(code), span, std::move(message)));
}

Diagnostic& Diagnostics::note(Span span, std::string message) {
  return all_.emplace_back(make(Severity::note, "", span, std::move(message)));
}

void Diagnostics::take(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  if (diagnostic.io) ++io_errors_;
  if (diagnostic.usage) ++usage_errors_;
  all_.push_back(std::move(diagnostic));
}

void Diagnostics::drop_repeats() {
  std::set<std::tuple<std::string, FileId, std::uint32_t, std::uint32_t, std::string>> seen;
  std::erase_if(all_, [&](const Diagnostic& d) {
    const bool repeated =
        d.span.line > 0 &&
        !seen.emplace(d.code, d.span.file, d.span.line, d.span.column, d.message).second;
    if (repeated && d.severity == Severity::error) --errors_;
    return repeated;
  });
}

void Diagnostics::drop_notes() {
  std::erase_if(all_, [](const Diagnostic& d) { return d.severity == Severity::note; });
}

void Diagnostics::drop_warnings(const std::vector<std::string>& codes) {
  std::erase_if(all_, [&](const Diagnostic& d) {
    return d.severity == Severity::warning && ranges::contains(codes, d.code);
  });
}

void Diagnostics::raise_warnings() {
  for (Diagnostic& diagnostic : all_) {
    if (diagnostic.severity != Severity::warning) continue;
    diagnostic.severity = Severity::error;
    ++errors_;
  }
}

Diagnostic& Diagnostics::io_error(std::string code, Span span, std::string message) {
  ++io_errors_;
  Diagnostic& diagnostic = error(std::move(code), span, std::move(message));
  diagnostic.io = true;
  return diagnostic;
}

Diagnostic& Diagnostics::usage_error(std::string code, std::string message) {
  ++usage_errors_;
  Diagnostic& diagnostic = error(std::move(code), {}, std::move(message));
  diagnostic.usage = true;
  return diagnostic;
}

void Diagnostics::sort_by_place() {
  const auto place = [](const Diagnostic& diagnostic) {
    const Span& span = diagnostic.span;
    // FileId::none becomes 0.
    return std::tuple(static_cast<std::uint32_t>(span.file) + 1U, span.line, span.column);
  };
  std::stable_sort(all_.begin(), all_.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
}

}  // namespace eagerx::gen
