// Sets an attribute of an environment on GymEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: attribute `attribute` of the model := value [].
template <class Io>
struct SetGymAttribute {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    static_assert(size_of<typename Io::State> == 1, "SetGymAttribute: an attribute is one number");
    static_assert(kIndex < Model::kAttributes,
                  "SetGymAttribute: the model has no attribute called `attribute`");
    simulator.attributes[kIndex] = static_cast<typename Model::Real>(element(value, 0));
  }

 private:
  using Model = typename Io::Simulator::Model;

  static constexpr bool equal(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) ++a, ++b;
    return *a == *b;
  }
  static constexpr std::size_t find() {
    std::size_t i = 0;
    while (i < Model::kAttributes && !equal(Model::kAttributeNames[i], Io::Config::attribute)) ++i;
    return i;
  }
  static constexpr std::size_t kIndex = find();
};

}  // namespace eagerx::models
