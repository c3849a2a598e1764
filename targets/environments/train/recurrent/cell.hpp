// A GRU or LSTM in front of a network's layers, one step at a time and backward through time.
#pragma once

#include <eagerx/random.hpp>
#include <vector>

#include "targets/environments/train/kernels.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

/// The recurrent cell of a network.
struct CellShape {
  Memory memory = Memory::none;
  std::size_t units = 0;

  /// Numbers that are remembered: h, and c of an LSTM.
  std::size_t state() const {
    return memory == Memory::none ? 0 : memory == Memory::gru ? units : 2 * units;
  }
};

/// The shape of a cell, with the formulas of runtime/eagerx/policy/recurrent.hpp. Its parameters
/// come first among the network's, in torch's order: weight_ih [gates * units][inputs], weight_hh
/// [gates * units][units], bias_ih, bias_hh. So does its part of the row of SIMD vectors:
/// [inputs | state before | gates | products | state after], a state being h, then c.
class Cell {
 public:
  /// Throws nothing; `shape` has a memory.
  Cell(CellShape shape, std::size_t inputs);

  struct Product {
    DenseSizes sizes;
    std::size_t weights, bias;  // where they begin in the parameters; weights [outputs][inputs]
  };

  CellShape shape() const { return shape_; }
  /// Of the inputs and of h.
  const Product& from_input() const { return from_input_; }
  const Product& from_state() const { return from_state_; }
  std::size_t parameters() const { return from_state_.bias + gates_; }
  /// Where the states begin in a row, and the SIMD vectors of a row that belong to the cell.
  std::size_t before() const { return from_input_.sizes.inputs; }
  std::size_t after() const { return products() + gates_; }
  std::size_t end() const { return after() + shape_.state(); }

  /// Weights normal with a deviation of 1/√inputs; biases 0, of an LSTM's forget gate 1
  /// (Jozefowicz, Zaremba, Sutskever 2015): at first it keeps its state.
  void sample(Random& random, float* parameters) const;

  /// Fills the rest of the cell's part of `row`, which has the inputs and the previous state.
  void forward(const Kernels& kernels, const float* parameters, Simd* row) const;

  /// Adds the gradient of `steps` rows that follow one another to `gradient`. `deltas`: the caller
  /// has filled those of h after; others are written. `continues` [steps]: 1 where the state before
  /// is that after the row before, 0 where an episode begins.
  void backward(const Kernels& kernels, const float* parameters, const Simd* rows, Simd* deltas,
                std::size_t steps, std::size_t stride, const Simd* continues, Simd* scratch,
                float* gradient) const;

 private:
  std::size_t gates() const { return before() + shape_.state(); }
  std::size_t products() const { return gates() + gates_; }
  void step_back(const Kernels& kernels, const float* parameters, const Simd* row,
                 Simd* delta) const;

  CellShape shape_;
  std::size_t gates_;  // numbers of all of them
  Product from_input_, from_state_;
};

}  // namespace eagerx::train
