// The text of an expression, taken piece by piece from the left.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expression/expression.hpp"
#include "generator/read/tree.hpp"

namespace eagerx::gen {

/// After the first problem nothing can be taken any more, so that only that one is told of.
class ExpressionText {
 public:
  /// `code` of its problems.
  ExpressionText(const YamlValue& yaml, std::string code, Diagnostics& diagnostics);

  [[nodiscard]] bool good() const { return good_; }
  /// Blanks aside: where the next piece begins, and whether there is none.
  std::size_t place();
  bool at_end();
  bool peek(char c);
  bool take(char c);
  /// Takes `c` or reports what is there instead.
  void require(char c);
  /// Takes the name `word`.
  bool take_word(std::string_view word);
  /// Empty if the next piece is none.
  std::string take_name();
  /// "name" or "group.name"
  std::string take_dotted_name();
  /// Digits, and whatever is written together with them.
  std::string take_number();
  std::optional<Expression::Op> take_comparison();
  /// What comes next, for messages: "`name`", "the end".
  std::string next();

  /// A problem at this place.
  void fail(std::size_t place, std::string message, std::string help = {});

  /// Counts how deep a descent is, so that no text can exhaust the stack.
  struct Nested {
    explicit Nested(ExpressionText& text);
    ~Nested() { --text_.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    ExpressionText& text_;
  };

 private:
  [[nodiscard]] Span span_at(std::size_t place) const;

  const YamlValue& yaml_;
  const std::string& text_;
  std::string code_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  bool good_ = true;
};

}  // namespace eagerx::gen
