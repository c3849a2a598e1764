// --set: values of states for this run, instead of the graph's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// One `NAME=VALUE`, `NAME=VALUE,VALUE,…`, both with `@STEP` for a parameter while it runs, or
/// `NAME=DISTRIBUTION:NUMBER,NUMBER,…`.
struct StateSetting {
  enum class Kind : std::uint8_t { value, uniform, log_uniform, normal, choice };
  std::string name;  // "pendulum.mass"
  Kind kind = Kind::value;
  std::vector<double> numbers;
  std::optional<Seq> step;  // before which it is set; else at resets
  std::string written;      // the text behind `=`

  /// For elements beyond the last number, the first group again.
  double number(std::size_t group, std::size_t i) const {
    const std::size_t size = numbers.size() / groups();
    return numbers[group * size + (size == 1 ? 0 : i)];
  }
  /// Lists that the numbers are: low and high, mean and std; else one.
  std::size_t groups() const { return kind == Kind::value || kind == Kind::choice ? 1 : 2; }
};

/// nullopt if the text is none of the forms.
std::optional<StateSetting> parse_setting(std::string_view text);

/// The message for an unknown state.
std::string unknown_state(const std::string& name, const std::vector<std::string>& known);
/// The problem with the numbers for a state of `size` elements within [low[i], high[i]], or
/// nothing.
std::string problem_of(const StateSetting& setting, const std::vector<double>& low,
                       const std::vector<double>& high);

/// The settings of a run for the states of a graph.
class StateSettings {
 public:
  explicit StateSettings(const std::vector<Field>& states) : states_(states) {}

  /// The problem of `texts`, or nothing.
  std::string read(const std::vector<std::string>& texts);

  /// Stores the settings in `states`, sampled like the graph's own states: the same numbers for the
  /// same key. Does not allocate. False if nothing is set.
  bool apply(EpisodeKey key, StateRow states) const;

  /// Whether something is set while an episode runs.
  bool tunes() const { return !running_.empty(); }
  /// Stores the settings before step `step` (from 0) of every episode in `states`. False if there
  /// are none.
  bool apply_at(Seq step, StateRow states) const;

 private:
  struct Running {
    std::size_t state;
    StateSetting setting;
  };

  std::string not_tunable(const StateSetting& setting) const;

  const std::vector<Field>& states_;
  std::vector<std::optional<StateSetting>> settings_;  // of each, or none at all
  std::vector<Running> running_;                       // as given; the last one counts
};

}  // namespace eagerx::linux_sim
