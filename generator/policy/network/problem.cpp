#include "generator/policy/network/problem.hpp"

#include <utility>

namespace eagerx::gen {

Refused refuse(PolicyProblem& problem, std::string code, std::string message, std::string help) {
  problem = {std::move(code), std::move(message), std::move(help)};
  return {};
}

std::string printable(std::string_view name) {
  constexpr std::size_t kMaxShownName = 80;
  constexpr char kFirst = ' ';
  constexpr char kLast = '~';
  std::string shown;
  for (const char c : name.substr(0, kMaxShownName)) {
    shown += c >= kFirst && c <= kLast && c != '`' ? c : '?';
  }
  if (name.size() > kMaxShownName) shown += "...";
  return shown;
}

}  // namespace eagerx::gen
