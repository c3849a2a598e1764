#include "targets/environments/train/policy.hpp"

#include <algorithm>
#include <eagerx/math.hpp>

namespace eagerx::train {

Head::Head(const Description& description)
    : chooses(description.chooses()), numbers(description.action_numbers()) {
  for (const Space& action : description.actions) {
    for (const double bound : action.low) low.push_back(static_cast<float>(bound));
    for (const double bound : action.high) high.push_back(static_cast<float>(bound));
  }
  outputs = chooses ? 0 : numbers;
  for (std::size_t j = 0; chooses && j < numbers; ++j) {
    counts.push_back(static_cast<std::size_t>(high[j] - low[j]) + 1);
    outputs += counts.back();
  }
}

float Head::scaled(std::size_t j, float x) const {
  const float value = low[j] + (0.5F * (x + 1.0F)) * (high[j] - low[j]);
  return clamp(value, low[j], high[j]);
}

void Head::act(const Simd* answers, std::size_t lane, float* action) const {
  if (!chooses) {
    for (std::size_t j = 0; j < outputs; ++j) action[j] = scaled(j, answers[j].lane[lane]);
    return;
  }
  for (std::size_t j = 0; j < numbers; answers += counts[j++]) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < counts[j]; ++i) {
      if (answers[i].lane[lane] > answers[best].lane[lane]) best = i;
    }
    action[j] = low[j] + static_cast<float>(best);
  }
}

Normaliser::Normaliser(const Statistics& statistics) {
  for (std::size_t i = 0; i < statistics.mean.size(); ++i) {
    mean_.push_back(static_cast<float>(statistics.mean[i]));
    scale_.push_back(static_cast<float>(statistics.scale(i)));
  }
}

void Normaliser::load(const float* rows, Simd* x) const {
  constexpr float kMost = 8.0F;
  const std::size_t width = mean_.size();
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      x[i].lane[l] = clamp((rows[l * width + i] - mean_[i]) * scale_[i], -kMost, kMost);
    }
  }
}

std::vector<float> folded(const Network& actor, std::vector<float> parameters,
                          const Statistics& statistics) {
  const Cell::Product first = actor.first();
  const std::size_t inputs = first.sizes.inputs;
  for (std::size_t j = 0; j < first.sizes.outputs; ++j) {
    float* weights = &parameters[first.weights + j * inputs];
    double bias = parameters[first.bias + j];
    for (std::size_t i = 0; i < inputs; ++i) {
      const double weight = weights[i] * statistics.scale(i);
      bias -= weight * statistics.mean[i];
      weights[i] = static_cast<float>(weight);
    }
    parameters[first.bias + j] = static_cast<float>(bias);
  }
  return parameters;
}

void keep_answers(const Network& network, std::vector<float>& parameters, const Statistics& before,
                  const Statistics& after) {
  const Cell::Product first = network.first();
  const std::size_t inputs = first.sizes.inputs;
  const std::size_t normalised = std::min(inputs, before.mean.size());
  for (std::size_t j = 0; j < first.sizes.outputs; ++j) {
    float* weights = &parameters[first.weights + j * inputs];
    double bias = parameters[first.bias + j];
    for (std::size_t i = 0; i < normalised; ++i) {
      const double weight = weights[i] * before.scale(i);
      bias += weight * (after.mean[i] - before.mean[i]);
      weights[i] = static_cast<float>(weight / after.scale(i));
    }
    parameters[first.bias + j] = static_cast<float>(bias);
  }
}

void Policy::answer(const Kernels& kernels, const float* rows, Simd* row) const {
  const std::size_t inputs = network.inputs();
  for (std::size_t i = 0; i < inputs; ++i) {
    for (std::size_t l = 0; l < kLanes; ++l) row[i].lane[l] = rows[l * inputs + i];
  }
  network.forward(kernels, parameters.data(), row);
  network.remember(row);
  if (!head.chooses) kernels.tanh(row + network.output(), network.outputs());
}

}  // namespace eagerx::train
