// RealEngine's data of each object: last values, next action, limits, errors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/real_engine/hardware_model.hpp>

namespace eagerx::models {

/// "sensor link lost", … by BusError, as the summary of a run calls how often it was met.
constexpr auto counts_of_errors() {
  constexpr std::size_t kLongest = 24;
  std::array<std::array<char, kLongest>, kBusErrors> names{};
  for (std::size_t i = 0; i < kBusErrors; ++i) {
    std::size_t end = 0;
    for (const char* part : {"sensor ", name_of(static_cast<BusError>(i))})
      for (; *part != '\0'; ++part) names[i][end++] = *part;
  }
  return names;
}

/// An object of real hardware. ("Simulator" is EAGERx's word for an engine's part of an object.)
/// `Link` is a bus with a clock (Link::Clock). All bytes are zero until attach().
template <HardwareModel ModelType, class LinkType>
class HardwareSimulator {
 public:
  using Model = ModelType;
  using Link = LinkType;
  using Real = typename Model::Real;
  using Clock = typename Link::Clock;
  using Values = Array<Real, Model::kSensors>;
  using Action = Array<Real, Model::kActuators>;

  /// `most_missed`: instants in a row without a value that make it stale.
  void attach(Link& link, std::uint32_t most_missed) {
    link_ = &link;
    most_missed_ = most_missed;
    reset();
  }
  void reset() {
    model_ = {};
    values_ = {};
    action_ = safe_;
    missed_ = 0;
  }
  /// An episode begins.
  void begin() { model_.reset(); }

  // For engine nodes and states.

  /// Element `i` of the last measurement.
  Real value(std::size_t i) const { return values_[i]; }
  /// Values outside are not taken.
  void limit_sensor(std::size_t i, Real low, Real high) {
    sensor_low_[i] = low;
    sensor_high_[i] = high;
    has_limits_[i] = true;
  }
  /// Sets the safe action of actuator `i`. Before this is called, at the very first reset, the safe
  /// action is to send nothing.
  void declare_safe(std::size_t i, Real safe) {
    is_declared_ = true;
    safe_[i] = safe;
    action_[i] = safe;
  }
  /// Takes the next action of actuator `i`, moves it into its limits, and returns the value to
  /// apply. An action that is NaN, infinite or (unless `clips`) out of its limits is counted, and
  /// all actuators get their safe action.
  Real act(std::size_t i, Real wanted, Real low, Real high, bool clips = true) {
    if (!eagerx::isfinite(wanted)) {
      ++not_finite_;
      bad_action_ = true;
      wanted = safe_[i];
    } else if (wanted < low || wanted > high) {
      ++limited_;
      bad_action_ = bad_action_ || !clips;
      wanted = !clips ? safe_[i] : wanted < low ? low : high;
    }
    action_[i] = wanted;
    return is_safe_ ? safe_[i] : wanted;
  }
  /// Applies the last actions and measures, in one round trip. For resets.
  BusError exchange() {
    queue_action(false);
    queue_request();
    const BusError error = link_->run();
    collect(error, Clock::now_ns());
    return error;
  }
  void note_late() { ++late_in_resets_; }
  /// Applies safe actions in a reset, because something is wrong. At the very first reset the safe
  /// actions are not declared yet: then the last actions are sent.
  void make_safe() {
    queue_action(is_declared_);
    link_->post();  // an error is the first instant's
    ++safe_in_resets_;
  }

  // For the engine.

  void queue_action(bool safe) {
    is_safe_ = safe;
    const bool says_something = is_declared_ || !(safe || bad_action_);
    if (says_something) model_.act(*link_, safe || bad_action_ ? safe_ : action_);
    bad_action_ = false;
  }
  /// Whether actuators are kept at their safe action.
  void hold(bool safe) { is_safe_ = safe; }
  void queue_request() { model_.request(*link_); }
  /// After the link's run() with that result.
  void collect(BusError error, std::int64_t now_ns) {
    if (error == BusError::none) {
      Values values = values_;
      error = model_.measure(now_ns, values);
      if (error == BusError::none && !is_allowed(values)) error = BusError::out_of_range;
      if (error == BusError::none) values_ = values;
      if (error != BusError::none) ++errors_[static_cast<std::size_t>(error)];
    }
    if (error == BusError::none) {
      missed_ = 0;
    } else if (missed_ != UINT32_MAX) {
      ++missed_;
    }
  }
  /// Instants in a row without a value.
  std::uint32_t missed() const { return missed_; }
  bool is_stale() const { return missed_ >= most_missed_; }
  bool has_bad_action() const { return bad_action_; }

  /// f(name, count) for each; errors of the link are counted there.
  template <class F>
  void for_each_count(F&& f) const {
    for (std::size_t i = 1; i < kBusErrors; ++i) f(kErrorNames[i].data(), errors_[i]);
    f("actions out of limits", limited_);
    f("actions not finite", not_finite_);
    f("late in resets", late_in_resets_);
    f("safe actions in resets", safe_in_resets_);
  }

 private:
  static constexpr auto kErrorNames = counts_of_errors();

  bool is_allowed(const Values& values) const {
    bool allowed = true;
    for (std::size_t i = 0; i < Model::kSensors; ++i) {
      const Real x = values[i];
      allowed = allowed && eagerx::isfinite(x) &&
                (!has_limits_[i] || (x >= sensor_low_[i] && x <= sensor_high_[i]));
    }
    return allowed;
  }

  Link* link_ = nullptr;
  Model model_{};
  Values values_{};
  Action action_{};
  Action safe_{};
  Values sensor_low_{};
  Values sensor_high_{};
  std::array<bool, Model::kSensors> has_limits_{};
  bool is_declared_ = false;
  bool is_safe_ = false;
  bool bad_action_ = false;
  std::uint32_t missed_ = 0;
  std::uint32_t most_missed_ = 0;
  std::array<std::uint64_t, kBusErrors> errors_{};
  std::uint64_t limited_ = 0;
  std::uint64_t not_finite_ = 0;
  std::uint64_t late_in_resets_ = 0;
  std::uint64_t safe_in_resets_ = 0;
};

}  // namespace eagerx::models
