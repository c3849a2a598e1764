// A log as an experiment: the program repeats it with other parameters, states and delays, and what
// its sensors say is compared with the log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/rate.hpp>
#include <optional>
#include <runtime/host/identify/simulator_view.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::identification {

/// The program that repeats the log.
struct RepeatingProgram {
  std::span<const Channel> channels;
  std::string_view engine;                     // its type
  std::uint64_t steps_num = 0, steps_den = 1;  // rate of the environment [Hz]
};

/// The values that a run is tried with.
struct Trial {
  std::vector<double> parameters;
  std::vector<double> states;  // [segments][states of all objects]
  std::vector<double> delays;  // of each actuator, in ticks of the engine
};

/// One element of a sensor's message.
struct Sample {
  std::uint32_t segment = 0;
  std::uint32_t group = 0;     // samples of one element of one sensor
  std::uint32_t position = 0;  // in its group and segment, from 0
};

/// Every segment of `horizon_s` begins in a state of its own, so that an error does not grow for
/// longer than that. Objects must have a state and an input as OdeSimulator has.
class Experiment {
 public:
  struct Object {
    std::string name;
    std::size_t first_state = 0, states = 0, inputs = 0;
  };
  struct Group {
    std::uint32_t channel = 0;
    std::size_t element = 0;
  };

  /// `sensors` names the channels that count, empty: all that engine nodes send. False: `problem`
  /// says why.
  bool prepare(const trace_log::Log& log, const RepeatingProgram& program,
               const std::string& sensors, double horizon_s, std::string& problem);

  /// Steps of an episode.
  std::uint64_t steps(std::uint32_t episode) const;

  /// Before a run. Without a trial it only finds out about objects, actuators and samples.
  void begin(const Trial* trial);
  void episode(std::uint32_t index);

  /// Called for every object at every tick of the engine, before anything reads it.
  void simulator(std::string_view name, Seq tick, const SimulatorView& simulator);
  /// Before the engine integrates from its last tick on.
  void engine_runs();

  /// A published message of `size` elements: of an engine node it is compared, any other is taken
  /// from the log.
  template <class Scalar>
  void message(std::uint32_t channel, Seq seq, Scalar* elements, std::size_t size) {
    const std::uint64_t* const recorded = find(channel, seq);
    if (facts_[channel].publisher == Publisher::engine_node) {
      numbers_.resize(size);
      for (std::size_t i = 0; i < size; ++i) numbers_[i] = static_cast<double>(elements[i]);
      measured(channel, recorded);
    } else if (recorded != nullptr) {
      for (std::size_t i = 0; i < size; ++i) elements[i] = trace_log::value_of<Scalar>(recorded[i]);
    }
  }

  std::size_t states() const { return total_states_; }
  std::size_t segments() const { return segment_ + 1; }
  const std::vector<Object>& objects() const { return objects_; }
  const std::vector<Group>& groups() const { return groups_; }
  const std::vector<Sample>& samples() const { return samples_; }
  /// Of the last run: the state that each segment was about to begin in, as the one before it
  /// ended, in the order of Trial::states. Of an episode's first segment: what the reset routine
  /// set.
  const std::vector<double>& arrivals() const { return arrivals_; }
  /// Typical size of each state, from the run without a trial.
  const std::vector<double>& state_scale() const { return state_scale_; }
  /// Typical size of each group, from the log.
  std::vector<double> group_scale() const;
  /// Simulated minus recorded, of the last run, in the order of samples().
  const std::vector<double>& residuals() const { return residuals_; }
  /// Channels that set the input of an object and are in the log.
  const std::vector<std::uint32_t>& actuators() const { return actuators_; }
  /// Call after a run without a trial; another one then finds the samples.
  void find_actuators();

 private:
  /// Whether a channel is the input of an object, as far as was seen.
  struct Likeness {
    bool differs = false;
    bool seen = false;
  };

  void note_state(std::size_t i, const Numbers& state);
  std::size_t object(std::string_view name, std::size_t states, std::size_t inputs);
  void next_tick(Seq tick);
  void note_input(std::size_t object);
  void apply_input(std::size_t object);
  double input_of_tick(std::size_t object, std::size_t element, std::int64_t tick) const;
  double mean_input(std::size_t object, std::size_t element, double begin) const;
  const std::uint64_t* find(std::uint32_t channel, Seq seq) const;
  void measured(std::uint32_t channel, const std::uint64_t* recorded);
  void note_actuator(std::uint32_t channel);
  std::optional<std::size_t> owner(std::uint32_t channel) const;

  const trace_log::Log* log_ = nullptr;
  std::span<const Channel> facts_;
  std::vector<bool> counts_;                                 // sensors
  std::vector<std::optional<std::uint32_t>> in_log_;         // of each channel
  std::vector<std::vector<std::vector<std::size_t>>> rows_;  // [channel][episode][seq]
  const Channel* engine_ = nullptr;                          // its tick
  double steps_hz_ = 0.0;
  bool has_actions_ = false;
  bool log_is_simulated_ = false;  // by the same engine
  Seq ticks_in_segment_ = 1;

  std::vector<Object> objects_;
  std::vector<Numbers> inputs_;
  std::vector<std::vector<double>> first_inputs_;  // of each object, after a reset
  std::vector<std::uint32_t> actuators_;
  std::vector<std::size_t> actuator_of_;  // of each object; beyond actuators_: none
  std::vector<Likeness> likeness_;        // of each channel
  std::size_t total_states_ = 0;
  std::vector<double> state_scale_;

  // A run.
  const Trial* trial_ = nullptr;
  std::uint32_t episode_ = 0;
  Seq tick_ = 0;
  std::size_t segment_ = 0;
  bool begins_segment_ = false;
  bool has_segment_ = false;
  std::vector<double> numbers_;  // of a message
  std::vector<double> residuals_;
  std::vector<double> arrivals_;
  std::vector<Group> groups_;
  std::vector<std::size_t> first_group_;  // of each channel
  std::vector<std::uint32_t> positions_;  // of each group, in this segment
  std::vector<Sample> samples_;
};

}  // namespace eagerx::identification
