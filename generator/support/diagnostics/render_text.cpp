#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/excerpt.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

/// Terminal escape sequences (ECMA-48), or nothing at all.
struct Palette {
  std::string_view error;
  std::string_view warning;
  std::string_view note;
  std::string_view help;
  std::string_view gutter;
  std::string_view bold;
  std::string_view off;
};

constexpr Palette kPlain = {};
constexpr Palette kColored = {"\x1b[1;31m", "\x1b[1;33m", "\x1b[1;32m", "\x1b[1;36m",
                              "\x1b[1;34m", "\x1b[1m",    "\x1b[0m"};

bool has_place(const Span& span) {
  return span.file != FileId::none;
}

/// Help and notes may have several lines; the others are indented to the first.
std::string indent_lines(std::string_view text, std::size_t indent) {
  std::string result;
  while (true) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += escape_unprintable(text.substr(0, end));
    if (end == text.size()) return result;
    result += '\n';
    result.append(indent, ' ');
    text.remove_prefix(end + 1);
  }
}

// Errors, and as many warnings and notes: more are of no use, and a file that is no graph may have
// hundreds of thousands.
constexpr std::size_t kMostShown = 100;

class TextRenderer {
 public:
  TextRenderer(const SourceMap& sources, bool color)
      : sources_(sources), palette_(color ? kColored : kPlain) {}

  void leave_out(std::size_t count) {
    if (count > 0) text_ += fmt::format("and {} more\n\n", count);
  }

  void add(const Diagnostic& diagnostic) {
    const auto [word, color] = heading(diagnostic.severity);
    gutter_ = gutter_width(diagnostic);
    text_ += fmt::format("{}{}", color, word);
    if (!diagnostic.code.empty()) text_ += fmt::format("[{}]", diagnostic.code);
    text_ += fmt::format("{}{}: {}{}\n", palette_.off, palette_.bold,
                         escape_unprintable(diagnostic.message), palette_.off);
    add_place(diagnostic.span);
    add_excerpt(diagnostic.span, diagnostic.label, color);
    for (const Diagnostic::Note& note : notes_with_uses(diagnostic, sources_)) add_note(note);
    if (!diagnostic.help.empty()) {
      constexpr std::size_t kIndent = 6;  // under the text after "help: "
      text_ += fmt::format("{}help{}: {}\n", palette_.help, palette_.off,
                           indent_lines(diagnostic.help.text, kIndent));
    }
    text_ += '\n';
  }

  std::string finish(std::size_t errors, std::size_t warnings) {
    if (errors == 0 && warnings == 0) return std::move(text_);
    if (errors > 0) text_ += counted(errors, "error");
    if (errors > 0 && warnings > 0) text_ += ", ";
    if (warnings > 0) text_ += counted(warnings, "warning");
    text_ += '\n';
    return std::move(text_);
  }

 private:
  [[nodiscard]] std::pair<std::string_view, std::string_view> heading(Severity severity) const {
    if (severity == Severity::error) return {"error", palette_.error};
    if (severity == Severity::warning) return {"warning", palette_.warning};
    return {"note", palette_.note};
  }

  [[nodiscard]] bool has_excerpt(const Span& span) const {
    return has_place(span) && span.line > 0 && !sources_.line(span.file, span.line).empty();
  }

  [[nodiscard]] std::size_t gutter_width(const Diagnostic& diagnostic) const {
    std::uint32_t line = has_excerpt(diagnostic.span) ? diagnostic.span.line : 0;
    for (const Diagnostic::Note& note : diagnostic.notes) {
      if (!note.label.empty() && has_excerpt(note.span)) line = std::max(line, note.span.line);
    }
    return fmt::format("{}", line).size();
  }

  void add_place(const Span& span) {
    if (!has_place(span)) return;
    text_ += fmt::format("{:{}}{}-->{} {}", "", gutter_, palette_.gutter, palette_.off,
                         escape_unprintable(sources_.name(span.file)));
    if (span.line > 0) text_ += fmt::format(":{}:{}", span.line, std::max(span.column, 1U));
    text_ += '\n';
  }

  void add_excerpt(const Span& span, const std::string& label, std::string_view color) {
    if (!has_excerpt(span)) return;
    const Excerpt excerpt =
        make_excerpt(sources_.line(span.file, span.line), span.column, span.length);
    text_ += fmt::format("{:{}} {}|{}\n", "", gutter_, palette_.gutter, palette_.off);
    text_ += fmt::format("{}{:>{}} |{} {}\n", palette_.gutter, span.line, gutter_, palette_.off,
                         excerpt.text);
    text_ += fmt::format("{:{}} {}|{} {:{}}{}{:^>{}}", "", gutter_, palette_.gutter, palette_.off,
                         "", excerpt.caret_column, color, "", excerpt.caret_width);
    if (!label.empty()) text_ += fmt::format(" {}", escape_unprintable(label));
    text_ += fmt::format("{}\n", palette_.off);
  }

  /// A note shows its line only when it has something to write under it.
  void add_note(const Diagnostic::Note& note) {
    constexpr std::size_t kIndent = 6;  // under the text after "note: "
    text_ += fmt::format("{}note{}: {}\n", palette_.note, palette_.off,
                         indent_lines(note.message, kIndent));
    add_place(note.span);
    if (!note.label.empty()) add_excerpt(note.span, note.label, palette_.note);
  }

  const SourceMap& sources_;
  const Palette& palette_;
  std::string text_;
  std::size_t gutter_ = 1;  // digits of the largest line number shown
};

}  // namespace

std::string render_text(const Diagnostics& diagnostics, const SourceMap& sources, bool color) {
  TextRenderer renderer(sources, color);
  std::size_t left_out = 0;
  std::size_t shown[3] = {};  // of each severity: warnings must not hide an error
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (shown[static_cast<std::size_t>(diagnostic.severity)]++ < kMostShown)
      renderer.add(diagnostic);
    else
      ++left_out;
  }
  renderer.leave_out(left_out);
  const std::size_t errors = diagnostics.error_count();
  const auto warnings =
      std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                    [](const Diagnostic& d) { return d.severity == Severity::warning; });
  return renderer.finish(errors, static_cast<std::size_t>(warnings));
}

}  // namespace eagerx::gen
