// Recurrent layers of trained networks: GRU, LSTM and histories, one observation at a time, in
// float32.
//
// Both products are dense layers (eagerx/policy.hpp) with their own biases, so their sums have the
// same order and the same bits on every machine; what follows is element by element. `Layer` is
// DenseWeights or, with weights of eight bits, Int8Weights (eagerx/policy/int8.hpp).
#pragma once

#include <cstddef>
#include <eagerx/policy.hpp>

namespace eagerx {

/// Weights of a GRU with torch's gates: reset, update, candidate, `Hidden` rows each.
template <std::size_t In, std::size_t Hidden,
          template <std::size_t, std::size_t> class Layer = DenseWeights>
struct GruWeights {
  Layer<In, 3 * Hidden> input;
  Layer<Hidden, 3 * Hidden> hidden;
};

/// The state of a GRU; zero when an episode starts.
template <std::size_t Hidden, class R = float>
struct GruMemory {
  R h[Hidden];
};

/// r = sigmoid(Wr x + Ur h), z = sigmoid(Wz x + Uz h), n = tanh(Wn x + r (Un h)), each product with
/// its bias; h = n + z (h - n) is the new state and the result. `x` and `y` must not overlap.
template <class R, std::size_t In, std::size_t Hidden,
          template <std::size_t, std::size_t> class Layer>
inline void gru(const GruWeights<In, Hidden, Layer>& layer, const R (&x)[In],
                GruMemory<Hidden, R>& memory, R (&y)[Hidden]) {
  R from_input[3 * Hidden];
  R from_hidden[3 * Hidden];
  dense<Activation::identity>(layer.input, x, from_input);
  dense<Activation::identity>(layer.hidden, memory.h, from_hidden);
  R gates[2 * Hidden];
  for (std::size_t k = 0; k < 2 * Hidden; ++k) gates[k] = from_input[k] + from_hidden[k];
  activate<Activation::sigmoid>(gates);
  for (std::size_t k = 0; k < Hidden; ++k) {
    y[k] = from_input[2 * Hidden + k] + gates[k] * from_hidden[2 * Hidden + k];
  }
  activate<Activation::tanh>(y);
  for (std::size_t k = 0; k < Hidden; ++k) {
    y[k] = y[k] + gates[Hidden + k] * (memory.h[k] - y[k]);
    memory.h[k] = y[k];
  }
}

/// Weights of an LSTM with torch's gates: input, forget, candidate, output, `Hidden` rows each.
template <std::size_t In, std::size_t Hidden,
          template <std::size_t, std::size_t> class Layer = DenseWeights>
struct LstmWeights {
  Layer<In, 4 * Hidden> input;
  Layer<Hidden, 4 * Hidden> hidden;
};

/// The state of an LSTM; zero when an episode starts.
template <std::size_t Hidden, class R = float>
struct LstmMemory {
  R h[Hidden];
  R c[Hidden];
};

/// i, f, o = sigmoid(W x + U h), g = tanh(Wg x + Ug h), each product with its bias; c = f c + i g
/// and h = o tanh(c) are the new state, and h is the result. `x` and `y` must not overlap.
template <class R, std::size_t In, std::size_t Hidden,
          template <std::size_t, std::size_t> class Layer>
inline void lstm(const LstmWeights<In, Hidden, Layer>& layer, const R (&x)[In],
                 LstmMemory<Hidden, R>& memory, R (&y)[Hidden]) {
  R from_input[4 * Hidden];
  R from_hidden[4 * Hidden];
  dense<Activation::identity>(layer.input, x, from_input);
  dense<Activation::identity>(layer.hidden, memory.h, from_hidden);
  R gates[3 * Hidden];  // input, forget, output
  R candidate[Hidden];
  for (std::size_t k = 0; k < Hidden; ++k) {
    gates[k] = from_input[k] + from_hidden[k];
    gates[Hidden + k] = from_input[Hidden + k] + from_hidden[Hidden + k];
    candidate[k] = from_input[2 * Hidden + k] + from_hidden[2 * Hidden + k];
    gates[2 * Hidden + k] = from_input[3 * Hidden + k] + from_hidden[3 * Hidden + k];
  }
  activate<Activation::sigmoid>(gates);
  activate<Activation::tanh>(candidate);
  for (std::size_t k = 0; k < Hidden; ++k) {
    memory.c[k] = gates[Hidden + k] * memory.c[k] + gates[k] * candidate[k];
    y[k] = memory.c[k];
  }
  activate<Activation::tanh>(y);
  for (std::size_t k = 0; k < Hidden; ++k) {
    y[k] = gates[2 * Hidden + k] * y[k];
    memory.h[k] = y[k];
  }
}

/// The values before, oldest first; zero when an episode starts.
template <std::size_t Count, class R = float>
struct HistoryMemory {
  R values[Count];
};

/// y: the values before, then `x`; all but the oldest are remembered. `x` and `y` must not overlap.
template <class R, std::size_t In, std::size_t Count, std::size_t Out>
inline void history(const R (&x)[In], HistoryMemory<Count, R>& memory, R (&y)[Out]) {
  static_assert(Out == In + Count, "a history has the values before and the new one");
  for (std::size_t i = 0; i < Count; ++i) y[i] = memory.values[i];
  for (std::size_t i = 0; i < In; ++i) y[Count + i] = x[i];
  for (std::size_t i = 0; i < Count; ++i) memory.values[i] = y[In + i];
}

}  // namespace eagerx
