// A network of dense layers with tanh or relu between them, and an optional memory before them,
// forward and backward.
#pragma once

#include <eagerx/random.hpp>
#include <optional>
#include <vector>

#include "targets/environments/train/kernels.hpp"
#include "targets/environments/train/recurrent/cell.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

/// The shape of a network; its parameters are floats of the caller. The scratch data of a tile
/// (sixteen samples) is a row of SIMD vectors: [inputs | memory | hidden 1 | … | outputs].
class Network {
 public:
  struct Layer {
    DenseSizes sizes;
    std::size_t weights, bias;  // where they begin in the parameters; weights [outputs][inputs]
    std::size_t from, to;       // where its inputs and outputs begin in the row of SIMD vectors
  };

  Network(std::size_t inputs, const std::vector<std::size_t>& hidden, std::size_t outputs,
          Activation activation, CellShape memory = {});

  const std::vector<Layer>& layers() const { return layers_; }
  Activation activation() const { return activation_; }
  const Cell* memory() const { return cell_ ? &*cell_ : nullptr; }
  /// The factors of the inputs.
  Cell::Product first() const;
  std::size_t inputs() const { return first().sizes.inputs; }
  std::size_t outputs() const { return layers_.back().sizes.outputs; }
  std::size_t parameters() const { return parameters_; }
  /// SIMD vectors in the row of one tile.
  std::size_t row() const { return row_; }
  /// Where the outputs begin in a row.
  std::size_t output() const { return layers_.back().to; }

  /// [parameters], normal with a deviation of 1/√inputs, in the last layer `gain` times that.
  std::vector<float> sampled(Random random, float gain) const;

  /// Fills the rest of `row`, which has the inputs and the previous state. The outputs have no
  /// activation.
  void forward(const Kernels& kernels, const float* parameters, Simd* row) const;

  /// The state after the step of `row` is that before the next one.
  void remember(Simd* row) const;

  /// Adds the gradient of `tiles` rows to `gradient` [parameters]. `deltas` [tiles][row()]: the
  /// caller has filled the outputs' places with the derivatives of the loss; the others are
  /// written. With a memory the rows follow one another in time, see Cell::backward().
  void backward(const Kernels& kernels, const float* parameters, const Simd* rows, Simd* deltas,
                std::size_t tiles, Simd* scratch, float* gradient,
                const Simd* continues = nullptr) const;

  /// Without a memory: fills the rest of `deltas` [row()], whose outputs' places have the
  /// derivatives of something: its derivatives by the inputs are in the first places.
  void input_slopes(const Kernels& kernels, const float* parameters, const Simd* row,
                    Simd* deltas) const;

 private:
  Activation activation_;
  std::optional<Cell> cell_;
  std::vector<Layer> layers_;
  std::size_t parameters_ = 0, row_ = 0;
};

/// Adam's moments of each weight.
class Adam {
 public:
  explicit Adam(std::size_t count) : mean(count), square(count) {}

  /// One step against `gradient_scale` times the gradient.
  void step(const Kernels& kernels, std::vector<float>& weights, const std::vector<float>& gradient,
            float step_size, float gradient_scale);

  std::vector<float> mean, square;
  std::uint64_t steps = 0;
};

}  // namespace eagerx::train
