// Requirements of RealEngine on the wiring of a real object.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A model of a real object: its devices and the meaning of their numbers. It has
///   using Real = …;                                     // float or double
///   static constexpr std::size_t kSensors, kActuators;  // at least 1
///   void reset();                                       // an episode begins
///   template <class Bus> void request(Bus&);            // queues what measures all sensors
///   BusError measure(std::int64_t now_ns, Array<Real, kSensors>&);  // the answer; now_ns: when
///   template <class Bus> void act(Bus&, const Array<Real, kActuators>&);  // queues a command
/// After an error of measure() the values are unchanged.
template <class Model>
concept HardwareModel = (Model::kSensors > 0) && (Model::kActuators > 0) &&
                        requires(Model& model, Array<typename Model::Real, Model::kSensors>& values,
                                 std::int64_t now_ns) {
  model.reset();
  { model.measure(now_ns, values) } -> std::same_as<BusError>;
};

}  // namespace eagerx::models
