#include "generator/diagnostics/diagnostics.hpp"

#include <utility>

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

Diagnostic& Diagnostics::io_error(std::string code, Span span, std::string message) {
  ++io_errors_;
  Diagnostic& diagnostic = error(std::move(code), span, std::move(message));
  diagnostic.io = true;
  return diagnostic;
}

}  // namespace eagerx::gen
