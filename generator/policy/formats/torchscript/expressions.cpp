// Expressions of TorchScript code.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/policy/formats/torchscript/interpreter.hpp"
#include "generator/policy/formats/torchscript/states.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Syntax = TorchExpression::Kind;
using Has = TorchValue::Kind;

/// slice(x, axis, start, end, step) of all that x has: x itself.
bool is_whole_slice(const std::vector<TorchValue>& arguments) {
  const auto given = [&](std::size_t i, std::int64_t otherwise) {
    if (i >= arguments.size() || arguments[i].is_none()) return otherwise;
    return arguments[i].whole().value_or(-1);
  };
  const auto& shape = arguments.front().tensor->value.shape;
  if (!shape || shape->empty()) return false;
  const auto axis = place_in(given(1, 0), static_cast<std::int64_t>(shape->size()));
  if (!axis) return false;
  const std::int64_t size = (*shape)[static_cast<std::size_t>(*axis)];
  return given(2, 0) == 0 && given(3, size) >= size && given(4, 1) == 1;
}

bool is_view(std::string_view name) {
  const TorchRow* row = torch_row(name);
  return row != nullptr && row->is_view;
}

/// Whether the result is the first argument.
bool is_same(const std::string& name) {
  constexpr std::array kSame = {"contiguous", "detach",          "dropout",
                                "alias",      "feature_dropout", "float",
                                "cpu",        "type_as",         "alpha_dropout"};
  return ranges::contains(kSame, name);
}

/// A condition that was made a number; anything else is itself.
TorchValue as_number(const TorchValue& x) {
  if (!x.tensor->value.is_condition) return x;
  NetValue value = x.tensor->value;
  value.is_condition = false;
  return TorchValue::of(std::move(value));
}

}  // namespace

std::string dotted_name(const TorchExpression& expression) {
  const TorchExpression* at = &expression;
  std::string name;
  while (at->kind == Syntax::attribute) {
    name.insert(0, "." + at->text);
    at = &at->parts.front();
  }
  return at->kind == Syntax::name ? at->text + name : std::string();
}

std::optional<TorchValue> TorchInterpreter::evaluate(const TorchExpression& expression,
                                                     Variables& variables) {
  if (--budget_ < 0) return fail("is too long to be followed");
  switch (expression.kind) {
    case Syntax::name:
      return evaluate_name(expression, variables);
    case Syntax::integer:
      return TorchValue::of(expression.integer);
    case Syntax::real:
      return TorchValue::of(expression.real);
    case Syntax::text: {
      TorchValue text = TorchValue::with(Has::text, 0);
      text.text = expression.text;
      return text;
    }
    case Syntax::attribute:
      return evaluate_attribute(expression, variables);
    case Syntax::call:
      return evaluate_call(expression, variables);
    case Syntax::subscript:
      return evaluate_subscript(expression, variables);
    case Syntax::tuple:
    case Syntax::list:
      break;
  }
  std::vector<TorchValue> items;
  for (const TorchExpression& part : expression.parts) {
    auto value = evaluate(part, variables);
    if (!value) return std::nullopt;
    items.push_back(std::move(*value));
  }
  return TorchValue::of(std::move(items));
}

std::optional<TorchValue> TorchInterpreter::evaluate_name(const TorchExpression& expression,
                                                          Variables& variables) {
  const std::string& name = expression.text;
  if (const auto known = variables.find(name); known != variables.end()) {
    if (known->second.is_tensor() && known->second.tensor->is_stale()) {
      return fail("uses a part of a tensor that was changed since");
    }
    return known->second;
  }
  if (name == "None") return TorchValue();
  if (name == "True" || name == "False") return TorchValue::of(name == "True");
  return fail(fmt::format("uses `{}`, which is not known", printable(name)));
}

std::optional<TorchValue> TorchInterpreter::evaluate_attribute(const TorchExpression& expression,
                                                               Variables& variables) {
  const std::string name = dotted_name(expression);
  if (name.starts_with("__torch__.")) {
    TorchValue function = TorchValue::with(Has::function, 0);
    function.text = name;
    return function;
  }
  if (name.starts_with("CONSTANTS.c")) {
    const Pickle& constants = archive_.pickle(1);
    std::size_t index = 0;
    for (const char c : name.substr(std::string_view("CONSTANTS.c").size())) {
      if (c < '0' || c > '9' || index > constants.values.size()) return fail("uses no constant");
      index = 10 * index + static_cast<std::size_t>(c - '0');
    }
    const std::vector<std::uint32_t>& items = constants.top().items;
    if (index >= items.size()) return fail(fmt::format("uses `{}`, which is not there", name));
    return value_of(1, items[index], name);
  }
  const auto base = evaluate(expression.parts.front(), variables);
  if (!base) return std::nullopt;
  if (base->kind != Has::module) {
    return fail(
        fmt::format("takes `{}` of something that is not a module", printable(expression.text)));
  }
  return member(*base, expression.text);
}

std::optional<TorchValue> TorchInterpreter::evaluate_subscript(const TorchExpression& expression,
                                                               Variables& variables) {
  const auto list = evaluate(expression.parts[0], variables);
  const auto index = list ? evaluate(expression.parts[1], variables) : std::nullopt;
  if (!index) return std::nullopt;
  const auto at = place_in(index->integer, static_cast<std::int64_t>(list->items.size()));
  if (list->kind != Has::sequence || index->kind != Has::integer || !at) {
    return fail("takes a part that is not there");
  }
  return list->items[static_cast<std::size_t>(*at)];
}

std::optional<TorchValue> TorchInterpreter::evaluate_call(const TorchExpression& expression,
                                                          Variables& variables) {
  const TorchExpression& callee = expression.parts.front();
  const std::string name = dotted_name(callee);
  // The first argument of these is a type.
  const bool has_type = name == "annotate" || name == "unchecked_cast" || name == "uninitialized";
  std::vector<TorchValue> arguments;
  Named named;
  const std::size_t unnamed = expression.parts.size() - expression.keywords.size();
  for (std::size_t i = has_type ? 2 : 1; i < expression.parts.size(); ++i) {
    auto value = evaluate(expression.parts[i], variables);
    if (!value) return std::nullopt;
    if (i < unnamed) {
      arguments.push_back(std::move(*value));
    } else {
      named.emplace_back(expression.keywords[i - unnamed], std::move(*value));
    }
  }
  if (name == "uninitialized") return TorchValue();
  if (has_type) return arguments.empty() ? fail("casts nothing") : std::optional(arguments.front());
  for (const std::string_view prefix : {"torch.", "ops.prim.", "ops.aten.", "ops.torch."}) {
    if (name.starts_with(prefix)) {
      return operation(name.substr(prefix.size()), std::move(arguments), std::move(named));
    }
  }
  TorchValue function;
  if (callee.kind == Syntax::attribute && !name.starts_with("__torch__.")) {
    const auto base = evaluate(callee.parts.front(), variables);
    if (!base) return std::nullopt;
    if (base->kind != Has::module)
      return fail("calls a function of something that is not a module");
    return method(*base, callee.text, std::move(arguments), std::move(named));
  }
  const bool is_variable = callee.kind != Syntax::name || variables.contains(callee.text);
  if (!is_variable) return built_in(name, std::move(arguments));
  auto found = evaluate(callee, variables);
  if (!found) return std::nullopt;
  if (found->kind == Has::module) {
    return method(*found, "forward", std::move(arguments), std::move(named));
  }
  const std::size_t dot = found->text.rfind('.');
  if (found->kind != Has::function || dot == std::string::npos) {
    return fail("calls something that is not a function");
  }
  const TorchFunction* code =
      archive_.function(found->text.substr(0, dot), found->text.substr(dot + 1), problem_);
  return code == nullptr ? std::nullopt : call(*code, std::move(arguments), std::move(named));
}

std::optional<TorchValue> TorchInterpreter::built_in(const std::string& name,
                                                     std::vector<TorchValue> arguments) {
  if (name == "getattr" && arguments.size() == 2 && arguments[0].kind == Has::module) {
    return member(arguments[0], arguments[1].text);
  }
  if (name == "print") return TorchValue();
  if (arguments.size() == 1) {
    const TorchValue& x = arguments.front();
    if (name == "int" && x.whole()) return TorchValue::of(*x.whole());
    if (name == "int" && x.is_tensor()) {
      constexpr float kLargest = 1e6F;
      const auto number = scalar_of(x.tensor->value);
      if (number && std::trunc(*number) == *number && std::fabs(*number) < kLargest) {
        return TorchValue::of(static_cast<std::int64_t>(*number));
      }
    }
    if (name == "float" && x.number()) return TorchValue::of(*x.number());
    if (name == "bool" && x.kind == Has::boolean) return x;
    if (name == "float" && x.is_tensor()) return x;
    if (name == "len") {
      if (auto length = run_plain_operator("len", arguments)) return length;
    }
  }
  return fail(fmt::format("calls `{}` on values that are not known", printable(name)));
}

std::optional<TorchValue> TorchInterpreter::operation(const std::string& name,
                                                      std::vector<TorchValue> arguments,
                                                      Named named) {
  if (name == "RaiseException") return fail("raises an error for an observation of this size");
  const bool has_tensor = !arguments.empty() && arguments.front().is_tensor();
  if (auto plain = run_plain_operator(name, arguments)) return plain;
  const bool has_places =
      has_tensor && arguments.front().tensor->value.kind == NetValue::Kind::integers;
  if (name == "to" && has_places) return arguments.front();
  if (name == "to" && has_tensor) {
    constexpr std::int64_t kFloat32 = 6;
    constexpr std::int64_t kFloat64 = 7;
    for (const auto& [key, value] : named) {
      if (key == "dtype") arguments.push_back(value);
    }
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      const TorchValue& type = arguments[i];
      if (type.kind == Has::integer && type.integer != kFloat32 && type.integer != kFloat64) {
        return fail("rounds numbers to another type than float32");
      }
    }
    return as_number(arguments.front());
  }
  if (name == "clone" && has_tensor) return TorchValue::of(arguments.front().tensor->value);
  if (is_same(name) && has_tensor) {
    const bool drops = name.ends_with("dropout");
    if (drops && (arguments.size() < 3 || arguments[2].whole() != 0)) {
      return fail("drops values, as in training: call `eval()` before the export");
    }
    return as_number(arguments.front());
  }
  const bool writes = name.size() > 1 && name.ends_with("_") && !name.ends_with("__");
  if (writes && has_tensor) return in_place(name, std::move(arguments), std::move(named));
  if (name == "slice" && !arguments.empty() && arguments.front().kind == Has::sequence) {
    return fail("takes a part of a list");
  }
  if (name == "slice" && has_tensor && named.empty() && is_whole_slice(arguments)) {
    return arguments.front();
  }
  const TorchCall call(name, where(), arguments, std::move(named), state_);
  auto result = run_torch_operator(call, problem_);
  if (!result || !has_tensor || !result->is_tensor()) return result;
  if (is_view(name)) {
    const std::shared_ptr<TorchTensor>& of = arguments.front().tensor;
    result->tensor->is_part = true;
    result->tensor->whole = of->whole ? of->whole : of;
    result->tensor->version = result->tensor->whole->version;
  }
  return result;
}

std::optional<TorchValue> TorchInterpreter::in_place(const std::string& name,
                                                     std::vector<TorchValue> arguments,
                                                     Named named) {
  const TorchValue target = arguments.front();
  if (name == "copy_" && target.tensor->whole) return copy_into_part(target, arguments);
  if (target.tensor->is_part || target.tensor->is_shared) return fail("changes a part of a tensor");
  NetValue value;
  if (name == "copy_") {
    const bool fits = arguments.size() > 1 && arguments[1].is_tensor() &&
                      arguments[1].tensor->value.shape == target.tensor->value.shape;
    if (!fits) return fail("copies values of another shape");
    value = arguments[1].tensor->value;
  } else {
    const std::string pure = name.substr(0, name.size() - 1);
    const TorchCall call(pure, where(), std::move(arguments), std::move(named), state_);
    const auto result = run_torch_operator(call, problem_);
    if (!result) return std::nullopt;
    if (!result->is_tensor() || is_view(pure)) return fail("changes a tensor in an unknown way");
    value = result->tensor->value;
  }
  target.tensor->value = std::move(value);
  target.tensor->is_written = true;
  ++target.tensor->version;
  return target;
}

/// `history[:, -1] = x`: the numbers of the whole, and those of x where the part has its own.
std::optional<TorchValue> TorchInterpreter::copy_into_part(
    const TorchValue& part, const std::vector<TorchValue>& arguments) {
  TorchTensor& whole = *part.tensor->whole;
  const bool is_buffer = !whole.buffer.empty() && whole.value.kind == NetValue::Kind::constant;
  for (const auto& [index, cell] : cells_) {
    if (!is_buffer || cell.get() != &whole) continue;
    changed_ = index;
    return fail_changed(whole.buffer);
  }
  const auto places = places_of(state_, part.tensor->value, whole.value);
  const bool has_source = arguments.size() > 1 && arguments[1].is_tensor();
  if (whole.is_shared || !places || !has_source) return fail("changes a part of a tensor");
  const TorchCall call("copy_", where(), arguments, {}, state_);
  const auto made =
      with_part(call, whole.value, *places, part.tensor->value, arguments[1].tensor->value);
  if (!made) return fail("copies values of another shape");
  whole.value = *made;
  whole.is_written = true;
  ++whole.version;
  part.tensor->value = call.node("Expand", {arguments[1].tensor->value},
                                 {{"shape", {}, {}, *part.tensor->value.shape}});
  part.tensor->version = whole.version;
  return part;
}

}  // namespace eagerx::gen
