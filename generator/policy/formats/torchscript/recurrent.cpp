// LSTM and GRU with torch's weights, layer by layer.
#include <fmt/core.h>

#include <array>
#include <utility>

#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostArguments = 9;
constexpr std::int64_t kMostRecurrentLayers = 16;

class Recurrent {
 public:
  Recurrent(const TorchCall& call, PolicyProblem& problem)
      : call_(call), problem_(problem), is_lstm_(call.name() == "lstm") {}

  /// lstm(input, [h, c], weights, has biases, layers, dropout, train, both directions, batch
  /// first); gru takes h itself.
  std::optional<TorchValue> run() {
    const auto layers = call_.whole(4, "num_layers", std::nullopt);
    const auto has_bias = call_.whole(3, "has_biases", std::nullopt);
    const bool usual = call_.size() == kMostArguments && layers && has_bias &&
                       call_.whole(6, "train", 0) == 0 && call_.whole(7, "bidirectional", 0) == 0;
    auto x = call_.tensor(0);
    if (!usual || !x || *layers < 1 || *layers > kMostRecurrentLayers) {
      return fail("in training, in both directions, or over packed sequences");
    }
    if (call_.whole(8, "batch_first", 0) != 0 && !is_one_step(*x))
      return fail("over several steps");
    const std::size_t each = *has_bias != 0 ? 4 : 2;
    const auto& weights = call_.argument(2).items;
    if (weights.size() != each * static_cast<std::size_t>(*layers)) {
      return fail("with projections, or without all weights");
    }
    std::vector<NetValue> new_h, new_c;
    for (std::int64_t layer = 0; layer < *layers; ++layer) {
      const auto inputs = inputs_of(*x, weights, each, layer, *layers);
      if (!inputs) return std::nullopt;
      const std::vector<NetAttribute> reset = {{"linear_before_reset", 1}};
      const char* type = is_lstm_ ? "LSTM" : "GRU";
      const auto attributes = is_lstm_ ? std::vector<NetAttribute>() : reset;
      std::array<NetValue, 3> made;
      std::size_t count = is_lstm_ ? 3 : 2;
      // One cell, whose outputs are asked for one by one: only the first call makes a step.
      make(type, *inputs, attributes, count, made);
      if (made[0].kind != NetValue::Kind::data) {
        problem_ = made[0].problem;
        return std::nullopt;
      }
      x = call_.node("Squeeze", {made[0]}, {{"axes", {}, {}, Integers{1}}});
      new_h.push_back(made[1]);
      if (is_lstm_) new_c.push_back(made[2]);
    }
    std::vector<TorchValue> results = {TorchValue::of(*x), TorchValue::of(stacked(new_h))};
    if (is_lstm_) results.push_back(TorchValue::of(stacked(new_c)));
    return TorchValue::of(std::move(results));
  }

 private:
  Refused fail(const std::string& how) {
    problem_ = call_.misused(how);
    return {};
  }
  static bool is_one_step(const NetValue& x) {
    return x.shape && x.shape->size() == 3 && (*x.shape)[0] == 1 && (*x.shape)[1] == 1;
  }

  void make(const char* type, const std::vector<NetValue>& inputs,
            const std::vector<NetAttribute>& attributes, std::size_t count,
            std::array<NetValue, 3>& made) {
    made[0] = call_.node(type, inputs, attributes);
    for (std::size_t i = 1; i < count; ++i) {
      made.at(i) = made[0];
      made.at(i).shape = Dims{1, 1, made[0].shape ? made[0].shape->back() : 0};
      made.at(i).remembered = {{made[0].step, i == 2}};
      if (i == 2) made[2].kind = NetValue::Kind::other;
      if (i == 2) made[2].problem = call_.misused("and takes its cell state for something else");
    }
  }

  /// The new states of all layers.
  NetValue stacked(const std::vector<NetValue>& parts) {
    if (parts.size() == 1) return parts.front();
    NetValue all = parts.front();
    all.remembered.clear();
    for (const NetValue& part : parts) all.remembered.push_back(part.remembered.front());
    all.kind = NetValue::Kind::other;
    all.problem = call_.misused("and takes the states of several layers for something else");
    all.shape = Dims{static_cast<std::int64_t>(parts.size()), 1, parts.front().shape->back()};
    return all;
  }

  /// x, weights, hidden weights, biases, no lengths, h, c.
  std::optional<std::vector<NetValue>> inputs_of(const NetValue& x,
                                                 const std::vector<TorchValue>& weights,
                                                 std::size_t each, std::int64_t layer,
                                                 std::int64_t layers) {
    std::vector<NetValue> inputs = {x};
    std::vector<float> bias;
    for (std::size_t i = 0; i < each; ++i) {
      const TorchValue& weight = weights[each * static_cast<std::size_t>(layer) + i];
      if (!weight.is_tensor() || weight.tensor->value.kind != NetValue::Kind::constant) {
        return fail("with weights that are computed");
      }
      const NetConstant& constant = weight.tensor->value.constant;
      const std::int64_t gates = is_lstm_ ? 4 : 3;
      const std::int64_t count = element_count(constant.dims).value_or(0);
      if (constant.dims.empty() || constant.transposed || count % gates != 0) {
        return fail("with weights of an impossible size");
      }
      if (i >= 2) {
        const auto numbers = read_floats(constant, problem_);
        if (!numbers) return std::nullopt;
        bias.insert(bias.end(), numbers->begin(), numbers->end());
        continue;
      }
      inputs.push_back(weight.tensor->value);
      Dims& dims = inputs.back().constant.dims;
      dims.insert(dims.begin(), 1);
      inputs.back().shape = dims;
    }
    NetValue none;
    inputs.push_back(none);
    if (each == 4) {
      inputs[3] = call_.constant(bias, {1, static_cast<std::int64_t>(bias.size())});
    }
    inputs.push_back(none);
    const TorchValue& states = call_.argument(1);
    for (std::size_t i = 0; i < (is_lstm_ ? 2U : 1U); ++i) {
      const TorchValue* state = is_lstm_ && i < states.items.size() ? &states.items[i] : &states;
      if (!state->is_tensor()) {
        return fail("with a state that is not a tensor");
      }
      inputs.push_back(state_of(*state->tensor, layer, layers));
    }
    return inputs;
  }

  /// A buffer of a module is what the cell remembers.
  static NetValue state_of(const TorchTensor& tensor, std::int64_t layer, std::int64_t layers) {
    const NetValue& value = tensor.value;
    const bool is_buffer = !tensor.buffer.empty() && !tensor.is_written &&
                           value.kind == NetValue::Kind::constant && value.shape &&
                           value.shape->size() == 3 && value.shape->front() == layers;
    if (!is_buffer) return value;
    NetValue state;
    state.kind = NetValue::Kind::state;
    state.shape = Dims{1, (*value.shape)[1], (*value.shape)[2]};
    state.state = {tensor.buffer, layer};
    state.slots = 1;
    return state;
  }

  const TorchCall& call_;
  PolicyProblem& problem_;
  bool is_lstm_;
};

}  // namespace

std::optional<TorchValue> torch_recurrence(const TorchCall& call, PolicyProblem& problem) {
  return Recurrent(call, problem).run();
}

}  // namespace eagerx::gen
