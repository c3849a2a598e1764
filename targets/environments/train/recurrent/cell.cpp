#include "targets/environments/train/recurrent/cell.hpp"

#include <algorithm>
#include <eagerx/math.hpp>

namespace eagerx::train {

Cell::Cell(CellShape shape, std::size_t inputs)
    : shape_(shape), gates_((shape.memory == Memory::lstm ? 4 : 3) * shape.units) {
  const std::size_t hidden = gates_ * inputs;
  const std::size_t biases = hidden + gates_ * shape.units;
  from_input_ = {{inputs, gates_}, 0, biases};
  from_state_ = {{shape.units, gates_}, hidden, biases + gates_};
}

void Cell::sample(Random& random, float* parameters) const {
  std::fill_n(parameters, this->parameters(), 0.0F);
  for (const Product& product : {from_input_, from_state_}) {
    const float deviation = 1.0F / sqrt(static_cast<float>(product.sizes.inputs));
    const std::size_t count = product.sizes.inputs * product.sizes.outputs;
    for (std::size_t i = 0; i < count; ++i)
      parameters[product.weights + i] = random.normal(0.0F, deviation);
  }
  if (shape_.memory == Memory::lstm)
    std::fill_n(parameters + from_input_.bias + shape_.units, shape_.units, 1.0F);
}

void Cell::forward(const Kernels& kernels, const float* parameters, Simd* row) const {
  kernels.dense(from_input_.sizes, parameters + from_input_.weights, parameters + from_input_.bias,
                row, row + gates());
  kernels.dense(from_state_.sizes, parameters + from_state_.weights, parameters + from_state_.bias,
                row + before(), row + products());
  const auto remember = shape_.memory == Memory::lstm ? kernels.lstm : kernels.gru;
  remember(shape_.units, row + gates(), row + products(), row + before(), row + after());
}

/// The derivatives by the gates, and by the state before: by what does not pass through a product
/// in the places of the state after.
void Cell::step_back(const Kernels& kernels, const float* parameters, const Simd* row,
                     Simd* delta) const {
  const auto slopes = shape_.memory == Memory::lstm ? kernels.lstm_slopes : kernels.gru_slopes;
  slopes(shape_.units, row + gates(), row + products(), row + before(), delta + after(),
         delta + gates(), delta + products());
  kernels.dense_transposed(from_state_.sizes, parameters + from_state_.weights, delta + products(),
                           delta + before());
}

void Cell::backward(const Kernels& kernels, const float* parameters, const Simd* rows, Simd* deltas,
                    std::size_t steps, std::size_t stride, const Simd* continues, Simd* scratch,
                    float* gradient) const {
  const std::size_t units = shape_.units, state = shape_.state();
  for (std::size_t t = 0; t < steps; ++t)
    std::fill_n(deltas + t * stride + after() + units, state - units, Simd{});
  for (std::size_t t = steps; t-- > 0;) {
    Simd* delta = deltas + t * stride;
    step_back(kernels, parameters, rows + t * stride, delta);
    if (t == 0) break;
    std::fill_n(delta + before() + units, state - units, Simd{});  // c passes through none
    kernels.carry(continues[t], delta + before(), delta + after(), delta - stride + after(), state);
  }
  kernels.dense_gradient(from_input_.sizes, rows, deltas + gates(), steps, stride, scratch,
                         gradient + from_input_.weights, gradient + from_input_.bias);
  kernels.dense_gradient(from_state_.sizes, rows + before(), deltas + products(), steps, stride,
                         scratch, gradient + from_state_.weights, gradient + from_state_.bias);
}

}  // namespace eagerx::train
