// Every entity with float and double, as a program of a board compiles them: no library besides the
// runtime, no exceptions, no run-time types. compile_models.sh compiles it with every compiler.
#include <models/engine_nodes/action_actuator/action_actuator.hpp>
#include <models/engine_nodes/action_applied/action_applied.hpp>
#include <models/engine_nodes/custom_ode_input/custom_ode_input.hpp>
#include <models/engine_nodes/float_output/float_output.hpp>
#include <models/engine_nodes/observation_sensor/observation_sensor.hpp>
#include <models/engine_nodes/ode_float_output/ode_float_output.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>
#include <models/engine_nodes/ode_output/ode_output.hpp>
#include <models/engine_nodes/reward_sensor/reward_sensor.hpp>
#include <models/engine_nodes/terminated_sensor/terminated_sensor.hpp>
#include <models/engine_nodes/truncated_sensor/truncated_sensor.hpp>
#include <models/engine_states/dummy_state/dummy_state.hpp>
#include <models/engine_states/gym_state/gym_state.hpp>
#include <models/engine_states/ode_engine_state/ode_engine_state.hpp>
#include <models/engine_states/ode_parameters/ode_parameters.hpp>
#include <models/engine_states/set_gym_attribute/set_gym_attribute.hpp>
#include <models/engines/gym_engine/gym_engine.hpp>
#include <models/nodes/action_limits/action_limits.hpp>
#include <models/nodes/backlash/backlash.hpp>
#include <models/nodes/body_motion/body_motion.hpp>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/nodes/complementary_filter/complementary_filter.hpp>
#include <models/nodes/computed_torque/computed_torque.hpp>
#include <models/nodes/constant/constant.hpp>
#include <models/nodes/counter/counter.hpp>
#include <models/nodes/dead_zone/dead_zone.hpp>
#include <models/nodes/demux/demux.hpp>
#include <models/nodes/derivative/derivative.hpp>
#include <models/nodes/difference/difference.hpp>
#include <models/nodes/discrete_transfer_function/discrete_transfer_function.hpp>
#include <models/nodes/extended_kalman_filter/extended_kalman_filter.hpp>
#include <models/nodes/fallback_controller/fallback_controller.hpp>
#include <models/nodes/first_order_lag/first_order_lag.hpp>
#include <models/nodes/floating_base_observer/floating_base_observer.hpp>
#include <models/nodes/forward_kinematics/forward_kinematics.hpp>
#include <models/nodes/gain/gain.hpp>
#include <models/nodes/gravity_compensation/gravity_compensation.hpp>
#include <models/nodes/integrator/integrator.hpp>
#include <models/nodes/inverse_dynamics/inverse_dynamics.hpp>
#include <models/nodes/inverse_kinematics/inverse_kinematics.hpp>
#include <models/nodes/jacobian/jacobian.hpp>
#include <models/nodes/kalman_filter/kalman_filter.hpp>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <models/nodes/lookup_table_2d/lookup_table_2d.hpp>
#include <models/nodes/matrix_gain/matrix_gain.hpp>
#include <models/nodes/moving_average_filter/moving_average_filter.hpp>
#include <models/nodes/moving_median/moving_median.hpp>
#include <models/nodes/mux/mux.hpp>
#include <models/nodes/nan_guard/nan_guard.hpp>
#include <models/nodes/observer/observer.hpp>
#include <models/nodes/operational_space/operational_space.hpp>
#include <models/nodes/pid_controller/pid_controller.hpp>
#include <models/nodes/product/product.hpp>
#include <models/nodes/pushes/pushes.hpp>
#include <models/nodes/quantizer/quantizer.hpp>
#include <models/nodes/reference/reference.hpp>
#include <models/nodes/reset_angle/reset_angle.hpp>
#include <models/nodes/reset_decomposed_angle/reset_decomposed_angle.hpp>
#include <models/nodes/saturation/saturation.hpp>
#include <models/nodes/sensor_model/sensor_model.hpp>
#include <models/nodes/slew_limit/slew_limit.hpp>
#include <models/nodes/speed_errors/speed_errors.hpp>
#include <models/nodes/state_feedback/state_feedback.hpp>
#include <models/nodes/state_space/state_space.hpp>
#include <models/nodes/sum/sum.hpp>
#include <models/nodes/switch/switch.hpp>
#include <models/nodes/transport_delay/transport_delay.hpp>
#include <models/nodes/unit_delay/unit_delay.hpp>
#include <models/nodes/walking_commands/walking_commands.hpp>
#include <models/nodes/windowed_butterworth/windowed_butterworth.hpp>
#include <models/objects/gym_acrobot/gym_acrobot.hpp>
#include <models/objects/gym_cart_pole/gym_cart_pole.hpp>
#include <models/objects/gym_mountain_car/gym_mountain_car.hpp>
#include <models/objects/gym_mountain_car_continuous/gym_mountain_car_continuous.hpp>
#include <models/objects/test_pendulum/test_pendulum_ode.hpp>
#include <models/processors/angle_decomposition/angle_decomposition.hpp>
#include <models/processors/choose_values/choose_values.hpp>
#include <models/processors/clip/clip.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/get_index/get_index.hpp>
#include <models/processors/identity/identity.hpp>
#include <models/processors/negate/negate.hpp>
#include <models/processors/normalize_angle/normalize_angle.hpp>
#include <models/processors/obs_with_decomposed_angle/obs_with_decomposed_angle.hpp>
#include <models/processors/offset/offset.hpp>
#include <models/processors/reshape/reshape.hpp>
#include <models/processors/scale/scale.hpp>
#include <models/processors/to_scalar/to_scalar.hpp>
#include <models/processors/to_uint8/to_uint8.hpp>
#include <models/processors/to_vector/to_vector.hpp>
#include <models/processors/voltage_to_motor_torque/voltage_to_motor_torque.hpp>

#include "tests/unit/models/dynamic_block_io.hpp"
#include "tests/unit/models/entity_io.hpp"
#include "tests/unit/models/gym_io.hpp"
#include "tests/unit/models/safety_io.hpp"
#include "tests/unit/models/walking_io.hpp"
#include "tests/unit/multibody/robot_block_io.hpp"

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
template struct GetIndex<testing::IndexIo<Array<float, 3>, 2, 0>>;
template struct Negate<ProcessorIo<float, Array<float, 3>, Array<float, 3>>>;
template struct Negate<ProcessorIo<float, std::int16_t, std::int16_t>>;
template struct Identity<ProcessorIo<float, float, float>>;
template struct ToUint8<ProcessorIo<float, Array<float, 3>, Array<std::uint8_t, 3>>>;
template struct ToUint8<ProcessorIo<double, std::int64_t, std::uint8_t>>;
template struct AngleDecomposition<ProcessorIo<float, Array<float, 3>, Array<float, 4>>>;
template struct AngleDecomposition<ProcessorIo<double, Array<float, 3>, Array<float, 4>>>;
template struct NormalizeAngle<ProcessorIo<float, float, float>>;
template struct NormalizeAngle<ProcessorIo<double, Array<float, 2>, Array<float, 2>>>;
template struct VoltageToMotorTorque<ProcessorIo<float, Array<float, 1>, Array<float, 1>>>;
template struct VoltageToMotorTorque<ProcessorIo<double, Array<float, 1>, Array<float, 1>>>;
template struct ObsWithDecomposedAngle<ProcessorIo<float, Array<float, 3>, Array<float, 2>>>;
template struct ObsWithDecomposedAngle<ProcessorIo<double, Array<float, 3>, Array<float, 2>>>;
template class ActionLimits<testing::ActionLimitsIo<float, Array<float, 2>>>;
template class ActionLimits<testing::ActionLimitsIo<double, float>>;
template class WalkingCommands<testing::WalkingCommandsIo<float>>;
template class WalkingCommands<testing::WalkingCommandsIo<double>>;
template class Pushes<testing::PushesIo<float>>;
template class Pushes<testing::PushesIo<double>>;
template class BodyMotion<testing::BodyMotionIo<float>>;
template class BodyMotion<testing::BodyMotionIo<double>>;
template class SpeedErrors<testing::SpeedErrorsIo<float>>;
template class SpeedErrors<testing::SpeedErrorsIo<double>>;
template class SlewLimit<testing::SlewLimitIo<float, float>>;
template class SlewLimit<testing::SlewLimitIo<double, Array<float, 2>>>;
template class NanGuard<testing::NanGuardIo<float, Array<float, 2>>>;
template class NanGuard<testing::NanGuardIo<double, Array<double, 2>>>;
template class FallbackController<testing::FallbackIo<float, Array<float, 2>>>;
template class FallbackController<testing::PlainFallbackIo<double, float>>;
template class PidController<testing::PidIo<float>>;
template class PidController<testing::StateFeedbackIo<double>>;
template class MovingAverageFilter<testing::MeanIo<float, float, Array<float, 1>>>;
template class MovingAverageFilter<
    testing::MeanIo<double, Array<float, 2>, Array<float, 2>, testing::Skipped>>;
template class WindowedButterworth<
    testing::WindowedIo<float, testing::Low2, eagerx::Rate<60>, 2, false>>;
template class WindowedButterworth<
    testing::WindowedIo<double, testing::Stop8, eagerx::Rate<100>, 9, true>>;
template class OdeFloatOutput<testing::OdeFloatOutputIo<PendulumSimulator<float>>>;
template struct TestPendulumOde<testing::PendulumModelIo<float>>;
template struct TestPendulumOde<testing::PendulumModelIo<double>>;

template class CustomOdeInput<testing::CustomOdeInputIo<PendulumSimulator<float>>>;
template struct OdeParameters<testing::AllParametersIo<PendulumSimulator<float>>>;
template class ResetAngle<testing::ResetAngleIo<float>>;
template class ResetAngle<testing::ResetAngleIo<double>>;
template class ResetDecomposedAngle<testing::ResetDecomposedAngleIo<float>>;
template class ResetDecomposedAngle<testing::ResetDecomposedAngleIo<double>>;

using testing::GymPendulumSimulator;
template struct GymPendulum<testing::PendulumModelIo<float>>;
template struct GymPendulum<testing::PendulumModelIo<double>>;
template class GymSimulator<GymPendulum<testing::PendulumModelIo<float>>>;
template class GymSimulator<GymCartPole<testing::PendulumModelIo<float>>>;
template class GymSimulator<GymCartPole<testing::PendulumModelIo<double>>>;
template class GymSimulator<GymMountainCar<testing::PendulumModelIo<float>>>;
template class GymSimulator<GymMountainCar<testing::PendulumModelIo<double>>>;
template class GymSimulator<GymMountainCarContinuous<testing::PendulumModelIo<float>>>;
template class GymSimulator<GymMountainCarContinuous<testing::PendulumModelIo<double>>>;
template class GymSimulator<GymAcrobot<testing::PendulumModelIo<float>>>;
template class GymSimulator<GymAcrobot<testing::PendulumModelIo<double>>>;
template class GymSimulator<GymPendulum<testing::PendulumModelIo<double>>>;
template class GymEngine<testing::EngineIo<float>>;
template class ObservationSensor<testing::ObservationSensorIo<GymPendulumSimulator<float>>>;
template class RewardSensor<testing::RewardSensorIo<GymPendulumSimulator<double>>>;
template class TerminatedSensor<testing::FlagSensorIo<GymPendulumSimulator<float>>>;
template class TruncatedSensor<testing::FlagSensorIo<GymPendulumSimulator<double>>>;
template class ActionActuator<testing::ActionActuatorIo<GymPendulumSimulator<float>>>;
template struct SetGymAttribute<testing::MassIo<GymPendulumSimulator<float>>>;
template struct GymState<testing::MirroredStateIo<GymPendulumSimulator<double>>>;

namespace blocks = testing::blocks;
template <class Real, class Input, class Output>
using ConversionIo = blocks::ConversionIo<Real, Input, Output>;
template class Sum<blocks::SumIo<float>>;
template class Sum<blocks::SumIo<double>>;
template class Difference<blocks::AngleIo<float>>;
template class Difference<blocks::AngleIo<double>>;
template class Gain<blocks::GainIo<float>>;
template class Gain<blocks::GainIo<double>>;
template class MatrixGain<blocks::MatrixIo<float>>;
template class MatrixGain<blocks::MatrixIo<double>>;
template class Saturation<blocks::SampledLimitsIo<float>>;
template class Saturation<blocks::SampledLimitsIo<double>>;
template class DeadZone<blocks::LimitsIo<float>>;
template class DeadZone<blocks::LimitsIo<double>>;
template class Quantizer<blocks::QuantizerIo<float>>;
template class Quantizer<blocks::QuantizerIo<double>>;
template class Product<blocks::ProductIo<float>>;
template class Product<blocks::ProductIo<double>>;
template class Switch<blocks::SwitchIo<float>>;
template class Switch<blocks::SwitchIo<double>>;
template class Mux<blocks::MuxIo<float>>;
template class Mux<blocks::MuxIo<double>>;
template class Demux<blocks::DemuxIo<float>>;
template class Demux<blocks::DemuxIo<double>>;
template class LookupTable<blocks::TableIo<float>>;
template class LookupTable<blocks::TableIo<double>>;
template class LookupTable<blocks::StepsIo<float>>;
template class LookupTable<blocks::StepsIo<double>>;
template class LookupTable2d<blocks::GridIo<float>>;
template class LookupTable2d<blocks::GridIo<double>>;
template class Constant<blocks::SampledConstantIo<float>>;
template class Constant<blocks::SampledConstantIo<double>>;
template class Integrator<blocks::BackwardIo<float>>;
template class Integrator<blocks::BackwardIo<double>>;
template class Integrator<blocks::ForwardIo<float>>;
template class Integrator<blocks::ForwardIo<double>>;
template class Integrator<blocks::TrapezoidalIo<float>>;
template class Integrator<blocks::TrapezoidalIo<double>>;
template class Derivative<blocks::DerivativeIo<float>>;
template class Derivative<blocks::DerivativeIo<double>>;
template class DiscreteTransferFunction<blocks::TransferIo<float>>;
template class DiscreteTransferFunction<blocks::TransferIo<double>>;
template class StateSpace<blocks::SpaceIo<float>>;
template class StateSpace<blocks::SpaceIo<double>>;
template class FirstOrderLag<blocks::LagIo<float>>;
template class FirstOrderLag<blocks::LagIo<double>>;
template class Backlash<blocks::PlayIo<float>>;
template class Backlash<blocks::PlayIo<double>>;
template class TransportDelay<blocks::DelayIo<float>>;
template class TransportDelay<blocks::DelayIo<double>>;
template class UnitDelay<blocks::UnitIo<float>>;
template class UnitDelay<blocks::UnitIo<double>>;
template class MovingMedian<blocks::MedianIo<float>>;
template class MovingMedian<blocks::MedianIo<double>>;
template class Counter<blocks::CounterIo<float>>;
template class Counter<blocks::CounterIo<double>>;
template class ComplementaryFilter<blocks::TurningIo<float>>;
template class ComplementaryFilter<blocks::TurningIo<double>>;
template class PidController<blocks::SetpointPidIo<float>>;
template class PidController<blocks::SetpointPidIo<double>>;
template class StateFeedback<blocks::FeedbackIo<float>>;
template class StateFeedback<blocks::FeedbackIo<double>>;
template class Observer<blocks::SystemIo<float>>;
template class Observer<blocks::SystemIo<double>>;
template class KalmanFilter<blocks::SystemIo<float>>;
template class KalmanFilter<blocks::SystemIo<double>>;
template class ExtendedKalmanFilter<blocks::ExtendedIo<float>>;
template class ExtendedKalmanFilter<blocks::ExtendedIo<double>>;
template class SensorModel<blocks::NoisyIo<float>>;
template class SensorModel<blocks::NoisyIo<double>>;
template class Reference<blocks::SourceIo<float, blocks::ReferenceConfig<ReferenceShape::step>>>;
template class Reference<blocks::SourceIo<float, blocks::ReferenceConfig<ReferenceShape::ramp>>>;
template class Reference<blocks::SourceIo<float, blocks::ReferenceConfig<ReferenceShape::sine>>>;
template class Reference<blocks::SourceIo<float, blocks::ReferenceConfig<ReferenceShape::chirp>>>;
template class Reference<blocks::SourceIo<float, blocks::ReferenceConfig<ReferenceShape::table>>>;
template struct Scale<ConversionIo<float, Array<float, 2>, Array<float, 2>>>;
template struct Offset<ConversionIo<float, Array<float, 2>, Array<float, 2>>>;
template struct Clip<ConversionIo<float, Array<float, 2>, Array<float, 2>>>;
template class Reference<blocks::SourceIo<double, blocks::ReferenceConfig<ReferenceShape::step>>>;
template class Reference<blocks::SourceIo<double, blocks::ReferenceConfig<ReferenceShape::ramp>>>;
template class Reference<blocks::SourceIo<double, blocks::ReferenceConfig<ReferenceShape::sine>>>;
template class Reference<blocks::SourceIo<double, blocks::ReferenceConfig<ReferenceShape::chirp>>>;
template class Reference<blocks::SourceIo<double, blocks::ReferenceConfig<ReferenceShape::table>>>;
template struct Scale<ConversionIo<double, Array<float, 2>, Array<float, 2>>>;
template struct Offset<ConversionIo<double, Array<float, 2>, Array<float, 2>>>;
template struct Clip<ConversionIo<double, Array<float, 2>, Array<float, 2>>>;
template struct Reshape<ConversionIo<float, Array<float, 4>, Array<float, 2, 2>>>;
template struct ToScalar<ConversionIo<float, Array<float, 1>, float>>;
template struct ToVector<ConversionIo<float, float, Array<float, 1>>>;

// Blocks that know a robot.
namespace robots = testing::robots;
template <class Real>
using ArmConfig = robots::MixedConfig<robots::MixedArm<Real>>;
template <class Real>
using HandConfig = robots::HandConfig<robots::MixedArm<Real>>;
template <class Real>
using LegsConfig = robots::ObserverConfig<robots::TwoLegs<Real>>;
template class FloatingBaseObserver<robots::ObserverIo<float, LegsConfig<float>, 2, 2>>;
template class FloatingBaseObserver<robots::ObserverIo<double, LegsConfig<double>, 2, 2>>;
template class InverseDynamics<robots::DynamicsIo<float, ArmConfig<float>, 4>>;
template class InverseDynamics<robots::DynamicsIo<double, ArmConfig<double>, 4>>;
template class GravityCompensation<robots::GravityIo<float, ArmConfig<float>, 4>>;
template class GravityCompensation<robots::GravityIo<double, ArmConfig<double>, 4>>;
template class ComputedTorque<robots::ComputedIo<float, ArmConfig<float>, 4>>;
template class ComputedTorque<robots::ComputedIo<double, ArmConfig<double>, 4>>;
template class ForwardKinematics<robots::ForwardIo<float, ArmConfig<float>, 4>>;
template class ForwardKinematics<robots::ForwardIo<double, ArmConfig<double>, 4>>;
template class Jacobian<robots::JacobianIo<float, ArmConfig<float>, 4>>;
template class Jacobian<robots::JacobianIo<double, ArmConfig<double>, 4>>;
template class InverseKinematics<robots::InverseIo<float, ArmConfig<float>, 4, 7>>;
template class InverseKinematics<robots::InverseIo<double, ArmConfig<double>, 4, 7>>;
template class OperationalSpace<robots::OperationalIo<float, HandConfig<float>, 4, 7>>;
template class OperationalSpace<robots::OperationalIo<double, HandConfig<double>, 4, 7>>;

// A callback that takes the tick of any SIMD group is not a part of what the lines above make.
template <class Node>
constexpr auto kCallback = &Node::template callback<Tick>;
template <class... Nodes>
constexpr bool have_callbacks = ((kCallback<Nodes> != nullptr) && ...);
static_assert(
    have_callbacks<Observer<blocks::SystemIo<float>>, Observer<blocks::SystemIo<double>>,
                   KalmanFilter<blocks::SystemIo<float>>, KalmanFilter<blocks::SystemIo<double>>,
                   ExtendedKalmanFilter<blocks::ExtendedIo<float>>,
                   ExtendedKalmanFilter<blocks::ExtendedIo<double>>,
                   SensorModel<blocks::NoisyIo<float>>, SensorModel<blocks::NoisyIo<double>>>);
template <class Real>
constexpr bool reference_has_callbacks = have_callbacks<
    Reference<blocks::SourceIo<Real, blocks::ReferenceConfig<ReferenceShape::step>>>,
    Reference<blocks::SourceIo<Real, blocks::ReferenceConfig<ReferenceShape::ramp>>>,
    Reference<blocks::SourceIo<Real, blocks::ReferenceConfig<ReferenceShape::sine>>>,
    Reference<blocks::SourceIo<Real, blocks::ReferenceConfig<ReferenceShape::chirp>>>,
    Reference<blocks::SourceIo<Real, blocks::ReferenceConfig<ReferenceShape::table>>>>;
static_assert(reference_has_callbacks<float> && reference_has_callbacks<double>);

// The state of a program: constant-initialised to zero bytes.
constinit PendulumSimulator<float> float_pendulum;
constinit PendulumSimulator<double> double_pendulum;
constinit GymPendulumSimulator<float> gym_pendulum;
constinit ButterworthFilter<FilterIo<float, testing::Stop8>> filter;

void advance_all() {
  GymEngine<testing::EngineIo<float>>().callback({1}, gym_pendulum);
  testing::tick<testing::EngineIo<float>>(float_pendulum);
  testing::tick<testing::EngineIo<float, testing::Rk4Config<30>>>(float_pendulum);
  testing::tick<testing::EngineIo<double>>(double_pendulum);
  testing::tick<testing::EngineIo<double, testing::Rk4Config<30>>>(double_pendulum);
}

}  // namespace eagerx::models
