#include "generator/expression/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace eagerx::gen {
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

ExpressionText::ExpressionText(const YamlValue& yaml, std::string code, Diagnostics& diagnostics)
    : yaml_(yaml), text_(yaml.text), code_(std::move(code)), diagnostics_(diagnostics) {
  if (text_.size() > kLongest)
    fail(0, fmt::format("an expression has at most {} characters", kLongest));
}

std::size_t ExpressionText::place() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t'))
    ++at_;
  return at_;
}

bool ExpressionText::at_end() {
  return place() >= text_.size();
}

bool ExpressionText::peek(char c) {
  return good_ && !at_end() && text_[at_] == c;
}

bool ExpressionText::take(char c) {
  if (!peek(c)) return false;
  ++at_;
  return true;
}

void ExpressionText::require(char c) {
  if (!take(c)) fail(place(), fmt::format("expected `{}`, found {}", c, next()));
}

bool ExpressionText::take_word(std::string_view word) {
  const std::size_t begin = at_;
  if (take_name() == word) return true;
  at_ = begin;
  return false;
}

std::string ExpressionText::take_name() {
  const std::size_t begin = place();
  if (!good_ || at_end() || !is_letter(text_[at_])) return {};
  while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string ExpressionText::take_dotted_name() {
  std::string name = take_name();
  const bool goes_on =
      !name.empty() && at_ + 1 < text_.size() && text_[at_] == '.' && is_letter(text_[at_ + 1]);
  if (!goes_on) return name;
  ++at_;
  return name + "." + take_name();
}

std::string ExpressionText::take_number() {
  const std::size_t begin = place();
  if (!good_ || at_end() || (!is_digit(text_[at_]) && text_[at_] != '.')) return {};
  const auto belongs = [&](char c) {
    const bool exponent = at_ > begin && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
    return is_digit(c) || is_letter(c) || c == '.' || (exponent && (c == '+' || c == '-'));
  };
  while (at_ < text_.size() && belongs(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::optional<Tree> ExpressionText::take_comparison() {
  for (const auto& [text, op] : kComparisons) {
    if (!good_ || std::string_view(text_).substr(place(), text.size()) != text) continue;
    at_ += text.size();
    return op;
  }
  return std::nullopt;
}

std::string ExpressionText::next() {
  if (at_end()) return "the end";
  std::size_t end = at_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  constexpr unsigned kContinued = 0x80;  // a byte of a character that takes several
  constexpr unsigned kContinuedMask = 0xc0;
  while (end == at_ || (end < text_.size() &&
                        (static_cast<unsigned char>(text_[end]) & kContinuedMask) == kContinued))
    ++end;
  return fmt::format("`{}`", text_.substr(at_, end - at_));
}

void ExpressionText::fail(std::size_t place, std::string message, std::string help) {
  if (!good_) return;
  good_ = false;
  auto& problem = diagnostics_.error(code_, span_at(place), std::move(message));
  problem.help = std::move(help);
}

ExpressionText::Nested::Nested(ExpressionText& text) : text_(text) {
  if (++text_.depth_ > kDeepest) text_.fail(text_.at_, "nested too deeply");
}

/// From `place` to the end of the text; all of it where it was written with escapes or over several
/// lines.
Span ExpressionText::span_at(std::size_t place) const {
  const std::size_t quotes = yaml_.quoted ? 2 : 0;
  if (yaml_.span.length != text_.size() + quotes) return yaml_.span;
  Span span = yaml_.span;
  span.column += static_cast<std::uint32_t>(place + quotes / 2);
  span.length = static_cast<std::uint32_t>(std::max<std::size_t>(text_.size() - place, 1));
  return span;
}

}  // namespace eagerx::gen
