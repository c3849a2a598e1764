// One use of an operator in a file, with its inputs.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/policy/network/graph/value.hpp"

namespace eagerx::gen {

/// An attribute of an operator from a front end, in ONNX's terms: `name`, with its value in one of
/// these forms.
struct NetAttribute {
  std::string_view name;
  std::optional<std::int64_t> whole{};
  std::optional<double> real{};
  std::optional<Integers> list{};
  std::string_view text{};
  std::vector<std::string_view> texts{};
  std::vector<float> reals{};
  std::optional<NetValue> value{};  // a tensor: a constant, or why it is none

  [[nodiscard]] const Integers& integers() const {
    static const Integers kNone;
    return list ? *list : kNone;
  }
};

/// Attribute of a Softmax over its axis and all later ones.
inline constexpr std::string_view kSoftmaxToLast = "to_last";

/// An operator as used in a file, in the form of ONNX's newest version.
struct NetNode {
  std::string_view type;      // ONNX's name of it
  std::string_view name{};    // where it is, for people
  std::string_view domain{};  // empty: ONNX's own
  std::string_view output{};  // name of the first result
  int outputs = 1;
  std::vector<NetAttribute> attributes{};

  [[nodiscard]] bool is_usual() const { return domain.empty() || domain == "ai.onnx"; }
};

/// The observation after `step`, in this shape; -1: the observation itself.
NetValue data_value(std::int32_t step, Dims shape);

/// The inputs of an operator.
class NetCall {
 public:
  struct State {                // shared by all calls of a graph
    std::int64_t observed = 0;  // values of the observation
    bool is_sequence = false;   // the observation has time as an axis of any length
    bool follows_time = false;  // and no state is an input: the sequence starts an episode
    std::int64_t budget = std::int64_t{64} << 20U;  // values that may still be looked at
    std::vector<NetStep> steps;
    std::deque<NetTensor> made;     // tensors that are not in the file
    std::int64_t lacks = 0;         // of the first product that does not fit: values too few
    bool has_halves = false;        // values that the file rounds to float16
    bool has_gates_of_onnx = true;  // z, r, h and i, o, f, c; else torch's

    /// Whether `values` more values may be looked at or moved: a file may name the same large
    /// tensor a million times.
    [[nodiscard]] bool spend(std::int64_t values) {
      budget -= values;
      return budget >= 0;
    }
  };

  NetCall(const NetNode& node, std::vector<const NetValue*> inputs, State& state)
      : node_(node), inputs_(std::move(inputs)), state_(state) {}

  [[nodiscard]] const NetNode& node() const { return node_; }
  [[nodiscard]] State& state() const { return state_; }
  [[nodiscard]] std::size_t input_count() const { return inputs_.size(); }
  /// Input `i`; an absent value past the end.
  [[nodiscard]] const NetValue& input(std::size_t i) const;
  /// Attribute `name`, or nullptr.
  [[nodiscard]] const NetAttribute* attribute(std::string_view name) const;
  [[nodiscard]] std::int64_t integer(std::string_view name, std::int64_t otherwise) const;
  [[nodiscard]] float real(std::string_view name, float otherwise) const;
  [[nodiscard]] std::string_view text(std::string_view name) const;  // empty: none
  /// Integers of input `i` or, where there is no such input, of attribute `name`.
  [[nodiscard]] std::optional<Integers> integers(std::size_t i, std::string_view name) const;
  /// Whether input `i` exists but is not a list of known integers: the operator must then not use
  /// its default.
  [[nodiscard]] bool is_unreadable(std::size_t i) const;

  /// "operator `Gemm` (node `/mu/Gemm`)".
  [[nodiscard]] std::string who() const;
  /// The shape that all inputs broadcast to.
  [[nodiscard]] std::optional<Dims> common_shape() const;
  /// Attribute `axis` for something of `rank` axes, counted from the front; nothing if there is no
  /// such axis.
  [[nodiscard]] std::optional<std::size_t> axis(std::size_t rank, std::int64_t otherwise = 0) const;
  /// The step that `data` comes of; nullptr for the observation.
  [[nodiscard]] const NetStep* step_of(const NetValue& data) const;
  /// How many numbers there are after a step.
  [[nodiscard]] std::int64_t count_after(std::int32_t step) const;
  /// A value that the action must not depend on. If an input already is one, its problem comes
  /// first.
  [[nodiscard]] NetValue other(PolicyProblem problem, std::optional<Dims> shape = {}) const;
  /// E0613: the operator is known, but not used like this.
  [[nodiscard]] NetValue misused(const std::string& how, std::optional<Dims> shape = {}) const;
  [[nodiscard]] bool spend(std::int64_t values) const { return state_.spend(values); }
  /// E0619: the budget is spent.
  [[nodiscard]] NetValue too_much() const;
  /// The observation after one more step.
  [[nodiscard]] NetValue data_after(std::int32_t before, NetWork what, Dims shape) const;
  /// The same, of a layer without numbers.
  [[nodiscard]] NetValue layer_after(std::int32_t before, LayerForm form, Dims shape) const {
    return data_after(before, NetLayer{std::move(form)}, std::move(shape));
  }
  /// The combination of several values of the observation, in order.
  [[nodiscard]] NetValue data_of(const std::vector<NetValue>& values,
                                 Combination::Operation operation, Dims shape) const;

 private:
  const NetNode& node_;
  std::vector<const NetValue*> inputs_;
  State& state_;
};

}  // namespace eagerx::gen
