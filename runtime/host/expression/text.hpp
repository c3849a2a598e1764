// The text of an expression, taken piece by piece from the left.
#pragma once

#include <cstddef>
#include <optional>
#include <runtime/host/expression/expression.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::expression {

/// A written name, and the one that was probably meant; both empty if there is none.
struct Mistyped {
  std::string name, meant;
};
/// A problem, and the byte of the text where it begins.
struct Problem {
  std::size_t place = 0;
  std::string message;
  std::string help;  // empty: nothing to say
  Mistyped mistyped = {};
};

/// After the first problem, nothing more can be read, so that only that one is reported.
class Text {
 public:
  /// `text` must outlive it. More than 1000 characters are a problem.
  explicit Text(std::string_view text);

  [[nodiscard]] bool good() const { return !problem_; }
  [[nodiscard]] const std::optional<Problem>& problem() const { return problem_; }
  /// Skips blanks: where the next token begins, and whether there is none.
  std::size_t place();
  bool at_end();
  bool peek(char c);
  bool take(char c);
  /// Takes `c`, or reports the actual token.
  void require(char c);
  /// Takes the name `word`.
  bool take_word(std::string_view word);
  /// Empty if the next piece is none.
  std::string take_name();
  /// "name" or "group.name"
  std::string take_dotted_name();
  /// "node.port", "engine/node.port": a slash before the first dot belongs to a name if a letter
  /// follows it and it does not divide `time`.
  std::string take_port_name();
  /// Digits, and the letters attached to them.
  std::string take_number();
  std::optional<Expression::Op> take_comparison();
  /// The next token, for messages: "`name`", "the end".
  std::string next();

  /// A problem at this place.
  void fail(std::size_t place, std::string message, std::string help = {});
  /// One of a name that is not among `known`.
  void fail_unknown(std::size_t place, std::string message, const std::string& name,
                    const std::vector<std::string>& known);

  /// Counts how deep a descent is, so that no text can exhaust the stack.
  struct Nested {
    explicit Nested(Text& text);
    ~Nested() { --text_.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    Text& text_;
  };

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::optional<Problem> problem_;
};

}  // namespace eagerx::expression
