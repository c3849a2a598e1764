// Sets parameters of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: parameter indices[i] := value[i]. The value has shape [n] for n indices, or [] for
/// one; if it has as many elements as there are parameters, it is value[indices[i]]. The other
/// parameters are unchanged.
template <class Io>
struct OdeParameters {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    static_assert(kOwn || size_of<typename Io::State> == Io::Simulator::Model::kParameters,
                  "OdeParameters: the state must have as many elements as `indices`, or as the "
                  "model has parameters");
    static_assert(indices_exist(),
                  "OdeParameters: an element of `indices` is not a parameter of the model");
    for (std::size_t i = 0; i < kCount; ++i) {
      simulator.parameters[static_cast<std::size_t>(Io::Config::indices[i])] =
          static_cast<typename Io::Simulator::Real>(element(value, position(i)));
    }
  }

 private:
  static constexpr std::size_t kCount = Io::Config::indices.size();
  static constexpr bool kOwn = size_of<typename Io::State> == kCount;

  static constexpr std::size_t position(std::size_t i) {
    return kOwn ? i : static_cast<std::size_t>(Io::Config::indices[i]);
  }

  static constexpr bool indices_exist() {
    for (const auto index : Io::Config::indices) {
      if (index < 0 || static_cast<std::size_t>(index) >= Io::Simulator::Model::kParameters) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace eagerx::models
