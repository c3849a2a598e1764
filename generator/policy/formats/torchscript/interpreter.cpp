#include "generator/policy/formats/torchscript/interpreter.hpp"

#include <fmt/core.h>

#include <numeric>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Part = TorchExpression::Kind;
using Held = TorchValue::Kind;

constexpr int kDeepestCall = 48;
constexpr int kDeepestValue = 16;
constexpr std::size_t kLongestList = 4096;
constexpr const char* kExportOnnx =
    "export the actor alone, or export it to ONNX with `torch.onnx.export`";

}  // namespace

std::string TorchInterpreter::where() const {
  return fmt::format("line {} of {}", line_, file_ == nullptr ? "" : printable(*file_));
}

Refused TorchInterpreter::fail(const std::string& what) {
  return refuse(problem_, "E0754", fmt::format("has code that {} ({})", what, where()),
                kExportOnnx);
}

Refused TorchInterpreter::fail_changed(std::string_view buffer) {
  return refuse(problem_, "E0756",
                fmt::format("has a buffer `{}` {} ({})", printable(buffer), kUnknownState, where()),
                kHistoryAsInput);
}

std::optional<TorchValue> TorchInterpreter::run(const std::vector<NetValue>& inputs) {
  const TorchValue module = TorchValue::with(Held::module, archive_.pickle(0).root);
  std::vector<TorchValue> arguments;
  arguments.reserve(inputs.size());
  for (const NetValue& input : inputs) arguments.push_back(TorchValue::of(input));
  return method(module, "forward", std::move(arguments), {});
}

std::optional<TorchValue> TorchInterpreter::call(const TorchFunction& function,
                                                 std::vector<TorchValue> arguments, Named named) {
  if (depth_ >= kDeepestCall) return fail("calls itself, or is nested too deeply");
  const std::string* file = std::exchange(file_, &function.file);
  const int line = std::exchange(line_, function.line);
  ++depth_;
  Variables variables;
  bool bound = arguments.size() <= function.parameters.size();
  for (std::size_t i = 0; bound && i < function.parameters.size(); ++i) {
    const TorchFunction::Parameter& parameter = function.parameters[i];
    const auto given = ranges::find(named, parameter.name, [](const auto& n) { return n.first; });
    std::optional<TorchValue> value;
    if (i < arguments.size()) {
      value = std::move(arguments[i]);
    } else if (given != named.end()) {
      value = given->second;
    } else if (parameter.otherwise) {
      value = evaluate(*parameter.otherwise, variables);
    }
    bound = value.has_value();
    if (bound) variables[parameter.name] = std::move(*value);
  }
  if (!bound) return fail("is called with other arguments than it has");
  TorchValue result;
  if (follow(function.body, variables, result) == Flow::failed) return std::nullopt;
  --depth_;
  file_ = file;
  line_ = line;
  return result;
}

TorchInterpreter::Flow TorchInterpreter::follow(const std::vector<TorchStatement>& body,
                                                Variables& variables, TorchValue& result) {
  for (const TorchStatement& statement : body) {
    const Flow flow = follow(statement, variables, result);
    if (flow != Flow::on) return flow;
  }
  return Flow::on;
}

TorchInterpreter::Flow TorchInterpreter::follow(const TorchStatement& statement,
                                                Variables& variables, TorchValue& result) {
  using Act = TorchStatement::Kind;
  line_ = statement.line;
  ++followed_;
  if (--budget_ < 0) {
    fail("is too long to be followed");
    return Flow::failed;
  }
  if (statement.kind == Act::pass) return Flow::on;
  if (statement.kind == Act::other) {
    fail(fmt::format("has a statement `{}`", statement.text));
    return Flow::failed;
  }
  auto value = evaluate(statement.value, variables);
  if (!value) return Flow::failed;
  switch (statement.kind) {
    case Act::give:
      result = std::move(*value);
      return Flow::returned;
    case Act::choose:
      if (value->kind != Held::boolean) {
        fail("depends on a condition that is not known before it runs");
        return Flow::failed;
      }
      return follow(value->integer != 0 ? statement.then : statement.otherwise, variables, result);
    case Act::assign:
      return assign(statement.targets, std::move(*value), variables) ? Flow::on : Flow::failed;
    default:
      return Flow::on;
  }
}

bool TorchInterpreter::assign(const std::vector<TorchExpression>& targets, TorchValue value,
                              Variables& variables) {
  // `a, = x` takes x apart as `a, b, = x` does, but the code of torch writes it only for tuples.
  if (targets.size() > 1) {
    if (value.kind != Held::sequence || value.items.size() != targets.size()) {
      return fail("takes apart a value that has other parts");
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (!assign({targets[i]}, value.items[i], variables)) return false;
    }
    return true;
  }
  const TorchExpression& target = targets.front();
  if (target.kind == Part::name) {
    variables[target.text] = std::move(value);
    return true;
  }
  const auto module = evaluate(target.parts.front(), variables);
  if (!module) return false;
  if (module->kind != Held::module || !value.is_tensor()) {
    return fail("changes a member that is not a tensor of a module");
  }
  const auto index = index_of(*module, target.text);
  const auto old = index ? value_of(0, *index, target.text) : std::nullopt;
  if (!old) return false;
  if (!old->is_tensor()) return fail("changes a member that is not a tensor of a module");
  const bool is_state = old->tensor->buffer.empty() || !value.tensor->value.remembered.empty();
  if (!is_state && !histories_.contains(*index)) {
    changed_ = index;
    return fail_changed(target.text);
  }
  // Holders of the old tensor keep it.
  auto cell = std::make_shared<TorchTensor>();
  cell->value = value.tensor->value;
  cell->buffer = old->tensor->buffer;
  cell->is_written = true;
  cell->is_part = value.tensor->is_part;
  cell->is_shared = value.tensor.use_count() > 1;
  cells_[*index] = std::move(cell);
  return true;
}

std::optional<TorchValue> TorchInterpreter::value_of(int pickle, std::uint32_t index,
                                                     const std::string& name, int depth) {
  using Stored = PickleValue::Kind;
  const Pickle& all = archive_.pickle(pickle);
  const PickleValue& stored = all.at(index);
  if (depth > kDeepestValue) return fail("has lists nested too deeply");
  switch (stored.kind) {
    case Stored::none:
      return TorchValue();
    case Stored::boolean:
      return TorchValue::of(stored.integer != 0);
    case Stored::integer:
      return TorchValue::of(stored.integer);
    case Stored::real:
      return TorchValue::of(stored.real);
    case Stored::text: {
      TorchValue text = TorchValue::with(Held::text, 0);
      text.text = stored.text.substr(0, kLongestList);
      return text;
    }
    case Stored::sequence: {
      if (stored.items.size() > kLongestList) return fail("has a list that is too long");
      std::vector<TorchValue> items;
      for (const std::uint32_t item : stored.items) {
        auto value = value_of(pickle, item, name, depth + 1);
        if (!value) return std::nullopt;
        items.push_back(std::move(*value));
      }
      return TorchValue::of(std::move(items));
    }
    case Stored::object:
      break;
    default:
      return TorchValue::with(Held::unknown, 0);
  }
  if (all.made_by(stored, "torch._utils._rebuild_tensor_v2")) {
    return tensor_of(pickle, index, name);
  }
  if (all.at(stored.function).text.starts_with("torch.jit._pickle.")) {
    const std::vector<std::uint32_t>& arguments = all.at(stored.arguments).items;
    if (!arguments.empty()) return value_of(pickle, arguments.front(), name, depth + 1);
  }
  if (all.at(stored.function).text.starts_with("__torch__.")) {
    return TorchValue::with(Held::module, index);
  }
  return TorchValue::with(Held::unknown, 0);
}

std::optional<TorchValue> TorchInterpreter::tensor_of(int pickle, std::uint32_t index,
                                                      const std::string& name) {
  const auto known = pickle == 0 ? cells_.find(index) : cells_.end();
  TorchValue value = TorchValue::with(Held::tensor, 0);
  if (known != cells_.end()) {
    value.tensor = known->second;
    return value;
  }
  const NetValue* tensor = archive_.tensor(pickle, index, name, problem_);
  if (tensor == nullptr) return std::nullopt;
  value.tensor = std::make_shared<TorchTensor>();
  value.tensor->value = *tensor;
  if (pickle != 0) return value;
  value.tensor->buffer = names_.emplace(index, name).first->second;
  if (histories_.contains(index)) {
    auto before = values_before(index, *tensor);
    if (!before) return std::nullopt;
    value.tensor->value = std::move(*before);
  }
  cells_.emplace(index, value.tensor);
  return value;
}

/// Two steps: the history, which check_torch_states() completes, and the order of the buffer.
std::optional<NetValue> TorchInterpreter::values_before(std::uint32_t index,
                                                        const NetValue& buffer) {
  const std::string& name = names_.at(index);
  const std::int64_t count = buffer.shape ? element_count(*buffer.shape).value_or(0) : 0;
  if (count < 1 || count > kMaxValues || !state_.spend(count)) return fail_changed(name);
  Reorder order;
  order.from.resize(static_cast<std::size_t>(count));
  std::iota(order.from.begin(), order.from.end(), 0U);
  const auto step = static_cast<std::int32_t>(state_.steps.size());
  state_.steps.push_back({-1, NetLayer{History{}}, printable(name), count});
  state_.steps.push_back({step, NetLayer{std::move(order)}, printable(name), count});
  former_.emplace(index, step);
  return data_value(step + 1, *buffer.shape);
}

std::optional<std::uint32_t> TorchInterpreter::changed() const {
  if (changed_) return changed_;
  for (const auto& [index, cell] : cells_) {
    const bool is_state = !cell->is_written || !cell->value.remembered.empty();
    if (!is_state && !histories_.contains(index)) return index;
  }
  return std::nullopt;
}

std::vector<std::uint32_t> TorchInterpreter::zeros() const {
  std::vector<std::uint32_t> found;
  PolicyProblem ignored;
  for (const auto& [index, cell] : cells_) {
    const NetValue& value = cell->value;
    const bool is_buffer = value.kind == NetValue::Kind::constant && value.shape;
    const auto count = is_buffer ? element_count(*value.shape) : std::nullopt;
    if (!count || value.shape->size() < 2 || !state_.spend(*count)) continue;
    const auto numbers = read_floats(value.constant, ignored);
    if (numbers && ranges::all_of(*numbers, [](float x) { return x == 0.0F; })) {
      found.push_back(index);
    }
  }
  return found;
}

std::optional<std::uint32_t> TorchInterpreter::index_of(const TorchValue& module,
                                                        const std::string& name) {
  const Pickle& all = archive_.pickle(0);
  const PickleValue& object = all.at(static_cast<std::uint32_t>(module.integer));
  const PickleValue* found = all.find(object, name);
  if (found == nullptr) return fail(fmt::format("has no member `{}`", printable(name)));
  return static_cast<std::uint32_t>(found - all.values.data());
}

std::optional<TorchValue> TorchInterpreter::member(const TorchValue& module,
                                                   const std::string& name) {
  const auto index = index_of(module, name);
  return index ? value_of(0, *index, name) : std::nullopt;
}

std::optional<TorchValue> TorchInterpreter::method(const TorchValue& module,
                                                   const std::string& name,
                                                   std::vector<TorchValue> arguments, Named named) {
  const Pickle& all = archive_.pickle(0);
  const PickleValue& object = all.at(static_cast<std::uint32_t>(module.integer));
  const std::string type(all.at(object.function).text);
  const std::size_t dot = type.rfind('.');
  if (object.kind != PickleValue::Kind::object || dot == std::string::npos) {
    return fail("calls a function of something that is not a module");
  }
  const TorchFunction* function = archive_.function(
      type.substr(0, dot), fmt::format("{}.{}", type.substr(dot + 1), name), problem_);
  if (function == nullptr) return std::nullopt;
  arguments.insert(arguments.begin(), module);
  return call(*function, std::move(arguments), std::move(named));
}

}  // namespace eagerx::gen
