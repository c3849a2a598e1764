// Sets parameters of a model on OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: parameter indices[i] := value[i]; the others are unchanged.
template <class Io>
struct ModelParameters {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    static_assert(size_of<typename Io::State> == kCount,
                  "ModelParameters: the state must have as many elements as `indices`");
    static_assert(indices_exist(),
                  "ModelParameters: an element of `indices` is not a parameter of the model");
    for (std::size_t i = 0; i < kCount; ++i) {
      simulator.parameters[static_cast<std::size_t>(Io::Config::indices[i])] =
          static_cast<typename Io::Simulator::Number>(element(value, i));
    }
    simulator.reconfigure();
  }

 private:
  static constexpr std::size_t kCount = Io::Config::indices.size();

  static constexpr bool indices_exist() {
    for (const auto index : Io::Config::indices) {
      if (index < 0 || static_cast<std::size_t>(index) >= Io::Simulator::parameter_count()) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace eagerx::models
