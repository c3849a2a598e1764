#include "generator/policy/formats/torchscript/tokens.hpp"

#include <fmt/core.h>

#include <cctype>

namespace eagerx::gen {
namespace {

using TokenKind = TorchToken::Kind;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

class Tokenizer {
 public:
  Tokenizer(std::string_view text, const std::string& file, PolicyProblem& problem)
      : text_(text), file_(file), problem_(problem) {}

  std::optional<std::vector<TorchToken>> run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
        if (depth_ == 0) begin_line();
        ++at_;
      } else if (c == ' ' || c == '\r') {
        if (fresh_ && c == ' ') ++indent_;
        ++at_;
      } else if (c == '#') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (!token(c)) {
        return std::nullopt;
      }
    }
    begin_line();
    add(TokenKind::end, 0);
    return std::move(tokens_);
  }

 private:
  void begin_line() {
    fresh_ = true;
    indent_ = 0;
  }
  void add(TokenKind kind, std::size_t length) {
    tokens_.push_back({kind, text_.substr(at_, length), line_, indent_, fresh_});
    fresh_ = false;
    at_ += length;
  }

  bool token(char c) {
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      add(TokenKind::number, length_of_number());
      return true;
    }
    if (is_word(c)) {
      std::size_t length = 1;
      while (at_ + length < text_.size() && is_word(text_[at_ + length])) ++length;
      add(TokenKind::name, length);
      return true;
    }
    if (c == '"' || c == '\'') return string(c);
    if (text_.substr(at_, 2) == "->") {
      add(TokenKind::sign, 2);
      return true;
    }
    constexpr std::string_view kSigns = "()[]{}.,:=-";
    if (kSigns.find(c) == std::string_view::npos) return fail("a character has no meaning");
    if (c == '(' || c == '[' || c == '{') ++depth_;
    if ((c == ')' || c == ']' || c == '}') && depth_ > 0) --depth_;
    add(TokenKind::sign, 1);
    return true;
  }
  std::size_t length_of_number() const {
    std::size_t length = 1;
    while (at_ + length < text_.size()) {
      const char c = text_[at_ + length];
      const char before = text_[at_ + length - 1];
      const bool sign = (c == '-' || c == '+') && (before == 'e' || before == 'E');
      if (!is_word(c) && c != '.' && !sign) break;
      ++length;
    }
    return length;
  }
  bool string(char quote) {
    ++at_;
    std::size_t length = 0;
    while (at_ + length < text_.size() && text_[at_ + length] != quote) {
      if (text_[at_ + length] == '\n') return fail("a text does not end");
      length += text_[at_ + length] == '\\' ? 2U : 1U;
    }
    if (at_ + length >= text_.size()) return fail("a text does not end");
    add(TokenKind::text, length);
    ++at_;
    return true;
  }

  Refused fail(const char* what) {
    return refuse(problem_, "E0753",
                  fmt::format("has code that is not understood: {} (line {} of {})", what, line_,
                              printable(file_)),
                  "the file is damaged: export the actor again");
  }

  std::string_view text_;
  const std::string& file_;
  PolicyProblem& problem_;
  std::vector<TorchToken> tokens_;
  std::size_t at_ = 0;
  int line_ = 1, indent_ = 0, depth_ = 0;
  bool fresh_ = true;
};

}  // namespace

std::optional<std::vector<TorchToken>> torch_tokens(std::string_view text, const std::string& file,
                                                    PolicyProblem& problem) {
  return Tokenizer(text, file, problem).run();
}

}  // namespace eagerx::gen
