#include "targets/environments/train/network.hpp"

#include <algorithm>
#include <eagerx/math.hpp>

namespace eagerx::train {

Network::Network(std::size_t inputs, const std::vector<std::size_t>& hidden, std::size_t outputs,
                 Activation activation, CellShape memory)
    : activation_(activation) {
  std::vector<std::size_t> widths = hidden;
  widths.push_back(outputs);
  row_ = inputs;
  std::size_t from = 0;
  if (memory.memory != Memory::none) {
    cell_.emplace(memory, inputs);
    parameters_ = cell_->parameters();
    row_ = cell_->end();
    from = cell_->after();
    inputs = memory.units;
  }
  for (const std::size_t width : widths) {
    const std::size_t bias = parameters_ + inputs * width;
    layers_.push_back({{inputs, width}, parameters_, bias, from, row_});
    parameters_ = bias + width;
    from = row_;
    row_ += width;
    inputs = width;
  }
}

Cell::Product Network::first() const {
  if (cell_) return cell_->from_input();
  const Layer& layer = layers_.front();
  return {layer.sizes, layer.weights, layer.bias};
}

std::vector<float> Network::sampled(Random random, float gain) const {
  std::vector<float> parameters(parameters_, 0.0F);
  if (cell_) cell_->sample(random, parameters.data());
  for (const Layer& layer : layers_) {
    const float scale = &layer == &layers_.back() ? gain : 1.0F;
    const float deviation = scale / sqrt(static_cast<float>(layer.sizes.inputs));
    const std::size_t count = layer.sizes.inputs * layer.sizes.outputs;
    for (std::size_t i = 0; i < count; ++i) {
      parameters[layer.weights + i] = random.normal(0.0F, deviation);
    }
  }
  return parameters;
}

void Network::forward(const Kernels& kernels, const float* parameters, Simd* row) const {
  if (cell_) cell_->forward(kernels, parameters, row);
  for (const Layer& layer : layers_) {
    kernels.dense(layer.sizes, parameters + layer.weights, parameters + layer.bias,
                  row + layer.from, row + layer.to);
    if (&layer == &layers_.back()) return;
    const auto activate = activation_ == Activation::relu ? kernels.relu : kernels.tanh;
    activate(row + layer.to, layer.sizes.outputs);
  }
}

void Network::remember(Simd* row) const {
  if (cell_) std::copy_n(row + cell_->after(), cell_->shape().state(), row + cell_->before());
}

void Network::backward(const Kernels& kernels, const float* parameters, const Simd* rows,
                       Simd* deltas, std::size_t tiles, Simd* scratch, float* gradient,
                       const Simd* continues) const {
  const auto slope = activation_ == Activation::relu ? kernels.relu_slope : kernels.tanh_slope;
  for (std::size_t k = layers_.size(); k-- > 0;) {
    const Layer& layer = layers_[k];
    kernels.dense_gradient(layer.sizes, rows + layer.from, deltas + layer.to, tiles, row_, scratch,
                           gradient + layer.weights, gradient + layer.bias);
    if (k == 0 && !cell_) return;
    for (std::size_t t = 0; t < tiles; ++t) {
      Simd* delta = deltas + t * row_;
      kernels.dense_transposed(layer.sizes, parameters + layer.weights, delta + layer.to,
                               delta + layer.from);
      if (k > 0) slope(rows + t * row_ + layer.from, delta + layer.from, layer.sizes.inputs);
    }
  }
  cell_->backward(kernels, parameters, rows, deltas, tiles, row_, continues, scratch, gradient);
}

void Network::input_slopes(const Kernels& kernels, const float* parameters, const Simd* row,
                           Simd* deltas) const {
  const auto slope = activation_ == Activation::relu ? kernels.relu_slope : kernels.tanh_slope;
  for (std::size_t k = layers_.size(); k-- > 0;) {
    const Layer& layer = layers_[k];
    kernels.dense_transposed(layer.sizes, parameters + layer.weights, deltas + layer.to,
                             deltas + layer.from);
    if (k > 0) slope(row + layer.from, deltas + layer.from, layer.sizes.inputs);
  }
}

void Adam::step(const Kernels& kernels, std::vector<float>& weights,
                const std::vector<float>& gradient, float step_size, float gradient_scale) {
  ++steps;
  const auto count = static_cast<float>(steps);
  const AdamStep step{step_size, gradient_scale, 1.0F - pow(0.9F, count),
                      1.0F - pow(0.999F, count)};
  kernels.adam(weights.data(), gradient.data(), mean.data(), square.data(), weights.size(), step);
}

}  // namespace eagerx::train
