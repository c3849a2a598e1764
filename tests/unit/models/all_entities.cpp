// Every entity with float and double, as a program of a board compiles them: no library beside the
// runtime, no exceptions, no run-time types. compile_models.sh compiles it with every compiler.
#include <models/engine_nodes/action_applied/action_applied.hpp>
#include <models/engine_nodes/float_output/float_output.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>
#include <models/engine_nodes/ode_output/ode_output.hpp>
#include <models/engine_states/dummy_state/dummy_state.hpp>
#include <models/engine_states/ode_engine_state/ode_engine_state.hpp>
#include <models/engine_states/ode_parameters/ode_parameters.hpp>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/get_index/get_index.hpp>
#include <models/processors/identity/identity.hpp>
#include <models/processors/negate/negate.hpp>

#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models {

using testing::PendulumSimulator;

template <class Real, class Config>
using FilterIo = testing::FilterIo<Real, Config, eagerx::Rate<100>, Array<float, 2>>;
template <class Real, class Input, class Output>
using ProcessorIo = testing::ProcessorIo<Real, Input, Output>;

template class OdeInput<testing::OdeInputIo<PendulumSimulator<float>, testing::Latest>>;
template class OdeInput<testing::OdeInputIo<PendulumSimulator<double>, testing::Skipped>>;
template class OdeOutput<testing::OdeOutputIo<PendulumSimulator<float>>>;
template class OdeOutput<testing::OdeOutputIo<PendulumSimulator<double>>>;
template class FloatOutput<testing::FloatOutputIo<PendulumSimulator<float>, testing::Latest>>;
template class FloatOutput<testing::FloatOutputIo<PendulumSimulator<double>, testing::Skipped>>;
template class ActionApplied<testing::ActionAppliedIo<PendulumSimulator<float>>>;
template struct OdeEngineState<testing::StateIo<PendulumSimulator<float>, Array<float, 2>>>;
template struct OdeEngineState<testing::StateIo<PendulumSimulator<double>, Array<float, 2>>>;
template struct OdeParameters<testing::TwoParametersIo<PendulumSimulator<float>>>;
template struct OdeParameters<testing::OneParameterIo<PendulumSimulator<double>>>;
template struct DummyState<testing::StateIo<PendulumSimulator<float>, float>>;
template struct PendulumOde<testing::PendulumModelIo<float>>;
template struct PendulumOde<testing::PendulumModelIo<double>>;
template class ButterworthFilter<FilterIo<float, testing::Low2>>;
template class ButterworthFilter<FilterIo<float, testing::High3>>;
template class ButterworthFilter<FilterIo<double, testing::Band4>>;
template class ButterworthFilter<FilterIo<double, testing::Stop8>>;
template struct DecomposedAngle<ProcessorIo<float, float, Array<float, 2>>>;
template struct DecomposedAngle<ProcessorIo<double, float, Array<float, 2>>>;
template struct GetIndex<ProcessorIo<float, Array<float, 3>, Array<float, 1>>>;
template struct Negate<ProcessorIo<float, Array<float, 3>, Array<float, 3>>>;
template struct Negate<ProcessorIo<float, std::int16_t, std::int16_t>>;
template struct Identity<ProcessorIo<float, float, float>>;

// The state of a program: constant-initialised to zero bytes.
constinit PendulumSimulator<float> float_pendulum;
constinit PendulumSimulator<double> double_pendulum;
constinit ButterworthFilter<FilterIo<float, testing::Stop8>> filter;

void advance_all() {
  testing::tick<testing::EngineIo<float>>(float_pendulum);
  testing::tick<testing::EngineIo<float, testing::Rk4Config<30>>>(float_pendulum);
  testing::tick<testing::EngineIo<double>>(double_pendulum);
  testing::tick<testing::EngineIo<double, testing::Rk4Config<30>>>(double_pendulum);
}

}  // namespace eagerx::models
