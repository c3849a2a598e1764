#include "generator/support/diagnostics/join.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace eagerx::gen {
namespace {

template <class Items>
std::string join_items(const Items& items, std::string_view separator) {
  return fmt::format("{}", fmt::join(items, separator));
}

}  // namespace

std::string join(std::span<const std::string> items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(std::span<const std::string_view> items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(std::span<const char* const> items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(const std::set<std::string>& items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(std::span<const std::int64_t> items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(std::span<const std::size_t> items, std::string_view separator) {
  return join_items(items, separator);
}

std::string join(std::span<const std::uint32_t> items, std::string_view separator) {
  return join_items(items, separator);
}

// fmt would compile its writing of floating-point numbers here, which its library has.
std::string join(std::span<const double> items, std::string_view separator) {
  std::vector<std::string> texts;
  for (const double item : items) texts.push_back(fmt::format("{}", item));
  return join(texts, separator);
}

}  // namespace eagerx::gen
