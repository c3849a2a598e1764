// Estimates the motion of a legged robot's base from inertial measurements, joints and contacts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/nodes/floating_base_observer/base_estimate.hpp>
#include <models/nodes/robot_block.hpp>
#include <utility>

namespace eagerx::models {

/// An extended Kalman filter over the errors of rotation, velocity and gyroscope's bias of the free
/// body. The inertial measurement predicts; each foot in contact is a measurement of the velocity,
/// since its lowest point stands. Feet that slip are left out.
template <class Io>
class FloatingBaseObserver : public RobotBlock<Io> {
  using Base = RobotBlock<Io>;
  using typename Base::Config, typename Base::Joints, typename Base::Lane, typename Base::Model,
      typename Base::Numbers, typename Base::Real;
  using Vec = multibody::Vec<Real>;
  using Estimate = BaseEstimate<Real>;
  static constexpr std::size_t kFeet = scene::count_names(Config::feet);
  static constexpr auto kFoot = scene::find_all<kFeet>(Model::kGeometries, Config::feet);
  static constexpr bool kAreSpheres = [] {
    for (const std::size_t g : kFoot) {
      if (g >= Model::kGeometries.size() || Model::kGeometries[g].kind != ShapeKind::sphere ||
          *Model::kGeometries[g].body == '\0')
        return false;
    }
    return kFeet > 0;
  }();
  static_assert(kAreSpheres, "FloatingBaseObserver: `feet` names spheres of the robot's bodies");
  static_assert(multibody::count_free<Model>() == 1,
                "FloatingBaseObserver: the robot has one free body");
  static_assert(elements_of<decltype(Io::Inputs::contacts)> == kFeet,
                "FloatingBaseObserver: `contacts` has one element for each of `feet`");

 public:
  void reset(const typename Io::States& /*states*/) { estimate_.clear(); }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const auto imu = Base::numbers(in.imu);
    const Numbers q = Base::of_joints(in.q), v = Base::of_joints(in.v);
    const Vec force{imu[0], imu[1], imu[2]}, gyro{imu[3], imu[4], imu[5]};
    const TruthOf<Real> right = Base::are_finite(imu);
    const TruthOf<Real> begins = right && !estimate_.has_begun();
    change_where<Real>(right && !begins, estimate_,
                       [&] { estimate_.predict(force, gyro, kNoise, kSettings); });
    change_where<Real>(begins, estimate_, [&] { estimate_.begin(force, gyro, kInitial); });
    const TruthOf<Real> known =
        right && Base::are_finite(q) && Base::are_finite(v) && estimate_.is_finite();
    use_feet(q, v, Base::numbers(in.contacts), known, std::make_index_sequence<kFeet>{});
    const TruthOf<Real> lost =
        !estimate_.is_finite() || estimate_.distrusts(Real(constant<Real>(kPatience)));
    change_where<Real>(lost, estimate_, [&] { estimate_.clear(); });
    restarts_ += one_if<Real>(lost && restarts_ != Count(~std::uint32_t{0}));
    put_estimate(out);
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("restarts", static_cast<std::uint32_t>(restarts_));
    f("slips", static_cast<std::uint32_t>(slips_));
  }

 private:
  using Count = CountOf<Real>;
  static constexpr double kPeriod = Io::Rate::period_s;
  static constexpr double kPatience = Config::patience / kPeriod;  // [ticks]
  static constexpr double square(double x) { return x * x; }
  static constexpr std::array<double, 9> thrice(double rotation, double velocity, double bias) {
    return {rotation, rotation, rotation, velocity, velocity, velocity, bias, bias, bias};
  }
  static constexpr auto kNoise = factors_of<9>(thrice(square(Config::gyro_noise * kPeriod),
                                                      square(Config::accelerometer_noise* kPeriod),
                                                      square(Config::bias_drift) * kPeriod));
  static constexpr auto kInitial = factors_of<9>(thrice(
      square(Config::initial_tilt), square(Config::initial_speed), square(Config::initial_bias)));
  static constexpr ObserverSettings<Lane> kSettings{
      .dt = constant<Real>(kPeriod),
      .gravity = constant<Real>(Config::gravity),
      .foot = constant<Real>(square(Config::foot_noise)),
      .gate = constant<Real>(square(Config::gate))};

  template <std::size_t... I>
  void use_feet(const Numbers& q, const Numbers& v, const std::array<Real, kFeet>& contacts,
                const TruthOf<Real>& known, std::index_sequence<I...> /*feet*/) {
    TruthOf<Real> touches(false), used(false);
    const auto use = [&](const StandingFoot<Real>& foot, const Real& contact) {
      const TruthOf<Real> stands = known && contact > Real(Lane(0.5));
      const auto innovation = estimate_.innovation(foot);
      const TruthOf<Real> fits = stands && estimate_.fits(innovation, kSettings);
      change_where<Real>(fits, estimate_, [&] { estimate_.correct(innovation, kSettings); });
      slips_ += one_if<Real>(stands && !fits && slips_ != Count(~std::uint32_t{0}));
      touches = touches || stands;
      used = used || fits;
    };
    (use(foot_at<I>(q, v), contacts[I]), ...);
    estimate_.note(touches, used);
  }

  /// The lowest point of a foot, and how it would move if the base stood.
  template <std::size_t kIndex>
  StandingFoot<Real> foot_at(const Numbers& q, const Numbers& v) const {
    constexpr const RigidGeometry& kSphere = Model::kGeometries[kFoot[kIndex]];
    constexpr std::size_t kBody = scene::find(Model::kBodies, kSphere.body);
    const multibody::Reach<Model, Joints, Real, kBody> center(
        Base::places(q), multibody::constant<Real>(kSphere.position));
    const auto jacobian = center.jacobian();
    std::array<Real, 6> motion;
    for (std::size_t i = 0; i < 6; ++i) motion[i] = product_of(jacobian[i], v);
    const Vec down = estimate_.up() * Real(constant<Real>(-kSphere.size[0]));
    return {center.position + down, Vec{motion[0], motion[1], motion[2]} +
                                        cross(Vec{motion[3], motion[4], motion[5]}, down)};
  }

  void put_estimate(typename Io::Outputs& out) const {
    const auto& r = estimate_.rotation;
    const Real attitude[4] = {r.w, r.x, r.y, r.z};
    for (std::size_t i = 0; i < 4; ++i) put(out.attitude, i, attitude[i]);
    const auto put_vector = [](auto& message, const Vec& x) {
      put(message, 0, x.x), put(message, 1, x.y), put(message, 2, x.z);
    };
    put_vector(out.velocity, estimate_.velocity);
    put_vector(out.angular_velocity, estimate_.rate);
    put_vector(out.gravity, estimate_.up() * Real(Lane(-1)));
  }

  Estimate estimate_{};
  Count restarts_{}, slips_{};
};

}  // namespace eagerx::models
