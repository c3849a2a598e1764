#include "generator/network/graph/lower.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "generator/network/graph/operators.hpp"
#include "generator/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kLayersHelp =
    "export the actor alone: Linear layers with LayerNorm or not, and an activation after them";

/// The bias as `outputs` values, with its factor applied; NaN and infinity are caught later.
std::optional<std::vector<float>> read_bias(const NetDense& dense, std::size_t outputs,
                                            PolicyProblem& problem) {
  std::vector<float> bias(outputs, 0.0F);
  if (!dense.bias) return bias;
  const std::optional<std::vector<float>> values = read_floats(*dense.bias, problem);
  if (!values) return std::nullopt;
  for (std::size_t i = 0; i < outputs; ++i) {
    bias[i] = dense.bias_scale * (values->size() == 1 ? values->front() : (*values)[i]);
  }
  return bias;
}

std::optional<Layer> make_layer(const NetDense& dense, PolicyProblem& problem) {
  std::optional<std::vector<float>> weights = read_floats(dense.weights, problem);
  if (!weights) return std::nullopt;
  for (float& weight : *weights) weight *= dense.scale;
  Layer layer;
  layer.outputs = static_cast<std::uint32_t>(dense.weights.dims[0]);
  layer.inputs = static_cast<std::uint32_t>(dense.weights.dims[1]);
  std::optional<std::vector<float>> bias = read_bias(dense, layer.outputs, problem);
  if (!bias) return std::nullopt;
  for (const std::vector<float>* values : {&*weights, &*bias}) {
    for (const float value : *values) {
      if (std::isfinite(value)) continue;
      problem = {"E0616",
                 fmt::format("has a layer whose factors turn `{}` into NaN or infinity",
                             printable(dense.weights.tensor->name)),
                 "export the actor again"};
      return std::nullopt;
    }
  }
  layer.weights = std::move(*weights);
  layer.bias = std::move(*bias);
  return layer;
}

/// How many constants the layer of a step will have.
std::int64_t parameters_of(const NetStep& step) {
  const auto count = [](const NetConstant& constant) {
    return element_count(constant.dims).value_or(kMaxParameters);
  };
  if (const auto* dense = std::get_if<NetDense>(&step.what)) {
    return count(dense->weights) + dense->weights.dims[0];
  }
  if (const auto* work = std::get_if<NetConvolution>(&step.what)) return count(work->weights);
  if (const auto* work = std::get_if<NetRecurrence>(&step.what)) {
    return count(work->weights) + count(work->hidden_weights);
  }
  const bool each = std::holds_alternative<NetElementwise>(step.what) ||
                    std::holds_alternative<NetNorm>(step.what) ||
                    std::holds_alternative<Combination>(step.what) ||
                    std::holds_alternative<Function>(step.what) ||
                    std::holds_alternative<Reorder>(step.what);
  return each ? step.count : 0;
}

/// Layers, one after the other.
class LayerBuilder {
 public:
  LayerBuilder(std::uint32_t inputs, std::unordered_set<const NetTensor*>& used,
               PolicyProblem& problem)
      : observed_(inputs), used_(used), problem_(problem) {}

  /// `is_shared`: more than one step takes what the step takes.
  bool add(std::int32_t index, const NetStep& step, bool is_shared) {
    node_ = step.node;
    after_ = static_cast<std::uint32_t>(step.count);
    is_shared_ = is_shared;
    takes_ = {value_of(step.before)};
    for (const std::int32_t other : step.more) takes_.push_back(value_of(other));
    count_ = takes_.front() < 0 ? observed_ : layer_before().outputs;
    const std::size_t before = layers_.size();
    if (!std::visit([this](const auto& work) { return add(work); }, step.what)) return false;
    values_[index] = layers_.size() == before ? takes_.front() : newest();
    return true;
  }

  std::vector<Layer> take() {
    bool is_chain = true;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      is_chain = is_chain && layers_[i].takes == std::vector{static_cast<std::int32_t>(i) - 1};
    }
    for (Layer& layer : layers_) {
      if (is_chain) layer.takes.clear();
    }
    return std::move(layers_);
  }

 private:
  std::int32_t newest() const { return static_cast<std::int32_t>(layers_.size()) - 1; }
  std::int32_t value_of(std::int32_t step) const { return step < 0 ? -1 : values_.at(step); }
  Layer& layer_before() { return layers_[static_cast<std::size_t>(takes_.front())]; }
  /// Whether what follows may become a part of the layer before: nobody else takes its result.
  bool may_extend() const { return takes_.front() >= 0 && !is_shared_; }

  bool fail(const char* code, std::string message, std::string help = kLayersHelp) {
    problem_ = {code, std::move(message), std::move(help)};
    return false;
  }

  bool add(const NetDense& dense) {
    auto layer = make_layer(dense, problem_);
    if (!layer) return false;
    use(dense.weights);
    if (dense.bias) use(*dense.bias);
    layer->takes = takes_;
    layers_.push_back(std::move(*layer));
    return true;
  }

  /// On the last layer, if it has none; relu after relu changes nothing.
  bool add(const NetActivation& activation) {
    if (!std::isfinite(activation.slope)) {
      return fail("E0616",
                  fmt::format("has an activation without a finite slope (node `{}`)", node_),
                  "export the actor again");
    }
    const bool relu = activation.kind == Activation::relu;
    if (takes_.front() >= 0 && relu && layer_before().activation == Activation::relu) return true;
    const bool fits = may_extend() && layer_before().activation == Activation::identity;
    Layer& layer = fits ? layer_before() : add_form(Elementwise{});
    layer.activation = activation.kind;
    layer.slope = activation.slope;
    return true;
  }

  /// Between the last layer and its activation.
  bool add(const NetNorm& norm) {
    if (!(norm.epsilon >= 0.0F)) {
      return fail("E0616",
                  fmt::format("has a LayerNorm whose epsilon is not a number (node `{}`)", node_),
                  "export the actor again");
    }
    LayerNorm result{std::vector<float>(count_, 1.0F), std::vector<float>(count_, 0.0F),
                     norm.epsilon};
    if (norm.gamma && !read(*norm.gamma, result.gamma)) return false;
    if (norm.beta && !read(*norm.beta, result.beta)) return false;
    if (result.gamma.size() != count_ || result.beta.size() != count_) {
      return fail("E0618", fmt::format("has a LayerNorm of another size than {} (node `{}`)",
                                       count_, node_));
    }
    const bool fits =
        may_extend() && !layer_before().norm && layer_before().activation == Activation::identity;
    (fits ? layer_before() : add_form(Elementwise{})).norm = std::move(result);
    return true;
  }

  /// What a robot cannot compute in a step, and a generator not in a minute.
  bool is_short(const KernelShape& kernel, std::uint64_t values) {
    constexpr auto kMostProducts = static_cast<std::uint64_t>(kMaxProducts);
    const std::uint64_t size = std::uint64_t{kernel.rows} * kernel.columns;
    if (size <= kMostProducts && size * values <= kMostProducts / after_) return true;
    return fail(
        "E0619",
        fmt::format("needs more than {} products in one layer (node `{}`)", kMostProducts, node_),
        "use a smaller network");
  }

  bool add(const NetConvolution& work) {
    if (!is_short(work.form.kernel, work.form.kernel.channels / work.form.groups)) return false;
    Layer& layer = add_form(work.form);
    layer.bias.assign(work.form.channels, 0.0F);
    return read(work.weights, layer.weights) && (!work.bias || read(*work.bias, layer.bias));
  }
  bool add(const Pooling& work) {
    if (!is_short(work.kernel, 1)) return false;
    add_form(work);
    return true;
  }
  bool add(const NetPad& /*work*/) {
    return fail("E0613", fmt::format("has zeros around values that no convolution or average pool "
                                     "takes (node `{}`)",
                                     node_));
  }
  bool add(const Reorder& work) {
    add_form(work);
    return true;
  }
  bool add(const Function& work) {
    add_form(work);
    return true;
  }
  bool add(const Reduction& work) {
    add_form(work);
    return true;
  }
  bool add(const Combination& work) {
    if (layers_.empty()) {  // the first layer takes the observation alone
      const std::uint32_t after = std::exchange(after_, observed_);
      const auto takes = std::exchange(takes_, {-1});
      add_form(Elementwise{});
      takes_ = takes;
      after_ = after;
    }
    count_ = 0;
    for (const std::uint32_t size : work.sizes) count_ += size;
    add_form(work);
    return true;
  }

  /// A constant for all, or for each after broadcasting.
  bool add(const NetElementwise& work) {
    Layer& layer = add_form(Elementwise{work.operation});
    std::vector<float> values;
    if (!read(work.constant, values)) return false;
    if (values.size() == 1) {
      layer.bias = std::move(values);
    } else {
      layer.bias = broadcast_to(values, work.constant.dims, work.shape);
    }
    const bool divides = work.operation == Elementwise::Operation::divide;
    if (!divides || std::find(layer.bias.begin(), layer.bias.end(), 0.0F) == layer.bias.end()) {
      return true;
    }
    return fail("E0616", fmt::format("divides by zero (node `{}`)", node_),
                "the training diverged: export a policy that works");
  }

  /// The order of the file's gates becomes the runtime's.
  bool add(const NetRecurrence& work) {
    Layer& layer = add_form(Recurrence{work.is_lstm, {}, {}});
    auto& cell = std::get<Recurrence>(layer.form);
    const std::size_t gates = cell.gates();
    std::vector<float> bias(2 * gates * after_, 0.0F);
    if (!read(work.weights, layer.weights) || !read(work.hidden_weights, cell.hidden_weights) ||
        (work.bias && !read(*work.bias, bias))) {
      return false;
    }
    const auto half = bias.begin() + static_cast<std::ptrdiff_t>(bias.size() / 2);
    layer.bias.assign(bias.begin(), half);
    cell.hidden_bias.assign(half, bias.end());
    for (auto* values : {&layer.weights, &layer.bias, &cell.hidden_weights, &cell.hidden_bias}) {
      *values = gates_in_order(*values, gates, work.gates);
    }
    return true;
  }

  static std::vector<float> gates_in_order(const std::vector<float>& values, std::size_t gates,
                                           const std::array<std::uint8_t, 4>& order) {
    if (std::ranges::is_sorted(order)) return values;
    const std::size_t size = values.size() / gates;
    std::vector<float> result;
    result.reserve(values.size());
    for (std::size_t gate = 0; gate < gates; ++gate) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(order.at(gate) * size);
      result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(size));
    }
    return result;
  }

  template <class Form>
  Layer& add_form(Form form) {
    Layer layer;
    layer.takes = takes_;
    layer.inputs = count_;
    layer.outputs = after_;
    layer.form = std::move(form);
    layers_.push_back(std::move(layer));
    return layers_.back();
  }
  void use(const NetConstant& constant) { used_.insert(constant.tensor); }
  bool read(const NetConstant& constant, std::vector<float>& values) {
    auto numbers = read_floats(constant, problem_);
    if (!numbers) return false;
    use(constant);
    values = std::move(*numbers);
    return true;
  }

  std::uint32_t observed_;
  std::uint32_t count_ = 0;  // values before the step
  std::uint32_t after_ = 0;  // and after it
  std::string node_;
  std::unordered_set<const NetTensor*>& used_;
  PolicyProblem& problem_;
  std::vector<Layer> layers_;
  std::vector<std::int32_t> takes_;  // values that the step takes
  bool is_shared_ = false;
  std::map<std::int32_t, std::int32_t> values_;  // of steps: -1 the observation, i layer i
};

}  // namespace

std::optional<std::vector<std::int32_t>> steps_to(const std::vector<NetStep>& steps,
                                                  std::int32_t last, PolicyProblem& problem) {
  std::set<std::int32_t> found;
  std::vector<std::int32_t> open = {last};
  std::int64_t parameters = 0;
  while (!open.empty()) {
    const std::int32_t index = open.back();
    open.pop_back();
    if (index < 0 || !found.insert(index).second) continue;
    const NetStep& step = steps[static_cast<std::size_t>(index)];
    parameters += parameters_of(step) + static_cast<std::int64_t>(step.more.size());
    if (parameters > kMaxParameters || found.size() > 2 * kMaxLayers) {
      return refuse(
          problem, "E0619",
          fmt::format("has more than {} layers or {} parameters", kMaxLayers, kMaxParameters),
          "use a smaller network");
    }
    open.push_back(step.before);
    open.insert(open.end(), step.more.begin(), step.more.end());
  }
  return std::vector<std::int32_t>(found.begin(), found.end());
}

std::optional<std::vector<Layer>> make_layers(const std::vector<NetStep>& steps, std::int32_t last,
                                              std::uint32_t inputs,
                                              std::unordered_set<const NetTensor*>& used,
                                              PolicyProblem& problem) {
  const auto path = steps_to(steps, last, problem);
  if (!path) return std::nullopt;
  std::map<std::int32_t, int> takers;
  for (const std::int32_t index : *path) {
    const NetStep& step = steps[static_cast<std::size_t>(index)];
    ++takers[step.before];
    for (const std::int32_t other : step.more) ++takers[other];
  }
  LayerBuilder builder(inputs, used, problem);
  bool computes = false;
  for (const std::int32_t index : *path) {
    const NetStep& step = steps[static_cast<std::size_t>(index)];
    if (!builder.add(index, step, takers[step.before] > 1)) return std::nullopt;
    computes = computes || !std::holds_alternative<Reorder>(step.what);
  }
  if (!computes) {
    problem = {"E0620", "has no layer between its input and its action", kLayersHelp};
    return std::nullopt;
  }
  return builder.take();
}

}  // namespace eagerx::gen
