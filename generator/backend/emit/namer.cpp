#include "generator/backend/emit/namer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
std::string Names::unique(const std::string& wanted) {
  const int count = ++used_[wanted];
  if (count == 1) return wanted;
  const bool member = wanted.ends_with('_');
  return unique(fmt::format("{}_{}{}", member ? wanted.substr(0, wanted.size() - 1) : wanted, count,
                            member ? "_" : ""));
}

std::string Names::unique_with(const std::string& wanted, const std::string& suffix) {
  for (;;) {
    std::string name = unique(wanted);
    if (used_.contains(name + suffix)) continue;
    unique(name + suffix);
    return name;
  }
}

std::string camel(std::string_view name) {
  std::string result;
  bool up = true;
  for (const char c : name) {
    if (c == ']') continue;
    if (c == '_' || c == '/' || c == '.' || c == '[') {
      up = true;
      continue;
    }
    result += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    up = false;
  }
  return result;
}

std::string snake(std::string_view name) {
  std::string result(name);
  std::erase(result, ']');
  std::ranges::replace_if(
      result, [](char c) { return c == '/' || c == '['; }, '_');
  return result;
}

std::string rate_suffix(const Rational& rate_hz) {
  std::string text = rate_hz.to_string();
  std::string result;
  for (const char c : text) result += c == '.' ? "p" : (c == '/' ? "over" : std::string(1, c));
  return result + "Hz";
}

std::string rate_type(const Rational& rate_hz) {
  return rate_hz.is_integer() ? fmt::format("eagerx::Rate<{}>", rate_hz.num())
                              : fmt::format("eagerx::Rate<{}, {}>", rate_hz.num(), rate_hz.den());
}

std::string_view element_type(Dtype dtype, Numbers numbers) {
  const bool simd = numbers == Numbers::simd, dual = numbers == Numbers::dual;
  switch (dtype) {
    case Dtype::float32:
      return dual ? "eagerx::Number" : simd ? "F32" : "float";
    case Dtype::float64:
      return dual ? "eagerx::Number" : simd ? "F64" : "double";
    case Dtype::boolean:
      return simd ? "Bool" : "bool";
    case Dtype::int8:
      return simd ? "I8" : "std::int8_t";
    case Dtype::int16:
      return simd ? "I16" : "std::int16_t";
    case Dtype::int32:
      return simd ? "I32" : "std::int32_t";
    case Dtype::int64:
      return simd ? "I64" : "std::int64_t";
    case Dtype::uint8:
      return simd ? "U8" : "std::uint8_t";
    case Dtype::uint16:
      return simd ? "U16" : "std::uint16_t";
    case Dtype::uint32:
      return simd ? "U32" : "std::uint32_t";
    case Dtype::uint64:
      return simd ? "U64" : "std::uint64_t";
  }
  return "";
}

std::string message_type(const Space& space, Numbers numbers) {
  const std::string_view element = element_type(space.dtype, numbers);
  return space.shape.empty()
             ? std::string(element)
             : fmt::format("eagerx::Array<{}, {}>", element, join(space.shape, ", "));
}

}  // namespace eagerx::gen
