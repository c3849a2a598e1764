// Static knowledge of a value of a policy, and the steps from the observation to
// it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/policy/network/graph/tensor.hpp"
#include "generator/policy/network/layer.hpp"
#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {

/// A layer whose numbers are in the file. With memory: NetRecurrence.
struct NetLayer {
  LayerForm form{};
  std::optional<NetConstant> weights{};  // as a Layer's
  std::optional<NetConstant> bias{};     // as a Layer's; dense: or one for all
  float scale = 1.0F;                    // dense: of the weights
  float bias_scale = 1.0F;               // dense: of the bias
  Dims shape{};                          // elementwise: what its constant is broadcast to
};

struct NetActivation {
  Activation kind = Activation::identity;
  float slope = 0.0F;
};

/// Normalises all values.
struct NetNorm {
  std::optional<NetConstant> gamma;
  std::optional<NetConstant> beta;
  float epsilon = 1e-5F;
};

/// Zeros around an image, for the pool or convolution after it.
struct NetPad {
  std::uint32_t top = 0, left = 0, bottom = 0, right = 0;
};

/// Where a layer's state comes from: layer `slot` of input `name`.
struct NetStateSource {
  std::string_view name;
  std::int64_t slot = 0;
};

/// A GRU or LSTM. Gate i of the runtime is gate `gates[i]` of the weights.
struct NetRecurrence {
  bool is_lstm = false;
  std::array<std::uint8_t, 4> gates = {0, 1, 2, 3};
  NetConstant weights;                 // [1, gates * hidden, inputs]
  NetConstant hidden_weights;          // [1, gates * hidden, hidden]
  std::optional<NetConstant> bias;     // [1, 2 * gates * hidden]: of the input, of the state
  std::optional<NetStateSource> h, c;  // nothing: zeros at the start of an episode
};

using NetWork = std::variant<NetLayer, NetRecurrence, NetActivation, NetNorm, NetPad>;

/// One thing that is done to the observation on its way. Branches share their start, and a
/// Combination takes several.
struct NetStep {
  std::int32_t before = -1;  // index of the step before, -1 for the observation itself
  NetWork what;
  std::string node;                  // printable name
  std::int64_t count = 0;            // values after it
  std::vector<std::int32_t> more{};  // Combination: the steps of its other values

  /// The kind of layer, if it is a `Form`.
  template <class Form>
  [[nodiscard]] const Form* form() const {
    const auto* layer = std::get_if<NetLayer>(&what);
    return layer == nullptr ? nullptr : std::get_if<Form>(&layer->form);
  }
};

/// Part of a state after an observation: h or c of the layer of `step`.
struct NetRemembered {
  std::int32_t step = -1;
  bool is_cell = false;
};

/// A value on the way of a formula that exporters write out: LayerNorm and gelu. All are of the
/// data x after step `of`.
struct NetPart {
  enum class Role : std::uint8_t {
    none,
    mean,            // mean(x)
    centred,         // x - mean(x)
    centred_square,  // (x - mean(x))²
    variance,        // its mean, plus epsilon
    deviation,       // the root of that
    erf,             // erf(x / sqrt(2)), or tanh(sqrt(2 / pi) (x + 0.044715 x³)) where `by_tanh`
    one_plus_erf,    //
    half_plus_erf,   // half of it
    twice_gelu,      // x (1 + erf)
    square,          // x²
    cube,            // x³
    cubic,           // 0.044715 x³
    gelu_sum,        // x + 0.044715 x³
    gelu_inner,      // sqrt(2 / pi) of it
    ordered,         // values in the order of x: softmax(x), x plus one number
    choice,          // the index of the largest x
  };
  Role role = Role::none;
  std::int32_t of = -1;
  bool by_tanh = false;
  float epsilon = 0.0F;
  std::vector<std::uint32_t> groups{};  // choice: how many x each is among, of several
  std::int32_t exact = -1;  // ordered: the step that calculates it all the same, if there is one
};

/// A value of the policy.
struct NetValue {
  enum class Kind : std::uint8_t {
    absent,    // an optional input that is not given
    constant,  // a tensor of the file
    integers,  // a shape that was computed
    data,      // the observation after `step`, in row-major order
    state,     // layers `slot` to `slot + slots` of the state that input `state` is
    other,     // anything else: `problem` says why the action must not depend on it
  };
  Kind kind = Kind::absent;
  std::optional<Dims> shape;  // where known
  std::uint32_t time = 0;     // bit i: axis i may be the steps of a sequence
  NetConstant constant;
  std::vector<std::int64_t> integers;
  std::int32_t step = -1;
  NetStateSource state;
  std::int64_t slots = 0;
  std::vector<NetRemembered> remembered;  // layer by layer, if this is a new state
  NetPart part;
  bool is_zero = false;       // other: all zeros
  bool is_condition = false;  // data: each number is 1 or 0
  PolicyProblem problem;
};

}  // namespace eagerx::gen
