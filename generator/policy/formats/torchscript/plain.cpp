// Computations on known numbers and shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "generator/policy/formats/torchscript/interpreter.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Plain = std::optional<TorchValue>;
using Arguments = std::vector<TorchValue>;
using What = TorchValue::Kind;

constexpr std::int64_t kFloat32 = 6;  // torch's number of the type
constexpr std::int64_t kLargestInteger = std::int64_t{1} << 40U;

bool same_value(const TorchValue& a, const TorchValue& b) {
  if (a.number() && b.number()) return *a.number() == *b.number();
  if (a.kind != b.kind || a.integer != b.integer || a.text != b.text) return false;
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same_value);
}

bool is_known(const TorchValue& value) {
  if (value.kind == What::sequence) return ranges::all_of(value.items, is_known);
  return value.kind != What::unknown && value.kind != What::tensor;
}

Plain compared(const std::string& name, const TorchValue& a, const TorchValue& b) {
  if (!is_known(a) || !is_known(b)) return std::nullopt;
  if (name == "eq") return TorchValue::of(same_value(a, b));
  if (name == "ne") return TorchValue::of(!same_value(a, b));
  const auto x = a.number();
  const auto y = b.number();
  if (!x || !y) return std::nullopt;
  if (name == "lt") return TorchValue::of(*x < *y);
  if (name == "le") return TorchValue::of(*x <= *y);
  if (name == "gt") return TorchValue::of(*x > *y);
  return TorchValue::of(*x >= *y);
}

Plain calculated(const std::string& name, const TorchValue& a, const TorchValue& b) {
  if (name == "add" && a.kind == What::sequence && b.kind == What::sequence) {
    Arguments all = a.items;
    all.insert(all.end(), b.items.begin(), b.items.end());
    return TorchValue::of(std::move(all));
  }
  if (a.kind == What::integer && b.kind == What::integer && name != "div") {
    const std::int64_t x = a.integer;
    const std::int64_t y = b.integer;
    if (std::abs(x) > kLargestInteger || std::abs(y) > kLargestInteger) return std::nullopt;
    if (name == "add") return TorchValue::of(x + y);
    if (name == "sub") return TorchValue::of(x - y);
    if (name == "mul" && std::abs(static_cast<double>(x) * static_cast<double>(y)) < 1e12) {
      return TorchValue::of(x * y);
    }
    if (name == "floordiv" && y > 0 && x >= 0) return TorchValue::of(x / y);
    if (name == "remainder" && y > 0 && x >= 0) return TorchValue::of(x % y);
    return std::nullopt;
  }
  const auto x = a.number();
  const auto y = b.number();
  if (!x || !y) return std::nullopt;
  if (name == "add") return TorchValue::of(*x + *y);
  if (name == "sub") return TorchValue::of(*x - *y);
  if (name == "mul") return TorchValue::of(*x * *y);
  if (name == "div" && *y != 0.0) return TorchValue::of(*x / *y);
  return std::nullopt;
}

Plain of_shape(const std::string& name, const Arguments& arguments) {
  const TorchValue& first = arguments.front();
  if (!first.is_tensor()) {
    if (name == "len" && first.kind == What::sequence) {
      return TorchValue::of(static_cast<std::int64_t>(first.items.size()));
    }
    return std::nullopt;
  }
  const auto& shape = first.tensor->value.shape;
  if (!shape) return std::nullopt;
  const auto rank = static_cast<std::int64_t>(shape->size());
  if (name == "dim" || name == "ndimension") return TorchValue::of(rank);
  if (name == "numel") return TorchValue::of(element_count(*shape).value_or(0));
  const std::int64_t wanted = name == "len" ? 0 : (arguments.size() > 1 ? arguments[1].integer : 0);
  if (name == "size" && arguments.size() == 1) {
    Arguments sizes;
    for (const std::int64_t size : *shape) sizes.push_back(TorchValue::of(size));
    return TorchValue::of(std::move(sizes));
  }
  const auto axis = place_in(wanted, rank);
  if (!axis) return std::nullopt;
  return TorchValue::of((*shape)[static_cast<std::size_t>(*axis)]);
}

bool is_one_of(const std::string& name, const auto& names) {
  return ranges::contains(names, name);
}

}  // namespace

Plain run_plain_operator(const std::string& name, const Arguments& arguments) {
  constexpr std::array kComparisons = {"eq", "ne", "lt", "le", "gt", "ge"};
  constexpr std::array kSums = {"add", "sub", "mul", "div", "floordiv", "remainder"};
  constexpr std::array kShapes = {"size", "dim", "ndimension", "len", "numel"};
  if (arguments.empty()) return std::nullopt;
  const TorchValue& a = arguments[0];
  if (is_one_of(name, kShapes)) return of_shape(name, arguments);
  if (name == "__not__") {
    return a.kind == What::boolean ? Plain(TorchValue::of(a.integer == 0)) : std::nullopt;
  }
  if (name == "dtype") return TorchValue::of(kFloat32);
  if (name == "device") return TorchValue::with(What::unknown, 0);
  if (name == "is_floating_point") return TorchValue::of(true);
  if (name == "format" || name == "warn") return TorchValue::with(What::unknown, 0);
  if (name == "list" || name == "NumToTensor" || name == "ScalarImplicit" || name == "Int") {
    return is_known(a) ? Plain(a) : std::nullopt;
  }
  if (name == "neg" && a.kind == What::integer) return TorchValue::of(-a.integer);
  if (arguments.size() < 2) return std::nullopt;
  const TorchValue& b = arguments[1];
  if (name == "__contains__") {
    if (a.kind != What::sequence || !is_known(a) || !is_known(b)) return std::nullopt;
    return TorchValue::of(
        ranges::any_of(a.items, [&](const TorchValue& item) { return same_value(item, b); }));
  }
  if (name == "__is__" || name == "__isnot__") {
    if (!a.is_none() && !b.is_none()) return std::nullopt;
    return TorchValue::of((a.is_none() && b.is_none()) == (name == "__is__"));
  }
  if (name == "__and__" || name == "__or__") {
    if (a.kind != What::boolean || b.kind != What::boolean) return std::nullopt;
    const bool both = a.integer != 0 && b.integer != 0;
    const bool any = a.integer != 0 || b.integer != 0;
    return TorchValue::of(name == "__and__" ? both : any);
  }
  if (is_one_of(name, kComparisons)) return compared(name, a, b);
  if (is_one_of(name, kSums)) return calculated(name, a, b);
  return std::nullopt;
}

}  // namespace eagerx::gen
