// Static knowledge of a value in TorchScript code, and the operators over such
// values.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {

/// A tensor. Variables share it, so an in-place change affects all of them.
struct TorchTensor {
  NetValue value;
  std::string_view buffer{};             // of a module: its name, which the interpreter holds
  bool is_written = false;               // a buffer that has been given another value
  bool is_part = false;                  // lies in the memory of another tensor
  bool is_shared = false;                // a member whose tensor something else holds, too
  std::shared_ptr<TorchTensor> whole{};  // the tensor whose memory it lies in, if that is known
  std::uint32_t version = 0;             // of `whole` when this was taken from it; else its own

  /// Whether its memory has other values now.
  [[nodiscard]] bool is_stale() const { return whole && whole->version != version; }
};

struct TorchValue {
  enum class Kind : std::uint8_t {
    none,
    boolean,   // integer
    integer,   // integer
    real,      // real
    text,      // text
    tensor,    // tensor
    sequence,  // items: a list or tuple
    module,    // integer: an object of the archive
    function,  // text: its name with that of its module
    unknown,   // what only checks and printing need
  };
  Kind kind = Kind::none;
  std::int64_t integer = 0;
  double real = 0.0;
  std::string text{};
  std::shared_ptr<TorchTensor> tensor{};
  std::vector<TorchValue> items{};

  static TorchValue of(bool value) { return with(Kind::boolean, value ? 1 : 0); }
  static TorchValue of(std::int64_t value) { return with(Kind::integer, value); }
  static TorchValue of(double value) {
    TorchValue result = with(Kind::real, 0);
    result.real = value;
    return result;
  }
  static TorchValue of(NetValue value) {
    TorchValue result = with(Kind::tensor, 0);
    result.tensor = std::make_shared<TorchTensor>();
    result.tensor->value = std::move(value);
    return result;
  }
  static TorchValue of(std::vector<TorchValue> items) {
    TorchValue result = with(Kind::sequence, 0);
    result.items = std::move(items);
    return result;
  }
  static TorchValue with(Kind kind, std::int64_t integer) {
    TorchValue result;
    result.kind = kind;
    result.integer = integer;
    return result;
  }

  [[nodiscard]] bool is_none() const { return kind == Kind::none; }
  [[nodiscard]] bool is_tensor() const { return kind == Kind::tensor; }
  [[nodiscard]] std::optional<std::int64_t> whole() const {
    const bool known = kind == Kind::integer || kind == Kind::boolean;
    return known ? std::optional(integer) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> number() const {
    if (kind == Kind::real) return real;
    return kind == Kind::integer ? std::optional(static_cast<double>(integer)) : std::nullopt;
  }
};

/// A call of an operator: "add" of `torch.add(a, b, alpha=1)`. It becomes calls of
/// operators of the network's graph, as torch's own exporter does it.
class TorchCall {
 public:
  TorchCall(std::string_view name, std::string where, std::vector<TorchValue> arguments,
            std::vector<std::pair<std::string, TorchValue>> named, NetCall::State& state)
      : name_(name),
        where_(std::move(where)),
        arguments_(std::move(arguments)),
        named_(std::move(named)),
        state_(state) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] std::size_t size() const { return arguments_.size(); }
  /// Argument `i`, or the one of that name; none if there is neither.
  [[nodiscard]] const TorchValue& argument(std::size_t i, std::string_view name = {}) const;
  /// The tensor of argument `i`; a number becomes a constant.
  [[nodiscard]] std::optional<NetValue> tensor(std::size_t i, std::string_view name = {}) const;
  [[nodiscard]] std::optional<std::int64_t> whole(std::size_t i, std::string_view name,
                                                  std::optional<std::int64_t> otherwise) const;
  [[nodiscard]] std::optional<double> number(std::size_t i, std::string_view name,
                                             std::optional<double> otherwise) const;
  /// A list of whole numbers, or one alone.
  [[nodiscard]] std::optional<Integers> list(std::size_t i, std::string_view name = {}) const;

  /// The first output of the operator that ONNX calls `type`.
  [[nodiscard]] NetValue node(const char* type, const std::vector<NetValue>& inputs,
                              std::vector<NetAttribute> attributes = {}) const;
  [[nodiscard]] NetValue constant(const std::vector<float>& numbers, const Dims& dims) const;
  [[nodiscard]] NetCall::State& state() const { return state_; }
  [[nodiscard]] const std::string& where() const { return where_; }

  /// E0754: the operator is known, but not used like this.
  [[nodiscard]] PolicyProblem misused(const std::string& how) const;

 private:
  std::string_view name_;
  std::string where_;  // "line 7 of code/__torch__.py"
  std::vector<TorchValue> arguments_;
  std::vector<std::pair<std::string, TorchValue>> named_;
  NetCall::State& state_;
};

/// The result of an operator; nothing, and a problem, if it is not known or not used as it can be.
std::optional<TorchValue> run_torch_operator(const TorchCall& call, PolicyProblem& problem);

/// The effect of an operator; nothing if its use is not supported.
using TorchRun = std::function<std::optional<NetValue>(const TorchCall&)>;

/// All there is to say of one operator.
struct TorchRow {
  std::string_view name;
  TorchRun run;
  bool is_view = false;  // the result lies in the memory of the first argument
};

/// Argument `at`, or the one of that name.
struct TorchArgument {
  std::size_t at = 0;
  std::string_view name{};
};
/// An attribute of ONNX's operator that an argument says.
struct TorchGiven {
  enum class As : std::uint8_t { whole, number, list };
  As as = As::whole;
  std::string_view attribute;  // empty: there is none, so that the argument must be `otherwise`
  TorchArgument argument;
  std::optional<double> otherwise{};  // if it is left out; nothing: it must be there
};
/// ONNX's operator `type` of these tensors, in its order.
TorchRun torch_of(const char* type, std::vector<TorchArgument> tensors = {{}},
                  std::vector<TorchGiven> given = {});
/// Of the first argument and `other`.
TorchRun torch_of_two(const char* type);

/// Operators that compute (operators.cpp), that shape, pick and reorder (shapes.cpp), over images
/// and sequences (images.cpp), that compare and pick (conditions.cpp).
std::vector<TorchRow> torch_plain_rows();
std::vector<TorchRow> torch_shape_rows();
std::vector<TorchRow> torch_image_rows();
std::vector<TorchRow> torch_condition_rows();
/// The row of `name`; nullptr for others, and for those with several results.
const TorchRow* torch_row(std::string_view name);

/// Neighbouring parts along an axis, as a list: split and chunk.
std::optional<TorchValue> torch_parts(const TorchCall& call);
/// How many axes a value has, and one of them counted from the front.
std::int64_t torch_rank(const NetValue& x);
std::optional<std::int64_t> torch_axis(const NetValue& x, std::optional<std::int64_t> axis);

/// LSTM and GRU (recurrent.cpp).
std::optional<TorchValue> torch_recurrence(const TorchCall& call, PolicyProblem& problem);

}  // namespace eagerx::gen
