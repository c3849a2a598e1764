// The engine of real hardware: absolute time, one round trip an instant, safe actions.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/safety.hpp>
#include <models/engines/real_engine/lateness.hpp>

namespace eagerx::models {

/// Instant n of an episode is start + n/rate on Link::Clock. At each instant the engine
///   1. sends the actions of instant n − 1, without waiting for an answer; safe actions in their
///      place if that was more than a period (or `max_lateness`) ago
///   2. sleeps until the instant
///   3. measures all sensors of all objects in one round trip
///   4. sends the safe action of all actuators at once if something is wrong
/// These things are wrong: `late` instants in a row that were later than `max_lateness` (0: a
/// period), an error of the link, a sensor without a value for `missed` instants, an action that is
/// not finite, and with `limits: safe` an action out of its limits. A pause of many periods counts
/// as that many instants, so what comes first after it is the safe action. The safe action stays
/// until `recover` instants in a row were right (0: until the next episode). An engine that is more
/// than a period late does not catch up: it moves all later instants. `Platform::prepare()` is
/// called once before, then `Platform::open(link)`.
template <class Io, class Link, class Platform>
class HardwareEngine {
 public:
  static constexpr bool kReal = true;

  template <class... Simulators>
  void start(Simulators&... simulators) {
    if (started_) return;  // a program that warms up is started again by its first reset
    started_ = true;
    Platform::prepare();
    if (!Platform::open(link_)) ++failed_starts_;
    (simulators.attach(link_, kMissed), ...);
  }

  /// An episode begins with the sample of instant 0 and with safe actions.
  template <class... Simulators>
  void reset(const typename Io::States& /*states*/, Simulators&... simulators) {
    (simulators.begin(), ...);
    (simulators.queue_action(true), ...);
    (simulators.queue_request(), ...);
    began_ns_ = Clock::now_ns();
    const BusError error = link_.run();
    start_ns_ = Clock::now_ns();
    (simulators.collect(error, start_ns_), ...);
    late_in_a_row_ = 0;
    is_safe_ = error != BusError::none || ((simulators.missed() > 0) || ...);
    right_ = 0;
    (simulators.hold(is_safe()), ...);
  }

  template <class... Simulators>
  void callback(const Tick& tick, Simulators&... simulators) {
    const bool was_safe = is_safe();
    const bool bad_action = (simulators.has_bad_action() || ...);
    const std::int64_t due_ns = start_ns_ + ns_of(tick.n);
    // Looked at last: the program may have stood still anywhere since the instant before.
    const bool old_action = is_old(Clock::now_ns() - (due_ns - kPeriodNs));
    (simulators.queue_action(was_safe || bad_action || old_action), ...);
    BusError error = link_.post();
    std::int64_t now_ns = Clock::now_ns();
    latency_.add(now_ns - began_ns_);
    const bool in_time = wait_until(due_ns, now_ns);
    (simulators.queue_request(), ...);
    const BusError answer = link_.run();
    (simulators.collect(answer, Clock::now_ns()), ...);
    if (error == BusError::none) error = answer;
    const bool stale = (simulators.is_stale() || ...);
    missing_ += ((simulators.missed() > 0) || ...);
    stale_ += stale;
    link_errors_ += error != BusError::none;
    bad_actions_ += bad_action;
    old_actions_ += old_action;
    const bool right = in_time && !old_action && error == BusError::none && !stale && !bad_action;
    note(right);
    safe_instants_ += is_safe();
    if (!right && !was_safe) apply_safe(due_ns, simulators...);
  }

  /// Applies safe actions between two instants, because the program that decides is silent or about
  /// to stop. They stay until `recover` instants in a row were right.
  template <class... Simulators>
  void make_safe(Simulators&... simulators) {
    note(false);
    (simulators.queue_action(true), ...);
    link_.post();  // an error is the next instant's
    ++silences_;
  }

  /// The end of a run: applies safe actions and closes the link. If the link is lost, retries for
  /// the time that an adapter needs to appear.
  template <class... Simulators>
  void stop(Simulators&... simulators) {
    constexpr std::int64_t kPatienceNs = kNsPerSecond;
    constexpr std::int64_t kRetryNs = kNsPerSecond / 100;
    const std::int64_t end_ns = Clock::now_ns() + kPatienceNs;
    for (std::int64_t now_ns = Clock::now_ns();; now_ns = Clock::now_ns()) {
      (simulators.queue_action(true), ...);
      const BusError error = link_.post();
      if (error == BusError::none) break;
      if (error == BusError::unsupported || now_ns >= end_ns) {
        ++not_safe_at_end_;
        break;
      }
      Clock::sleep_until(now_ns + kRetryNs);
    }
    link_.close();
  }

  /// The clock that inputs go by with `sync: false`.
  static std::int64_t now_ns() { return Clock::now_ns(); }
  bool is_safe() const { return is_safe_; }
  const Lateness& lateness() const { return lateness_; }
  const Link& link() const { return link_; }

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    constexpr std::int64_t kNsPerUs = 1'000;
    lateness_.for_each_count(f);
    latency_.for_each_count(f);
    f("instants too late", overruns_);
    f("instants moved", moved_);
    f("instants with a sensor missing", missing_);
    f("instants with a sensor stale", stale_);
    f("instants with a link error", link_errors_);
    f("instants with a bad action", bad_actions_);
    f("instants with an action too old", old_actions_);
    f("instants with safe actions", safe_instants_);
    f("safe actions", safe_actions_);
    f("safe actions between instants", silences_);
    f("slowest safe action us", static_cast<std::uint64_t>(slowest_ns_ / kNsPerUs));
    f("starts without hardware", failed_starts_);
    f("ends without a safe action", not_safe_at_end_);
    link_.for_each_count(f);
  }

 private:
  using Clock = typename Link::Clock;
  static constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  static constexpr std::uint32_t kLate = static_cast<std::uint32_t>(Io::Config::late);
  static constexpr std::uint32_t kMissed = static_cast<std::uint32_t>(Io::Config::missed);
  static constexpr std::uint32_t kRecover = static_cast<std::uint32_t>(Io::Config::recover);
  static constexpr auto kPeriodNs =
      static_cast<std::int64_t>(Io::Rate::den * std::uint64_t{kNsPerSecond} / Io::Rate::num);
  static constexpr std::int64_t kMaxLateNs =
      Io::Config::max_lateness > 0.0
          ? static_cast<std::int64_t>(Io::Config::max_lateness* double{kNsPerSecond})
          : kPeriodNs;

  /// n/rate in nanoseconds, rounded down; exact for centuries.
  static constexpr std::int64_t ns_of(Seq n) {
    const std::uint64_t periods = n * Io::Rate::den;
    const std::uint64_t seconds = periods / Io::Rate::num;
    const std::uint64_t rest = periods % Io::Rate::num;
    return static_cast<std::int64_t>(seconds * std::uint64_t{kNsPerSecond} +
                                     rest * std::uint64_t{kNsPerSecond} / Io::Rate::num);
  }

  /// False if it was too late, and so were as many before it as make safe.
  bool wait_until(std::int64_t due_ns, std::int64_t now_ns) {
    if (now_ns < due_ns) Clock::sleep_until(due_ns);
    began_ns_ = Clock::now_ns();
    const std::int64_t late_ns = began_ns_ - due_ns;
    lateness_.add(late_ns > 0 ? late_ns : 0);
    if (late_ns > kPeriodNs) {
      start_ns_ += late_ns;
      ++moved_;
    }
    if (late_ns <= kMaxLateNs) {
      late_in_a_row_ = 0;
      return true;
    }
    ++overruns_;
    late_in_a_row_ += 1 + static_cast<std::uint64_t>((late_ns - kMaxLateNs) / kPeriodNs);
    return late_in_a_row_ < kLate;
  }

  /// Whether an action whose instant was due `age_ns` ago, with those before it, makes safe.
  bool is_old(std::int64_t age_ns) const {
    constexpr std::int64_t kLongest = kPeriodNs > kMaxLateNs ? kPeriodNs : kMaxLateNs;
    return age_ns > kLongest && late_instants(late_in_a_row_, static_cast<std::uint64_t>(age_ns),
                                              kPeriodNs, kMaxLateNs) >= kLate;
  }

  void note(bool right) {
    if (!right) {
      is_safe_ = true;
      right_ = 0;
    } else if (is_safe_ && kRecover > 0) {
      is_safe_ = ++right_ < kRecover;
    }
  }

  template <class... Simulators>
  void apply_safe(std::int64_t due_ns, Simulators&... simulators) {
    (simulators.queue_action(true), ...);
    link_.post();  // an error is the next instant's
    ++safe_actions_;
    const std::int64_t after_ns = Clock::now_ns() - due_ns;
    if (after_ns > slowest_ns_) slowest_ns_ = after_ns;
  }

  Link link_{};
  bool started_ = false;
  std::int64_t start_ns_ = 0;
  std::int64_t began_ns_ = 0;  // the latest instant
  bool is_safe_ = false;
  std::uint32_t right_ = 0;  // instants in a row since the last wrong one, while safe
  std::uint64_t late_in_a_row_ = 0;
  Lateness lateness_{};
  Latency latency_{};
  std::int64_t slowest_ns_ = 0;
  std::uint64_t overruns_ = 0;
  std::uint64_t moved_ = 0;
  std::uint64_t missing_ = 0;
  std::uint64_t stale_ = 0;
  std::uint64_t link_errors_ = 0;
  std::uint64_t bad_actions_ = 0;
  std::uint64_t old_actions_ = 0;
  std::uint64_t safe_instants_ = 0;
  std::uint64_t safe_actions_ = 0;
  std::uint64_t silences_ = 0;
  std::uint64_t failed_starts_ = 0;
  std::uint64_t not_safe_at_end_ = 0;
};

}  // namespace eagerx::models
