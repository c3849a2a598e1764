#include "generator/policy/network/evaluate_layer.hpp"

#include <cmath>
#include <eagerx/policy.hpp>
#include <optional>
#include <type_traits>

#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/sums.hpp"

namespace eagerx::gen {
namespace {

template <class Real>
using Values = std::vector<Real>;

float sigmoid_of(float x) {
  return eagerx::sigmoid(x);
}
double sigmoid_of(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}
float tanh_of(float x) {
  return eagerx::tanh(x);
}
double tanh_of(double x) {
  return std::tanh(x);
}

/// W x + b with weights of eight bits, if a program has them; float64 is never rounded.
Values<float> rounded_product(const Int8Rows& rows, const Values<float>& x) {
  return int8_product(rows, x);
}
Values<double> rounded_product(const Int8Rows& /*rows*/, const Values<double>& /*x*/) {
  return {};
}
template <class Real>
bool is_rounded(const std::vector<std::int8_t>& rounded) {
  return std::is_same_v<Real, float> && !rounded.empty();
}

/// W x + b, row-major.
template <class Real>
Values<Real> product(const std::vector<float>& weights, const std::vector<float>& bias,
                     const std::vector<std::int8_t>& rounded, const std::vector<float>& scales,
                     const Values<Real>& x) {
  if (is_rounded<Real>(rounded)) {
    return rounded_product({rounded.data(), scales.data(), bias.data(), bias.size()}, x);
  }
  Values<Real> y(bias.size());
  for (std::size_t out = 0; out < y.size(); ++out) {
    const float* row = weights.data() + out * x.size();
    y[out] = sum_of_output(static_cast<Real>(bias[out]), out, y.size(), x.size(),
                           [&](std::size_t i) { return static_cast<Real>(row[i]) * x[i]; });
  }
  return y;
}

template <class Real>
Values<Real> gru(const Layer& layer, const Recurrence& cell, const Values<Real>& x,
                 Values<Real>& h) {
  const std::size_t n = layer.outputs;
  const Values<Real> a = product(layer.weights, layer.bias, layer.rounded, layer.scales, x);
  const Values<Real> b =
      product(cell.hidden_weights, cell.hidden_bias, cell.hidden_rounded, cell.hidden_scales, h);
  Values<Real> y(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Real reset = sigmoid_of(a[k] + b[k]);
    const Real update = sigmoid_of(a[n + k] + b[n + k]);
    const Real candidate = tanh_of(a[2 * n + k] + reset * b[2 * n + k]);
    y[k] = candidate + update * (h[k] - candidate);
  }
  h = y;
  return y;
}

/// `memory` is h, then c.
template <class Real>
Values<Real> lstm(const Layer& layer, const Recurrence& cell, const Values<Real>& x,
                  Values<Real>& memory) {
  const std::size_t n = layer.outputs;
  const Values<Real> h(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(n));
  const Values<Real> a = product(layer.weights, layer.bias, layer.rounded, layer.scales, x);
  const Values<Real> b =
      product(cell.hidden_weights, cell.hidden_bias, cell.hidden_rounded, cell.hidden_scales, h);
  Values<Real> y(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Real input = sigmoid_of(a[k] + b[k]);
    const Real forget = sigmoid_of(a[n + k] + b[n + k]);
    const Real candidate = tanh_of(a[2 * n + k] + b[2 * n + k]);
    const Real output = sigmoid_of(a[3 * n + k] + b[3 * n + k]);
    Real& c = memory[n + k];
    c = forget * c + input * candidate;
    y[k] = output * tanh_of(c);
    memory[k] = y[k];
  }
  return y;
}

/// Index into a channel of kernel element `k` at `place`; nothing in the padding.
std::optional<std::size_t> under(const KernelShape& kernel, std::size_t place, std::size_t k) {
  const auto down = static_cast<std::int64_t>(place / kernel.out_width);
  const auto right = static_cast<std::int64_t>(place % kernel.out_width);
  const auto row = static_cast<std::int64_t>(k / kernel.columns);
  const auto column = static_cast<std::int64_t>(k % kernel.columns);
  const std::int64_t y = down * kernel.stride_down + row * kernel.dilation_down - kernel.pad_top;
  const std::int64_t x =
      right * kernel.stride_right + column * kernel.dilation_right - kernel.pad_left;
  if (y < 0 || x < 0 || y >= kernel.height || x >= kernel.width) return std::nullopt;
  return static_cast<std::size_t>(y * kernel.width + x);
}

template <class Real>
Values<Real> convolve(const Layer& layer, const Convolution& form, const Values<Real>& x) {
  const KernelShape& kernel = form.kernel;
  const std::size_t read = kernel.channels / form.groups;  // channels of a group
  const std::size_t made = form.channels / form.groups;
  const std::size_t area = std::size_t{kernel.height} * kernel.width;
  const std::size_t size = std::size_t{kernel.rows} * kernel.columns;
  const std::size_t places = kernel.places();
  Values<Real> y(layer.outputs);
  Values<Real> patch(read * size);
  for (std::size_t group = 0; group < form.groups; ++group) {
    for (std::size_t place = 0; place < places; ++place) {
      for (std::size_t i = 0; i < patch.size(); ++i) {
        const auto at = under(kernel, place, i % size);
        patch[i] = at ? x[(group * read + i / size) * area + *at] : Real(0);
      }
      if (is_rounded<Real>(layer.rounded)) {
        const std::size_t first = group * made;
        const auto values =
            rounded_product({layer.rounded.data() + first * patch.size(),
                             layer.scales.data() + first, layer.bias.data() + first, made},
                            patch);
        for (std::size_t k = 0; k < made; ++k) y[(first + k) * places + place] = values[k];
        continue;
      }
      for (std::size_t out = group * made; out < (group + 1) * made; ++out) {
        const float* weights = layer.weights.data() + out * patch.size();
        y[out * places + place] = sum_of_output(
            static_cast<Real>(layer.bias[out]), out - group * made, made, patch.size(),
            [&](std::size_t i) { return static_cast<Real>(weights[i]) * patch[i]; });
      }
    }
  }
  return y;
}

/// The values under the kernel; those in the padding are zero, and not counted in `inside`.
template <class Real>
Values<Real> patch_of(const KernelShape& kernel, const Values<Real>& x, std::size_t channel,
                      std::size_t place, std::size_t& inside) {
  Values<Real> patch(std::size_t{kernel.rows} * kernel.columns, Real(0));
  inside = 0;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const auto at = under(kernel, place, k);
    if (!at) continue;
    patch[k] = x[channel * kernel.height * kernel.width + *at];
    ++inside;
  }
  return patch;
}

template <class Real>
Real largest_under(const KernelShape& kernel, const Values<Real>& x, std::size_t channel,
                   std::size_t place) {
  std::optional<Real> best;
  for (std::size_t k = 0; k < std::size_t{kernel.rows} * kernel.columns; ++k) {
    const auto at = under(kernel, place, k);
    if (!at) continue;
    const Real value = x[channel * kernel.height * kernel.width + *at];
    if (!best || *best < value || value != value) best = value;
  }
  return best.value_or(Real(0));
}

template <class Real>
Values<Real> pool(const Layer& layer, const Pooling& form, const Values<Real>& x) {
  const std::size_t places = form.kernel.places();
  Values<Real> y(layer.outputs);
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (form.kind == Pooling::Kind::max) {
      y[i] = largest_under(form.kernel, x, i / places, i % places);
      continue;
    }
    std::size_t inside = 0;
    const Values<Real> patch = patch_of(form.kernel, x, i / places, i % places, inside);
    const std::size_t count = form.kind == Pooling::Kind::average ? inside : patch.size();
    y[i] = grouped_sum(Real(0), patch.size(), [&](std::size_t k) { return patch[k]; }) /
           static_cast<Real>(count);
  }
  return y;
}

template <class Real>
Real operated(Elementwise::Operation operation, Real x, Real c) {
  using Operation = Elementwise::Operation;
  switch (operation) {
    case Operation::add:
      return x + c;
    case Operation::subtract:
      return x - c;
    case Operation::multiply:
      return x * c;
    case Operation::divide:
      return x / c;
    case Operation::at_least:
      return x < c ? c : x;
    case Operation::at_most:
      return c < x ? c : x;
    case Operation::none:
      break;
  }
  return x;
}

float function_of(Function::Kind kind, float x) {
  switch (kind) {
    case Function::Kind::sin:
      return eagerx::sin(x);
    case Function::Kind::cos:
      return eagerx::cos(x);
    case Function::Kind::exp:
      return eagerx::exp(x);
    case Function::Kind::abs:
      return eagerx::abs(x);
    case Function::Kind::above_zero:
      return x > 0.0F ? 1.0F : 0.0F;
    case Function::Kind::round_to_even:
      return eagerx::round_to_even(x);
    case Function::Kind::floor:
      return eagerx::floor(x);
    case Function::Kind::ceil:
      return eagerx::ceil(x);
    case Function::Kind::sqrt:
      break;
  }
  return eagerx::sqrt(x);
}
double function_of(Function::Kind kind, double x) {
  switch (kind) {
    case Function::Kind::sin:
      return std::sin(x);
    case Function::Kind::cos:
      return std::cos(x);
    case Function::Kind::exp:
      return std::exp(x);
    case Function::Kind::abs:
      return std::fabs(x);
    case Function::Kind::above_zero:
      return x > 0.0 ? 1.0 : 0.0;
    case Function::Kind::round_to_even:
      return eagerx::round_to_even(x);
    case Function::Kind::floor:
      return std::floor(x);
    case Function::Kind::ceil:
      return std::ceil(x);
    case Function::Kind::sqrt:
      break;
  }
  return std::sqrt(x);
}

/// In the order of the numbers, as eagerx/policy/branches.hpp.
template <class Real>
Values<Real> reduce(const Reduction& form, const Values<Real>& x) {
  Values<Real> y;
  for (std::size_t first = 0; first < x.size(); first += form.length) {
    Real sum(0);
    for (std::size_t i = first; i < first + form.length; ++i) {
      const Real term = form.kind == Reduction::Kind::norm ? x[i] * x[i] : x[i];
      sum = sum + term;
    }
    if (form.kind == Reduction::Kind::mean) sum = sum / static_cast<Real>(form.length);
    if (form.kind == Reduction::Kind::norm) sum = function_of(Function::Kind::sqrt, sum);
    y.push_back(sum);
  }
  return y;
}

template <class Real>
Real combined(Combination::Operation operation, Real a, Real b) {
  using Operation = Combination::Operation;
  switch (operation) {
    case Operation::sum:
      return a + b;
    case Operation::difference:
      return a - b;
    case Operation::product:
      return a * b;
    case Operation::quotient:
      return a / b;
    case Operation::join:
    case Operation::select:
      break;
  }
  return b;
}

/// `x`: a condition and two values, one behind the other.
template <class Real>
Values<Real> select(const Layer& layer, const Combination& form, const Values<Real>& x) {
  const std::size_t condition = form.sizes[0];
  const std::size_t first = form.sizes[1];
  const std::size_t second = form.sizes[2];
  Values<Real> y(layer.outputs);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const bool is_first = x[condition == 1 ? 0 : i] != Real(0);
    const std::size_t at =
        is_first ? condition + (first == 1 ? 0 : i) : condition + first + (second == 1 ? 0 : i);
    y[i] = x[at];
  }
  return y;
}

/// `x`: its values, one behind the other.
template <class Real>
Values<Real> combine(const Layer& layer, const Combination& form, const Values<Real>& x) {
  if (form.operation == Combination::Operation::join) return x;
  if (form.operation == Combination::Operation::select) return select(layer, form, x);
  Values<Real> y(layer.outputs);
  std::size_t first = 0;
  for (const std::uint32_t size : form.sizes) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const Real value = x[first + (size == 1 ? 0 : i)];
      y[i] = first == 0 ? value : combined(form.operation, y[i], value);
    }
    first += size;
  }
  return y;
}

template <class Real>
Values<Real> answer_of(const Layer& layer, const Values<Real>& x, Values<Real>& memory) {
  if (const auto* form = std::get_if<Convolution>(&layer.form)) return convolve(layer, *form, x);
  if (const auto* form = std::get_if<Pooling>(&layer.form)) return pool(layer, *form, x);
  if (const Recurrence* cell = layer.recurrence()) {
    memory.resize(layer.remembers(), Real(0));
    return cell->is_lstm ? lstm(layer, *cell, x, memory) : gru(layer, *cell, x, memory);
  }
  if (std::holds_alternative<History>(layer.form)) {
    memory.resize(layer.remembers(), Real(0));
    memory.insert(memory.end(), x.begin(), x.end());
    const Values<Real> y = memory;
    memory.erase(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(x.size()));
    return y;
  }
  if (const auto* form = std::get_if<Reorder>(&layer.form)) {
    Values<Real> y;
    y.reserve(form->from.size());
    for (const std::uint32_t from : form->from) y.push_back(x[from]);
    return y;
  }
  if (const auto* form = std::get_if<Combination>(&layer.form)) return combine(layer, *form, x);
  if (const auto* form = std::get_if<Reduction>(&layer.form)) return reduce(*form, x);
  if (const auto* form = std::get_if<Function>(&layer.form)) {
    Values<Real> y;
    for (const Real value : x) y.push_back(function_of(form->kind, value));
    return y;
  }
  if (const auto* form = std::get_if<Elementwise>(&layer.form)) {
    Values<Real> y(x);
    for (std::size_t i = 0; i < y.size() && !layer.bias.empty(); ++i) {
      const float c = layer.bias[layer.bias.size() == 1 ? 0 : i];
      y[i] = operated(form->operation, x[i], static_cast<Real>(c));
    }
    return y;
  }
  return product(layer.weights, layer.bias, layer.rounded, layer.scales, x);
}

}  // namespace

std::vector<float> evaluate_layer(const Layer& layer, const std::vector<float>& x,
                                  std::vector<float>& memory) {
  return answer_of(layer, x, memory);
}

std::vector<double> evaluate_layer(const Layer& layer, const std::vector<double>& x,
                                   std::vector<double>& memory) {
  return answer_of(layer, x, memory);
}

}  // namespace eagerx::gen
