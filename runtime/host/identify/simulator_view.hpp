// A simulator without its type: what an experiment changes of it.
#pragma once

#include <cstddef>
#include <type_traits>

namespace eagerx::identification {

/// Numbers of either kind, which are somebody else's.
struct Numbers {
  float* floats = nullptr;
  double* doubles = nullptr;
  std::size_t size = 0;

  double get(std::size_t i) const { return floats != nullptr ? double{floats[i]} : doubles[i]; }
  void set(std::size_t i, double value) const {
    if (floats != nullptr) {
      floats[i] = static_cast<float>(value);
    } else {
      doubles[i] = value;
    }
  }
};

struct SimulatorView {
  Numbers state, input;
  /// The length of its next step, where it chooses that itself; zero bytes: as at the beginning.
  void* step = nullptr;
  std::size_t step_bytes = 0;
};

/// A simulator whose state and input can be set: OdeSimulator, and others of its form.
template <class Simulator>
concept HasDynamics = requires(Simulator& simulator) {
  requires std::is_floating_point_v<std::remove_cvref_t<decltype(simulator.state[0])>>;
  requires std::is_floating_point_v<std::remove_cvref_t<decltype(simulator.input[0])>>;
  simulator.state.size();
  simulator.input.size();
  simulator.input.begin();
};

template <class Array>
Numbers numbers_of(Array& array) {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(array[0])>, float>) {
    return {array.begin(), nullptr, array.size()};
  } else {
    return {nullptr, array.begin(), array.size()};
  }
}

template <HasDynamics Simulator>
SimulatorView view_of(Simulator& simulator) {
  SimulatorView view{numbers_of(simulator.state), numbers_of(simulator.input)};
  if constexpr (requires { simulator.step_s; }) {
    static_assert(std::is_trivially_copyable_v<decltype(simulator.step_s)>);
    view.step = &simulator.step_s;
    view.step_bytes = sizeof simulator.step_s;
  }
  return view;
}

}  // namespace eagerx::identification
