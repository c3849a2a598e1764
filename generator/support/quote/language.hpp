// Values in templates: their quoting depends on their place in the language.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen {

enum class Language { cpp, cmake, yaml, json, shell, linker_script, other };

/// By the name of the file that is written.
Language language_of(std::string_view path);

/// Walks through a text and puts values into it.
///
/// In a comment or a string, a value is text, and is escaped. Elsewhere it is code, and must be
/// valid: balanced C++ without comments, one argument of CMake, one word of a shell, a plain word
/// in other languages.
class Quoter {
 public:
  explicit Quoter(Language language) : language_(language) {}

  /// The text of the template.
  void add(std::string_view text);
  /// False if the value is invalid there.
  bool add_value(std::string_view value);
  [[nodiscard]] std::string take() { return std::move(result_); }

 private:
  enum class Where {
    code,
    line_comment,
    block_comment,
    string,     // between double quotes
    character,  // between single quotes
    raw,        // CMake's [[ ]], C++'s R"( )": nothing can be escaped
  };

  [[nodiscard]] std::size_t plain_prefix(std::string_view text) const;
  void step(char c);
  void step_code(char c);
  [[nodiscard]] bool has_line_comments_with(char c, char before) const;
  [[nodiscard]] std::optional<std::string> text_for(std::string_view value) const;
  [[nodiscard]] std::optional<std::string> code_for(std::string_view value) const;

  Language language_;
  Where where_ = Where::code;
  bool escaped_ = false;   // the character before was a backslash that means the next one
  std::string raw_end_;    // what ends a raw text
  std::string raw_begin_;  // of C++, until its parenthesis
  std::string result_;
};

}  // namespace eagerx::gen
