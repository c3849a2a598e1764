// OdeEngine's data of each object.
#pragma once

#include <cstdint>
#include <eagerx/math/vocabulary.hpp>
#include <limits>
#include <models/engines/ode_engine/ode_model.hpp>

namespace eagerx::models {

/// State, input and parameters of one object. All bytes are zero until the first reset().
template <OdeModel ModelType>
class OdeSimulator {
 public:
  using Model = ModelType;
  using Real = typename Model::Real;

  OdeState<Model> state{};              // [kStates]
  OdeInputs<Model> input{};             // [kInputs], constant during an engine tick
  OdeParameterSet<Model> parameters{};  // [kParameters]
  Real step_s{};                        // adaptive methods: size of the next step, 0: not known yet

  /// State and input zero, parameters the model's defaults. The faults stay.
  void reset() {
    state = {};
    input = {};
    parameters = Model::default_parameters();
    step_s = {};
  }

  /// Number of engine ticks that could not be integrated as configured, since the start of the
  /// program; saturates. See OdeEngine for what happens to the state.
  CountOf<Real> faults() const { return faults_; }
  /// Calls f(name, count) for each count in the summary.
  template <class F>
  void for_each_count(F&& f) const {
    f("integration faults", std::uint64_t{faults_});
  }
  void add_fault_if(TruthOf<Real> wrong) {
    const CountOf<Real> most(std::numeric_limits<std::uint32_t>::max());
    faults_ += one_if<Real>(wrong && faults_ != most);
  }

 private:
  CountOf<Real> faults_{};
};

}  // namespace eagerx::models
