#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <runtime/host/trace/log_file.hpp>

namespace eagerx::trace_log {
namespace {

constexpr std::array<std::string_view, 11> kDtypes = {"float32", "float64", "int8",  "int16",
                                                      "int32",   "int64",   "uint8", "uint16",
                                                      "uint32",  "uint64",  "bool"};

template <class T>
std::string as_text(std::uint64_t bits) {
  constexpr std::size_t kLongest = 32;
  std::array<char, kLongest> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value_of<T>(bits));
  return {buffer.data(), result.ptr};
}

/// Numbers in the order of their values, without a gap.
template <class Signed>
std::int64_t order(Signed bits) {
  return bits >= 0 ? bits : std::numeric_limits<Signed>::min() - bits;
}

}  // namespace

std::optional<Dtype> dtype_of(std::string_view name) {
  const auto* found = std::find(kDtypes.begin(), kDtypes.end(), name);
  if (found == kDtypes.end()) return std::nullopt;
  return static_cast<Dtype>(found - kDtypes.begin());
}

std::string_view name_of(Dtype dtype) {
  return kDtypes[static_cast<std::size_t>(dtype)];
}

std::string text_of(Dtype dtype, std::uint64_t bits) {
  switch (dtype) {
    case Dtype::float32:
      return as_text<float>(bits);
    case Dtype::float64:
      return as_text<double>(bits);
    case Dtype::uint8:
    case Dtype::uint16:
    case Dtype::uint32:
    case Dtype::uint64:
      return std::to_string(bits);
    default:
      return std::to_string(static_cast<std::int64_t>(bits));
  }
}

double number_of(Dtype dtype, std::uint64_t bits) {
  switch (dtype) {
    case Dtype::float32:
      return double{value_of<float>(bits)};
    case Dtype::float64:
      return value_of<double>(bits);
    case Dtype::uint64:
      return static_cast<double>(bits);
    default:
      return static_cast<double>(static_cast<std::int64_t>(bits));
  }
}

std::optional<std::uint64_t> distance(Dtype dtype, std::uint64_t a, std::uint64_t b) {
  const double x = number_of(dtype, a);
  const double y = number_of(dtype, b);
  if (x != x || y != y) return std::nullopt;
  std::int64_t i = static_cast<std::int64_t>(a);
  std::int64_t k = static_cast<std::int64_t>(b);
  if (dtype == Dtype::float32) {
    i = order(static_cast<std::int32_t>(a));
    k = order(static_cast<std::int32_t>(b));
  } else if (dtype == Dtype::float64) {
    i = order(static_cast<std::int64_t>(a));
    k = order(static_cast<std::int64_t>(b));
  } else if (dtype == Dtype::uint64) {
    return a < b ? b - a : a - b;
  }
  // The difference of two 64 bit numbers fits into 64 bits without a sign.
  return i < k ? static_cast<std::uint64_t>(k) - static_cast<std::uint64_t>(i)
               : static_cast<std::uint64_t>(i) - static_cast<std::uint64_t>(k);
}

std::string distance_text(Dtype dtype, std::uint64_t a, std::uint64_t b) {
  const auto steps = distance(dtype, a, b);
  if (!steps) return "one is not a number";
  const bool floating = dtype == Dtype::float32 || dtype == Dtype::float64;
  return std::to_string(*steps) + (floating ? " ulp" : "") + " apart";
}

}  // namespace eagerx::trace_log
