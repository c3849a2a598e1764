// Every message to the user goes through here: code, place, other places, what to do.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/fix.hpp"
#include "generator/support/diagnostics/span.hpp"

namespace eagerx::gen {

/// The texts that spans point into. A file is added once and stays.
class SourceMap {
 public:
  /// `name` as the user wrote it; `text` may be cut off, and is only for display.
  FileId add(std::string name, std::string text);
  [[nodiscard]] const std::string& name(FileId file) const;
  [[nodiscard]] const std::string& text(FileId file) const;
  /// Line `line` (from 1) without its newline; empty if it does not exist.
  [[nodiscard]] std::string_view line(FileId file, std::uint32_t line) const;

  /// A place that uses a file's contents, and how: "`arm` is a `Cascade`".
  struct Use {
    Span place;
    std::string what;
  };
  /// Adds the same file again for one use: spans in it lead to that place.
  FileId add_use(FileId file, Use use);
  /// nullptr if no other file uses it.
  [[nodiscard]] const Use* use(FileId file) const;
  /// The place in `file` that uses the text at `span`, directly or through other files; line 0:
  /// none.
  [[nodiscard]] Span place_in(FileId file, Span span) const;

 private:
  struct File {
    std::string name;
    std::string text;
    std::vector<std::size_t> line_starts;
    FileId same = FileId::none;  // has the text
    Use use;
  };
  [[nodiscard]] const File* file(FileId id) const;
  std::vector<File> files_;
};

enum class Severity : std::uint8_t { error, warning, note };

/// One problem. `code` is stable ("E0201", "W0101"), `message` lower case with `identifiers` in
/// backticks.
struct Diagnostic {
  struct Note {
    std::string message;
    Span span;          // file == none: no place
    std::string label;  // text under the carets
  };

  Severity severity = Severity::error;
  std::string code;
  std::string message;
  Span span;
  std::string label;
  std::vector<Note> notes;
  Help help;
  bool io = false;     // true: could not read or write (exit code 3)
  bool usage = false;  // true: the command line is wrong (exit code 2)
};

/// All problems of a run, in the order found.
class Diagnostics {
 public:
  /// Adds an error and returns it, so that label, notes and help can be set.
  Diagnostic& error(std::string code, Span span, std::string message);
  Diagnostic& warning(std::string code, Span span, std::string message);
  /// A decision made for the user; no problem.
  Diagnostic& note(Span span, std::string message);
  /// An error of reading or writing.
  Diagnostic& io_error(std::string code, Span span, std::string message);
  /// An error of the command line that only shows once files are read.
  Diagnostic& usage_error(std::string code, std::string message);

  /// One that was found elsewhere.
  void take(Diagnostic diagnostic);

  /// Problems in the order of the file they are in, those without a place first.
  void sort_by_place();

  /// Of the same problem at the same place, which several elements of an array have, leaves one.
  void drop_repeats();

  /// Leaves only errors and warnings.
  void drop_notes();

  /// Leaves out warnings with these codes.
  void drop_warnings(const std::vector<std::string>& codes);

  /// Makes errors of all warnings.
  void raise_warnings();

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] bool has_io_errors() const { return io_errors_ > 0; }
  [[nodiscard]] bool has_usage_errors() const { return usage_errors_ > 0; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  [[nodiscard]] std::vector<Diagnostic>& all() { return all_; }

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
  std::size_t io_errors_ = 0;
  std::size_t usage_errors_ = 0;
};

/// The notes of a diagnostic, followed by the uses of its file, from the inside out.
std::vector<Diagnostic::Note> notes_with_uses(const Diagnostic& diagnostic,
                                              const SourceMap& sources);

/// As rustc prints them; `color` adds terminal colours. Ends with a line that counts the errors. Of
/// each severity the first hundred are shown.
std::string render_text(const Diagnostics& diagnostics, const SourceMap& sources, bool color);
/// One JSON array, one object a diagnostic.
std::string render_json(const Diagnostics& diagnostics, const SourceMap& sources);

}  // namespace eagerx::gen
