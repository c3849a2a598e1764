#include "generator/policy/network/graph/lower.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kLayersHelp =
    "export the actor alone: Linear layers with LayerNorm or not, and an activation after them";

/// How many constants the layer of a step will have.
std::int64_t parameters_of(const NetStep& step) {
  const auto count = [](const NetConstant& constant) {
    return element_count(constant.dims).value_or(kMaxParameters);
  };
  if (const auto* work = std::get_if<NetRecurrence>(&step.what)) {
    return count(work->weights) + count(work->hidden_weights);
  }
  if (const auto* layer = std::get_if<NetLayer>(&step.what); layer != nullptr && layer->weights) {
    const bool is_dense = step.form<Dense>() != nullptr;
    return count(*layer->weights) + (is_dense ? layer->weights->dims[0] : 0);
  }
  const bool each = step.form<Elementwise>() != nullptr || step.form<Combination>() != nullptr ||
                    step.form<Function>() != nullptr || step.form<Reorder>() != nullptr ||
                    std::holds_alternative<NetNorm>(step.what);
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
  /// Whether what follows may become a part of the layer before: nothing else takes its result.
  bool may_extend() const { return takes_.front() >= 0 && !is_shared_; }

  Refused fail(const char* code, std::string message, std::string help = kLayersHelp) {
    return refuse(problem_, code, std::move(message), std::move(help));
  }

  bool add(const NetLayer& work) {
    if (const auto* moved = std::get_if<Convolution>(&work.form)) {
      if (!is_short(moved->kernel, moved->kernel.channels / moved->groups)) return false;
    } else if (const auto* pool = std::get_if<Pooling>(&work.form)) {
      if (!is_short(pool->kernel, 1)) return false;
    } else if (const auto* all = std::get_if<Combination>(&work.form)) {
      take_several(*all);
    }
    Layer& layer = add_form(work.form);
    if (work.weights && !read(*work.weights, layer.weights)) return false;
    for (float& weight : layer.weights) weight *= work.scale;
    return add_bias(work, layer) && is_finite(work, layer);
  }

  /// Of a dense layer one number for each output; of an elementwise one a constant for all, or for
  /// each after broadcasting.
  bool add_bias(const NetLayer& work, Layer& layer) {
    const auto* elementwise = std::get_if<Elementwise>(&work.form);
    const auto* moved = std::get_if<Convolution>(&work.form);
    std::vector<float> values;
    if (work.bias && !read(*work.bias, values)) return false;
    if (elementwise != nullptr) {
      layer.bias = values.size() > 1 ? broadcast_to(values, work.bias->dims, work.shape) : values;
      const bool divides = elementwise->operation == Elementwise::Operation::divide;
      return !divides || !ranges::contains(layer.bias, 0.0F) ||
             fail("E0616", fmt::format("divides by zero (node `{}`)", node_),
                  "the training diverged: export a policy that works");
    }
    if (!layer.is_dense() && moved == nullptr) return true;
    layer.bias.assign(moved != nullptr ? moved->channels : layer.outputs, 0.0F);
    for (std::size_t i = 0; work.bias && i < layer.bias.size(); ++i) {
      layer.bias[i] = work.bias_scale * (values.size() == 1 ? values.front() : values[i]);
    }
    return true;
  }

  /// Numbers of the file are; products with factors may not be.
  bool is_finite(const NetLayer& work, const Layer& layer) {
    if (work.scale == 1.0F && work.bias_scale == 1.0F) return true;
    for (const auto* values : {&layer.weights, &layer.bias}) {
      if (ranges::all_of(*values, [](float x) { return std::isfinite(x); })) continue;
      return fail("E0616",
                  fmt::format("has a layer whose factors turn `{}` into NaN or infinity",
                              printable(work.weights->tensor->name)),
                  "export the actor again");
    }
    return true;
  }

  /// The first layer takes the observation alone.
  void take_several(const Combination& work) {
    if (layers_.empty()) {
      const std::uint32_t after = std::exchange(after_, observed_);
      const auto takes = std::exchange(takes_, {-1});
      add_form(Elementwise{});
      takes_ = takes;
      after_ = after;
    }
    count_ = 0;
    for (const std::uint32_t size : work.sizes) count_ += size;
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

  /// Whether a robot can compute it in a step, and the generator in a minute.
  bool is_short(const KernelShape& kernel, std::uint64_t values) {
    constexpr auto kMostProducts = static_cast<std::uint64_t>(kMaxProducts);
    const std::uint64_t size = std::uint64_t{kernel.rows} * kernel.columns;
    if (size <= kMostProducts && size * values <= kMostProducts / after_) return true;
    return fail(
        "E0619",
        fmt::format("needs more than {} products in one layer (node `{}`)", kMostProducts, node_),
        "use a smaller network");
  }

  bool add(const NetPad& /*work*/) {
    return fail("E0613", fmt::format("has zeros around values that no convolution or average pool "
                                     "takes (node `{}`)",
                                     node_));
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

  Layer& add_form(LayerForm form) {
    Layer layer = layer_of(std::move(form), count_, after_);
    layer.takes = takes_;
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
    computes = computes || step.form<Reorder>() == nullptr;
  }
  if (!computes) {
    return refuse(problem, "E0620", "has no layer between its input and its action", kLayersHelp);
  }
  return builder.take();
}

}  // namespace eagerx::gen
