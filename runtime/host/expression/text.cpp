#include <algorithm>
#include <array>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/expression/text.hpp>
#include <utility>

namespace eagerx::expression {
namespace {

using Tree = Expression::Op;

constexpr std::size_t kLongest = 1000;  // characters
constexpr std::size_t kDeepest = 100;   // counted rules; a pair of parentheses takes three

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct Operator {
  std::string_view text;
  Tree op;
};
// The longer ones first: "<=" is not "<".
constexpr std::array<Operator, 6> kComparisons = {{{"<=", Tree::less_equal},
                                                   {">=", Tree::greater_equal},
                                                   {"==", Tree::equal},
                                                   {"!=", Tree::not_equal},
                                                   {"<", Tree::less},
                                                   {">", Tree::greater}}};

}  // namespace

Text::Text(std::string_view text) : text_(text) {
  if (text_.size() > kLongest)
    fail(0, "an expression has at most " + std::to_string(kLongest) + " characters");
}

std::size_t Text::place() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t'))
    ++at_;
  return at_;
}

bool Text::at_end() {
  return place() >= text_.size();
}

bool Text::peek(char c) {
  return good() && !at_end() && text_[at_] == c;
}

bool Text::take(char c) {
  if (!peek(c)) return false;
  ++at_;
  return true;
}

void Text::require(char c) {
  if (!take(c)) fail(place(), std::string("expected `") + c + "`, found " + next());
}

bool Text::take_word(std::string_view word) {
  const std::size_t begin = at_;
  if (take_name() == word) return true;
  at_ = begin;
  return false;
}

std::string Text::take_name() {
  const std::size_t begin = place();
  if (!good() || at_end() || !is_letter(text_[at_])) return {};
  while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
  return std::string(text_.substr(begin, at_ - begin));
}

std::string Text::take_dotted_name() {
  std::string name = take_name();
  const bool continues =
      !name.empty() && at_ + 1 < text_.size() && text_[at_] == '.' && is_letter(text_[at_ + 1]);
  if (!continues) return name;
  ++at_;
  return name + "." + take_name();
}

std::string Text::take_port_name() {
  const std::size_t begin = place();
  if (!good() || at_end() || !is_letter(text_[at_])) return {};
  bool dot = false;
  const auto belongs = [&](char c) {
    if (c != '/') return is_letter(c) || is_digit(c) || c == '.';
    const bool letter = at_ + 1 < text_.size() && is_letter(text_[at_ + 1]);
    return letter && !dot && text_.substr(begin, at_ - begin) != "time";
  };
  for (; at_ < text_.size() && belongs(text_[at_]); ++at_) dot = dot || text_[at_] == '.';
  return std::string(text_.substr(begin, at_ - begin));
}

std::string Text::take_number() {
  const std::size_t begin = place();
  if (!good() || at_end() || (!is_digit(text_[at_]) && text_[at_] != '.')) return {};
  const auto belongs = [&](char c) {
    const bool exponent = at_ > begin && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
    return is_digit(c) || is_letter(c) || c == '.' || (exponent && (c == '+' || c == '-'));
  };
  while (at_ < text_.size() && belongs(text_[at_])) ++at_;
  return std::string(text_.substr(begin, at_ - begin));
}

std::optional<Tree> Text::take_comparison() {
  for (const auto& [text, op] : kComparisons) {
    if (!good() || text_.substr(place(), text.size()) != text) continue;
    at_ += text.size();
    return op;
  }
  return std::nullopt;
}

std::string Text::next() {
  if (at_end()) return "the end";
  std::size_t end = at_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  constexpr unsigned kContinued = 0x80;  // a byte of a character that takes several
  constexpr unsigned kContinuedMask = 0xc0;
  while (end == at_ || (end < text_.size() &&
                        (static_cast<unsigned char>(text_[end]) & kContinuedMask) == kContinued))
    ++end;
  return "`" + std::string(text_.substr(at_, end - at_)) + "`";
}

void Text::fail(std::size_t place, std::string message, std::string help) {
  if (good()) problem_ = {place, std::move(message), std::move(help), {}};
}

void Text::fail_unknown(std::size_t place, std::string message, const std::string& name,
                        const std::vector<std::string>& known) {
  if (!good()) return;
  problem_ = {place, std::move(message), host::suggestion(name, known), {}};
  if (std::string near = host::nearest_name(name, known); !near.empty())
    problem_->mistyped = {name, std::move(near)};
}

Text::Nested::Nested(Text& text) : text_(text) {
  if (++text_.depth_ > kDeepest) text_.fail(text_.at_, "nested too deeply");
}

}  // namespace eagerx::expression
