// GRU and LSTM, one observation at a time, with their input and output states.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

/// Whether the activations are those that the operator has if nothing is said.
bool usual_activations(const NetCall& call, bool is_lstm) {
  const NetAttribute* given = call.attribute("activations");
  if (given == nullptr || given->texts.empty()) return true;
  constexpr std::array<std::string_view, 3> kUsual = {"Sigmoid", "Tanh", "Tanh"};
  return std::ranges::equal(given->texts, std::span(kUsual).first(is_lstm ? 3 : 2));
}

/// The unusual property of the operator.
std::string unusual(const NetCall& call, bool is_lstm) {
  const std::string_view direction = call.text("direction");
  if (!direction.empty() && direction != "forward") {
    return "that does not run forward";
  }
  if (!usual_activations(call, is_lstm)) return "with other activations than Sigmoid and Tanh";
  if (call.attribute("clip") != nullptr) return "with a clip";
  if (call.integer("layout", 0) != 0) return "with layout 1";
  if (call.integer("input_forget", 0) != 0) return "whose gates are coupled";
  if (!is_lstm && call.integer("linear_before_reset", 0) == 0) {
    return "with `linear_before_reset` 0, which torch's GRU does not have";
  }
  if (is_lstm && call.input(7).kind != Kind::absent) return "with peepholes";
  return {};
}

/// Whether a state is zeros. Its shape comes first and its values count: a file of a few bytes may
/// name the same large tensor in each of many nodes.
bool starts_at_zero(const NetCall& call, const NetValue& value, std::int64_t hidden) {
  if (value.kind == Kind::absent || value.is_zero) return true;
  if (value.kind != Kind::constant || value.constant.dims != Dims{1, 1, hidden} ||
      !call.spend(hidden)) {
    return false;
  }
  PolicyProblem ignored;
  const auto numbers = read_floats(value.constant, ignored);
  return numbers &&
         std::all_of(numbers->begin(), numbers->end(), [](float x) { return x == 0.0F; });
}

class Recurrent {
 public:
  Recurrent(const NetCall& call, bool is_lstm) : call_(call), is_lstm_(is_lstm) {}

  NetValue run() {
    const NetValue& x = call_.input(0);
    if (x.kind != Kind::data || x.shape->size() != 3 || (*x.shape)[0] != 1 || (*x.shape)[1] != 1) {
      return call_.misused("that does not take one observation at a time");
    }
    if (const std::string how = unusual(call_, is_lstm_); !how.empty()) return call_.misused(how);
    const auto lengths = integers_of(call_.input(4));
    if (call_.input(4).kind != Kind::absent && lengths != std::vector<std::int64_t>{1}) {
      return call_.misused("with lengths of sequences that are not one step");
    }
    work_.is_lstm = is_lstm_;
    if (call_.state().has_gates_of_onnx) {
      work_.gates = is_lstm_ ? std::array<std::uint8_t, 4>{0, 2, 3, 1}   // i, f, g, o in i, o, f, c
                             : std::array<std::uint8_t, 4>{1, 0, 2, 3};  // r, z, n in z, r, h
    }
    if (auto problem = take_weights((*x.shape)[2])) return call_.other(*problem);
    if (auto problem = take_state(call_.input(5), work_.h)) return call_.other(*problem);
    if (is_lstm_) {
      if (auto problem = take_state(call_.input(6), work_.c)) return call_.other(*problem);
      if (work_.h.has_value() != work_.c.has_value()) {
        return call_.misused("that takes only half of its state");
      }
    }
    return call_.data_after(x.step, std::move(work_), {1, 1, 1, hidden_});
  }

 private:
  std::optional<PolicyProblem> take_weights(std::int64_t inputs) {
    const NetValue& w = call_.input(1);
    const NetValue& r = call_.input(2);
    const NetValue& b = call_.input(3);
    const std::int64_t gates = is_lstm_ ? 4 : 3;
    const auto plain = [](const NetValue& value) {
      return value.kind == Kind::constant && !value.constant.transposed;
    };
    if (!plain(w) || !plain(r) || (b.kind != Kind::absent && !plain(b))) {
      return PolicyProblem{"E0613", fmt::format("has {} without constant weights", call_.who()),
                           "export the actor again"};
    }
    hidden_ = r.constant.dims.size() == 3 ? r.constant.dims[2] : 0;
    const bool fits = hidden_ > 0 && hidden_ <= kMaxValues &&
                      w.constant.dims == Dims{1, gates * hidden_, inputs} &&
                      r.constant.dims == Dims{1, gates * hidden_, hidden_} &&
                      (b.kind == Kind::absent || b.constant.dims == Dims{1, 2 * gates * hidden_}) &&
                      call_.integer("hidden_size", hidden_) == hidden_;
    if (!fits) {
      return PolicyProblem{
          "E0618",
          fmt::format("has weights of shapes {} and {} for {} values in {}", show(w.constant.dims),
                      show(r.constant.dims), inputs, call_.who()),
          kExportMisfit};
    }
    work_.weights = w.constant;
    work_.hidden_weights = r.constant;
    if (b.kind == Kind::constant) work_.bias = b.constant;
    return std::nullopt;
  }

  std::optional<PolicyProblem> take_state(const NetValue& state,
                                          std::optional<NetStateSource>& source) {
    if (state.kind == Kind::state) {
      if (state.slots != 1 || state.shape != Dims{1, 1, hidden_}) {
        return PolicyProblem{"E0618",
                             fmt::format("gives a state of shape {} to {}, which has {} values",
                                         show(state.shape.value_or(Dims{})), call_.who(), hidden_),
                             kExportMisfit};
      }
      source = state.state;
      return std::nullopt;
    }
    const bool zero = starts_at_zero(call_, state, hidden_);
    if (call_.state().budget < 0) return call_.too_much().problem;
    if (zero && call_.state().is_sequence) return std::nullopt;
    if (zero) {
      return PolicyProblem{
          "E0640",
          fmt::format("starts from zeros at every observation in {}: it remembers nothing",
                      call_.who()),
          "export it with its state as an input and an output, or with batch and time as "
          "`dynamic_axes`"};
    }
    return PolicyProblem{"E0640",
                         fmt::format("computes the state that {} starts from", call_.who()),
                         "export it with its state as an input and an output"};
  }

  const NetCall& call_;
  bool is_lstm_;
  NetRecurrence work_;
  std::int64_t hidden_ = 0;
};

template <bool IsLstm>
NetValue cell(const NetCall& call) {
  return Recurrent(call, IsLstm).run();
}

/// The new state: h, and c of an LSTM.
template <bool IsLstm>
NetValue state_after(const NetCall& call, const NetValue& first, int i) {
  if (i > (IsLstm ? 2 : 1) || first.kind != Kind::data) {
    return call.misused("whose second output is used");
  }
  NetValue value = first;
  value.time = 0;  // the last step's
  if (i == 2) value = call.misused("whose cell state is used by another layer");
  value.shape = Dims{1, 1, first.shape->back()};
  value.remembered = {{first.step, i == 2}};
  return value;
}

}  // namespace

std::vector<NetOperator> recurrent_operators() {
  const auto remembers = [](auto later) {
    return NetTraits{.has_weights = true, .has_memory = true, .later = later};
  };
  return {{"GRU", cell<false>, time_of_cell, remembers(state_after<false>)},
          {"LSTM", cell<true>, time_of_cell, remembers(state_after<true>)}};
}

}  // namespace eagerx::gen
