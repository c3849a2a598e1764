#include "generator/policy/formats/torchscript/syntax.hpp"

#include <fmt/core.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/policy/formats/torchscript/tokens.hpp"

namespace eagerx::gen {
namespace {

using Form = TorchExpression::Kind;
using Token = TorchToken;

constexpr int kDeepest = 60;

class Parser {
 public:
  Parser(std::vector<Token> tokens, const std::string& file, PolicyProblem& problem)
      : tokens_(std::move(tokens)), file_(file), problem_(problem) {}

  std::optional<TorchFunctions> run() {
    std::string owner;
    while (now().kind != Token::Kind::end) {
      const int indent = now().indent;
      if (indent == 0) owner.clear();
      if (now().text == "class" && indent == 0) {
        next();
        owner = std::string(now().text) + ".";
        skip_line();
      } else if (now().text == "def") {
        if (!function(owner, indent)) return std::nullopt;
      } else {
        skip_line();  // types and annotations of members
      }
    }
    return std::move(functions_);
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  void next() {
    if (at_ + 1 < tokens_.size()) ++at_;
  }
  bool is(std::string_view text) const {
    return now().kind == Token::Kind::sign && now().text == text;
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    next();
    return true;
  }
  Refused fail(const std::string& what) {
    return refuse(problem_, "E0753",
                  fmt::format("has code that is not understood: {} (line {} of {})", what,
                              now().line, printable(file_)),
                  "export the actor to ONNX with `torch.onnx.export`");
  }
  bool want(std::string_view text) {
    return take(text) || fail(fmt::format("`{}` is expected before `{}`", text,
                                          printable(std::string(now().text))));
  }
  bool at_line_end() const { return now().first_of_line || now().kind == Token::Kind::end; }
  void skip_line() {
    do next();
    while (!at_line_end());
  }

  bool function(const std::string& owner, int indent) {
    TorchFunction made;
    made.file = file_;
    made.line = now().line;
    next();
    const std::string name = owner + std::string(now().text);
    next();
    if (!want("(")) return false;
    while (!is(")")) {
      TorchFunction::Parameter parameter{std::string(now().text)};
      next();
      if (take(":") && !type(parameter.type)) return false;
      if (take("=")) {
        parameter.otherwise = TorchExpression();
        if (!expression(*parameter.otherwise, 0)) return false;
      }
      made.parameters.push_back(std::move(parameter));
      if (!take(",") && !is(")")) return fail("a parameter does not end");
    }
    next();
    std::string result;
    if (take("->") && !type(result)) return false;
    if (!want(":") || !block(made.body, indent, 0)) return false;
    if (!functions_.emplace(name, std::move(made)).second) return fail("a function comes twice");
    return true;
  }
  /// A type, up to what follows it.
  bool type(std::string& text) {
    int depth = 0;
    while (now().kind != Token::Kind::end) {
      if (depth == 0 && (is(",") || is("=") || is(")") || is(":"))) return true;
      if (is("[") || is("(")) ++depth;
      if (is("]") || is(")")) --depth;
      text += now().text;
      next();
    }
    return fail("a type does not end");
  }

  bool block(std::vector<TorchStatement>& body, int outer, int depth) {
    if (depth > kDeepest) return fail("blocks are nested too deeply");
    const int indent = now().indent;
    if (!at_line_end() || indent <= outer) return fail("a block is empty");
    while (now().kind != Token::Kind::end && now().indent == indent) {
      body.emplace_back();
      if (!statement(body.back(), indent, depth)) return false;
      if (!at_line_end()) return fail("a line does not end");
    }
    return now().kind == Token::Kind::end || now().indent < indent || fail("an indent is odd");
  }

  bool statement(TorchStatement& made, int indent, int depth) {
    using Act = TorchStatement::Kind;
    made.line = now().line;
    const std::string_view word = now().text;
    if (now().kind == Token::Kind::name) {
      if (word == "pass") {
        next();
        return true;
      }
      if (word == "return") {
        next();
        made.kind = Act::give;
        return expression(made.value, 0);
      }
      if (word == "if") return choice(made, indent, depth);
      for (const char* unknown :
           {"for", "while", "with", "assert", "raise", "del", "break", "continue", "def"}) {
        if (word != unknown) continue;
        made.kind = Act::other;
        made.text = unknown;
        skip_line();
        while (now().kind != Token::Kind::end && now().indent > indent) skip_line();
        return true;
      }
    }
    if (!expression(made.value, 0)) return false;
    std::vector<TorchExpression> targets = {made.value};
    while (take(",")) {
      if (is("=")) break;
      targets.emplace_back();
      if (!expression(targets.back(), 0)) return false;
    }
    const bool typed = take(":");
    std::string ignored;
    if (typed && !type(ignored)) return false;
    if (!take("=")) {
      made.kind = Act::compute;
      return targets.size() == 1 && !typed ? true : fail("a list of values has no meaning");
    }
    made.kind = Act::assign;
    for (const TorchExpression& target : targets) {
      if (target.kind != Form::name && target.kind != Form::attribute) {
        return fail("what is assigned to is not a name");
      }
    }
    made.targets = std::move(targets);
    if (!expression(made.value, 0)) return false;
    if (!is(",")) return true;
    TorchExpression tuple{Form::tuple};
    tuple.parts.push_back(std::move(made.value));
    while (take(",")) {
      if (at_line_end()) break;
      tuple.parts.emplace_back();
      if (!expression(tuple.parts.back(), 0)) return false;
    }
    made.value = std::move(tuple);
    return true;
  }

  bool choice(TorchStatement& made, int indent, int depth) {
    next();
    made.kind = TorchStatement::Kind::choose;
    if (!expression(made.value, 0) || !want(":") || !block(made.then, indent, depth + 1)) {
      return false;
    }
    if (now().text != "else" || now().indent != indent) return true;
    next();
    return want(":") && block(made.otherwise, indent, depth + 1);
  }

  bool expression(TorchExpression& made, int depth) {
    if (depth > kDeepest) return fail("an expression is nested too deeply");
    if (!primary(made, depth)) return false;
    while (!at_line_end()) {
      TorchExpression outer;
      if (take(".")) {
        outer.kind = Form::attribute;
        outer.text = now().text;
        if (now().kind != Token::Kind::name) return fail("a name is missing");
        next();
        outer.parts.push_back(std::move(made));
      } else if (take("(")) {
        outer.kind = Form::call;
        outer.parts.push_back(std::move(made));
        if (!arguments(outer, depth)) return false;
      } else if (take("[")) {
        outer.kind = Form::subscript;
        outer.parts.push_back(std::move(made));
        outer.parts.emplace_back();
        if (!expression(outer.parts.back(), depth + 1)) return false;
        while (take(",")) {  // of a type: Tuple[Tensor, Tensor]
          if (!expression(outer.parts.back(), depth + 1)) return false;
        }
        if (!want("]")) return false;
      } else {
        break;
      }
      made = std::move(outer);
      if (++links_ > kMostLinks) return fail("an expression has too many parts");
    }
    return true;
  }
  bool arguments(TorchExpression& made, int depth) {
    while (!is(")")) {
      const bool named = now().kind == Token::Kind::name && tokens_[at_ + 1].text == "=" &&
                         tokens_[at_ + 1].kind == Token::Kind::sign;
      if (named) {
        std::string name(now().text);
        next();
        next();
        made.keywords.push_back(std::move(name));
      } else if (!made.keywords.empty()) {
        return fail("an argument without a name follows one with a name");
      }
      made.parts.emplace_back();
      if (!expression(made.parts.back(), depth + 1)) return false;
      if (!take(",") && !is(")")) return fail("an argument does not end");
    }
    next();
    return true;
  }

  bool primary(TorchExpression& made, int depth) {
    const Token token = now();
    const bool negative = is("-");
    if (negative) next();
    if (now().kind == Token::Kind::number || (negative && is_infinite())) {
      return number(made, negative);
    }
    if (negative) return fail("a number is missing");
    if (token.kind == Token::Kind::name) {
      if (is_infinite()) return number(made, false);
      made.kind = Form::name;
      made.text = token.text;
      next();
      return true;
    }
    if (token.kind == Token::Kind::text) {
      made.kind = Form::text;
      made.text = token.text;
      next();
      return true;
    }
    if (take("(")) return items(made, ")", Form::tuple, depth);
    if (take("[")) return items(made, "]", Form::list, depth);
    return fail(fmt::format("`{}` begins no expression", printable(std::string(token.text))));
  }
  bool is_infinite() const { return now().text == "inf" || now().text == "nan"; }

  /// `(x)` is x, `(x,)` a tuple.
  bool items(TorchExpression& made, const char* end, Form kind, int depth) {
    made.kind = kind;
    bool comma = false;
    while (!is(end)) {
      made.parts.emplace_back();
      if (!expression(made.parts.back(), depth + 1)) return false;
      comma = take(",");
      if (!comma && !is(end)) return fail("a list does not end");
    }
    next();
    if (kind != Form::tuple || comma || made.parts.size() != 1) return true;
    TorchExpression only = std::move(made.parts.front());
    made = std::move(only);
    return true;
  }

  bool number(TorchExpression& made, bool negative) {
    const std::string_view text = now().text;
    const char* last = text.data() + text.size();
    made.kind = Form::integer;
    const auto whole = std::from_chars(text.data(), last, made.integer);
    if (whole.ec != std::errc() || whole.ptr != last) {
      made.kind = Form::real;
      const auto real = std::from_chars(text.data(), last, made.real);
      const bool known = real.ec == std::errc() && real.ptr == last;
      if (!known) return fail("a number is not understood");
    }
    if (negative) {
      made.integer = -made.integer;
      made.real = -made.real;
    }
    next();
    return true;
  }

  static constexpr int kMostLinks = 1'000'000;
  std::vector<Token> tokens_;
  const std::string& file_;
  PolicyProblem& problem_;
  std::size_t at_ = 0;
  int links_ = 0;
  TorchFunctions functions_;
};

}  // namespace

std::optional<TorchFunctions> parse_torch_code(std::string_view text, const std::string& file,
                                               PolicyProblem& problem) {
  auto tokens = torch_tokens(text, file, problem);
  if (!tokens) return std::nullopt;
  return Parser(std::move(*tokens), file, problem).run();
}

}  // namespace eagerx::gen
