#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <runtime/host/identify/experiment.hpp>

namespace eagerx::identification {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

bool is_among(std::string_view name, std::string_view list) {
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    if (list.substr(0, comma) == name) return true;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return false;
}

/// The first of the names that is no sensor with messages in the log, and those that are. Empty if
/// there is none such name.
std::string wrong_name(const trace_log::Log& log, std::span<const Channel> channels,
                       std::string_view names) {
  const auto is_sensor = [&](const Channel& channel) {
    return channel.publisher == Publisher::engine_node && log.channel(channel.name).has_value();
  };
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(','));
    names.remove_prefix(std::min(name.size() + 1, names.size()));
    std::string known;
    bool found = false;
    for (const Channel& channel : channels) {
      if (!is_sensor(channel)) continue;
      found = found || name == channel.name;
      known += (known.empty() ? "" : ", ") + std::string(channel.name);
    }
    if (!found)
      return log.path + ": error: the log has no messages of a sensor `" + std::string(name) +
             "`\nhelp: its sensors are " + (known.empty() ? "none" : known);
  }
  return {};
}

}  // namespace

bool Experiment::prepare(const trace_log::Log& log, const RepeatingProgram& program,
                         const std::string& sensors, double horizon_s, std::string& problem) {
  const std::span<const Channel> channels = program.channels;
  steps_hz_ = static_cast<double>(program.steps_num) / static_cast<double>(program.steps_den);
  log_is_simulated_ = log.engine == program.engine;
  log_ = &log;
  facts_ = channels;
  counts_.assign(channels.size(), false);
  in_log_.assign(channels.size(), std::nullopt);
  first_group_.assign(channels.size(), kNone);
  likeness_.assign(channels.size(), {});
  rows_.assign(channels.size(), std::vector<std::vector<std::size_t>>(log.episodes()));
  std::vector<std::size_t> here(log.channels.size(), kNone);
  std::size_t counting = 0;
  for (std::uint32_t i = 0; i < channels.size(); ++i) {
    if (channels[i].publisher == Publisher::engine) engine_ = &channels[i];
    has_actions_ = has_actions_ || channels[i].publisher == Publisher::environment;
    in_log_[i] = log.channel(channels[i].name);
    if (!in_log_[i]) continue;
    here[*in_log_[i]] = i;
    counts_[i] = channels[i].publisher == Publisher::engine_node &&
                 (sensors.empty() || is_among(channels[i].name, sensors));
    counting += counts_[i];
  }
  for (std::size_t row = 0; row < log.rows.size(); ++row) {
    const trace_log::Row& message = log.rows[row];
    if (here[message.channel] == kNone) continue;
    auto& rows = rows_[here[message.channel]][message.episode];
    if (message.seq == 0) rows.clear();  // of the reset routine
    if (message.seq == rows.size()) rows.push_back(row);
  }
  problem = wrong_name(log, channels, sensors);
  if (!problem.empty()) return false;
  if (counting == 0) {
    problem = log.path + ": error: the log has no message of a sensor of this program";
    return false;
  }
  const double rate_hz =
      static_cast<double>(engine_->rate_num) / static_cast<double>(engine_->rate_den);
  ticks_in_segment_ = std::max<Seq>(2, static_cast<Seq>(std::llround(horizon_s * rate_hz)));
  return true;
}

/// An action is sent in every step. Without actions nothing waits for a step to begin, so the last
/// step is the one that the latest message belongs to.
std::uint64_t Experiment::steps(std::uint32_t episode) const {
  std::uint64_t actions = 0, until_latest = 0;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const std::uint64_t count = rows_[i][episode].size();
    if (facts_[i].publisher == Publisher::environment) actions = std::max(actions, count);
    if (count < 2) continue;
    const double time_s = static_cast<double>((count - 1) * facts_[i].rate_den) /
                          static_cast<double>(facts_[i].rate_num);
    constexpr double kRounding = 1e-9;
    const double step = std::ceil(time_s * steps_hz_ * (1.0 - kRounding));
    until_latest = std::max(until_latest, static_cast<std::uint64_t>(step));
  }
  return has_actions_ ? actions : until_latest;
}

void Experiment::begin(const Trial* trial) {
  trial_ = trial;
  residuals_.clear();
  segment_ = 0;
  has_segment_ = false;
  if (trial == nullptr) {
    samples_.clear();
  } else {
    arrivals_.resize(trial->states.size());
  }
}

void Experiment::episode(std::uint32_t index) {
  episode_ = index;
}

void Experiment::simulator(std::string_view name, Seq tick, const SimulatorView& simulator) {
  const std::size_t i = object(name, simulator.state.size, simulator.input.size);
  inputs_[i] = simulator.input;
  if (i == 0) next_tick(tick);
  if (tick == 0) note_input(i);
  if (trial_ == nullptr) return note_state(i, simulator.state);
  if (begins_segment_) {
    const std::size_t first = segment_ * states() + objects_[i].first_state;
    for (std::size_t k = 0; k < simulator.state.size; ++k) {
      arrivals_[first + k] = simulator.state.get(k);
      simulator.state.set(k, trial_->states[first + k]);
    }
    if (simulator.step_bytes > 0) std::memset(simulator.step, 0, simulator.step_bytes);
  }
}

/// Sensors read what acted until now, unless the actuator has sent something in the meantime. So
/// the input changes at the actuator's place in the order of the nodes, or here.
void Experiment::engine_runs() {
  for (std::size_t i = 0; i < objects_.size(); ++i) apply_input(i);
}

void Experiment::note_state(std::size_t i, const Numbers& state) {
  for (std::size_t k = 0; k < state.size; ++k) {
    const double value = state.get(k);
    double& scale = state_scale_[objects_[i].first_state + k];
    if (value - value == 0.0) scale = std::max(scale, value < 0.0 ? -value : value);
  }
}

std::size_t Experiment::object(std::string_view name, std::size_t states, std::size_t inputs) {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (objects_[i].name == name) return i;
  }
  objects_.push_back({std::string(name), total_states_, states, inputs});
  inputs_.emplace_back();
  first_inputs_.emplace_back();
  actuator_of_.push_back(kNone);
  total_states_ += states;
  state_scale_.resize(total_states_, 0.0);
  return objects_.size() - 1;
}

void Experiment::next_tick(Seq tick) {
  tick_ = tick;
  begins_segment_ = tick % ticks_in_segment_ == 0;
  if (!begins_segment_) return;
  segment_ += has_segment_;
  has_segment_ = true;
  std::fill(positions_.begin(), positions_.end(), 0);
}

void Experiment::note_input(std::size_t object) {
  std::vector<double>& first = first_inputs_[object];
  first.resize(inputs_[object].size);
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = inputs_[object].get(i);
}

/// The command of the log's actuator in its tick `tick`.
double Experiment::input_of_tick(std::size_t object, std::size_t element, std::int64_t tick) const {
  const std::uint32_t channel = actuators_[actuator_of_[object]];
  const auto& rows = rows_[channel][episode_];
  if (tick < 0 || rows.empty()) return first_inputs_[object][element];
  const std::uint64_t* const values =
      find(channel, std::min<Seq>(static_cast<Seq>(tick), rows.size() - 1));
  return trace_log::number_of(log_->channels[*in_log_[channel]].dtype, values[element]);
}

/// The mean over the engine's step that begins at `begin`, in ticks of the engine, of what the
/// commands of the log's actuator. In a simulation a message acts from the beginning of the
/// engine's step
/// on that it is sent in (SEMANTICS §6), else from when it is sent.
double Experiment::mean_input(std::size_t object, std::size_t element, double begin) const {
  const Channel& fact = facts_[actuators_[actuator_of_[object]]];
  const double in_a_step = static_cast<double>(fact.rate_num * engine_->rate_den) /
                           static_cast<double>(fact.rate_den * engine_->rate_num);
  constexpr double kRounding = 1e-9;
  // The last message that acts at a time, and when the next one does.
  const auto newest = [&](double time) {
    const double until = log_is_simulated_ ? std::floor(time) + 1.0 : time;
    const double sent = until * in_a_step;
    return static_cast<std::int64_t>(log_is_simulated_ ? std::ceil(sent - kRounding) - 1.0
                                                       : std::floor(sent + kRounding));
  };
  const auto acts_from = [&](std::int64_t message) {
    const double sent = static_cast<double>(message) / in_a_step;
    return log_is_simulated_ ? std::floor(sent + kRounding) : sent;
  };
  const double end = begin + kRounding + 1.0;
  double sum = 0.0;
  for (double from = begin + kRounding; from < end;) {
    const std::int64_t message = newest(from);
    const double to = std::min(std::max(acts_from(message + 1), from + kRounding), end);
    sum += (to - from) * input_of_tick(object, element, message);
    from = to;
  }
  return sum;
}

/// The input of the engine's step that begins now, with the trial's delay.
void Experiment::apply_input(std::size_t object) {
  const std::size_t actuator = actuator_of_[object];
  if (trial_ == nullptr || actuator >= actuators_.size()) return;
  const double begin = static_cast<double>(tick_) - trial_->delays[actuator];
  for (std::size_t i = 0; i < inputs_[object].size; ++i)
    inputs_[object].set(i, mean_input(object, i, begin));
}

const std::uint64_t* Experiment::find(std::uint32_t channel, Seq seq) const {
  const auto& rows = rows_[channel];
  if (episode_ >= rows.size() || seq >= rows[episode_].size()) return nullptr;
  return log_->values_of(log_->rows[rows[episode_][seq]]);
}

/// The object that the engine node of this channel belongs to.
std::optional<std::size_t> Experiment::owner(std::uint32_t channel) const {
  const std::string_view name = facts_[channel].name;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const std::string& object = objects_[i].name;
    if (name.starts_with(object) && name.substr(object.size()).starts_with('/')) return i;
  }
  return std::nullopt;
}

void Experiment::measured(std::uint32_t channel, const std::uint64_t* recorded) {
  if (trial_ == nullptr) {
    note_actuator(channel);
  } else if (const auto object = owner(channel)) {
    const std::size_t actuator = actuator_of_[*object];
    if (actuator < actuators_.size() && actuators_[actuator] == channel)
      return apply_input(*object);
  }
  if (recorded == nullptr || !counts_[channel] || !has_segment_) return;
  const trace_log::Dtype dtype = log_->channels[*in_log_[channel]].dtype;
  if (first_group_[channel] == kNone) {
    first_group_[channel] = groups_.size();
    for (std::size_t i = 0; i < numbers_.size(); ++i) groups_.push_back({channel, i});
    positions_.resize(groups_.size(), 0);
  }
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const std::size_t group = first_group_[channel] + i;
    const double value = trace_log::number_of(dtype, recorded[i]);
    if (!std::isfinite(value)) continue;
    residuals_.push_back(numbers_[i] - value);
    if (trial_ == nullptr) {
      samples_.push_back({static_cast<std::uint32_t>(segment_), static_cast<std::uint32_t>(group),
                          positions_[group]});
    }
    ++positions_[group];
  }
}

/// An actuator has just set the input if what it sends is the input, every time.
void Experiment::note_actuator(std::uint32_t channel) {
  const auto object = owner(channel);
  Likeness& likeness = likeness_[channel];
  likeness.differs = likeness.differs || !object || inputs_[*object].size != numbers_.size();
  for (std::size_t i = 0; i < numbers_.size() && !likeness.differs; ++i) {
    likeness.differs = inputs_[*object].get(i) != numbers_[i];
    likeness.seen = likeness.seen || numbers_[i] != 0.0;
  }
}

void Experiment::find_actuators() {
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    if (likeness_[i].differs || !likeness_[i].seen || !in_log_[i]) continue;
    const auto object = owner(i);
    if (!object || actuator_of_[*object] != kNone) continue;
    actuator_of_[*object] = actuators_.size();
    actuators_.push_back(i);
    counts_[i] = false;
  }
  groups_.clear();
  positions_.clear();
  std::fill(first_group_.begin(), first_group_.end(), kNone);
}

std::vector<double> Experiment::group_scale() const {
  std::vector<double> scale(groups_.size(), 0.0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const std::uint32_t channel = groups_[g].channel;
    const trace_log::Dtype dtype = log_->channels[*in_log_[channel]].dtype;
    for (const auto& rows : rows_[channel]) {
      for (const std::size_t row : rows) {
        const double value =
            trace_log::number_of(dtype, log_->values_of(log_->rows[row])[groups_[g].element]);
        scale[g] = std::max(scale[g], std::abs(value));
      }
    }
  }
  return scale;
}

}  // namespace eagerx::identification
