// --until, --measure, --summary: the end of an episode, and measures of all episodes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <runtime/host/expression/calculation.hpp>
#include <string>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// The source of a name in an expression: an element of the newest message of a port, of an
/// observation or of a state, or the time of the episode.
struct Variable {
  enum class Kind : std::uint8_t { message, observation, state, time };
  Kind kind = Kind::time;
  std::uint32_t number = 0;  // of the channel, the observation, the state
  std::size_t element = 0;
  std::optional<std::size_t> now =
      std::nullopt;  // of its value one step before: where the value is
  friend bool operator==(const Variable&, const Variable&) = default;
};

/// One that a graph offers.
struct Readable {
  std::string name;  // "pendulum.theta"
  Variable::Kind kind;
  std::uint32_t number;
  std::uint64_t size;
  std::vector<std::string> also = {};  // other names of it
};

/// Mean and deviation of one number an episode, and the episodes with the least and the most.
class Statistic {
 public:
  void add(double value, std::uint64_t episode);
  std::uint64_t count() const { return count_; }
  /// "mean 1.2 s, deviation 0.1 s, least 1 s (episode 3), most 1.4 s (episode 7)"
  std::string text(std::string_view unit) const;
  std::string mean_text(std::string_view unit) const;
  double most() const { return most_; }
  std::uint64_t most_episode() const { return most_episode_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0;  // Welford's sums
  double least_ = 0.0, most_ = 0.0;
  std::uint64_t least_episode_ = 0, most_episode_ = 0;
};

/// The expressions of a run, and their results so far. Nothing allocates after prepare().
class Measures {
 public:
  static constexpr std::size_t kMostVariables = 64;

  /// The problem of the expressions, or nothing. `until` may be empty.
  std::string prepare(const std::string& until, const std::vector<std::string>& measures,
                      bool summary, const std::vector<Readable>& readables);

  bool is_used() const { return has_until_ || !quantities_.empty() || summary_; }
  bool reads_messages() const { return reads_messages_; }

  /// Stores the value of a variable.
  void set(Variable::Kind kind, std::uint32_t number, std::size_t element, double value) {
    for (std::size_t i = 0; i < variables_used_; ++i) {
      if (variables_[i] == Variable{kind, number, element}) values_[i] = value;
    }
  }
  void set_message(Variable::Kind kind, std::uint32_t number, MessageView message);

  void begin_episode();
  /// After a step, or a reset (step 0): evaluates. Time in seconds.
  void step(std::uint64_t step, double time_s);
  /// Whether `until` holds.
  bool is_over() const { return is_over_; }
  void end_episode();
  void describe(Summary& summary) const;

 private:
  /// As it was written, and ready to be calculated.
  struct Formula {
    std::string text;
    expression::Calculation calculation;
  };
  struct Quantity {
    Formula formula;
    double sum = 0.0, most = 0.0;  // of this episode
    std::uint64_t samples = 0;     // that are numbers
    Statistic means, worst;        // of all episodes
  };
  std::string read(const char* option, const std::string& text, expression::Type type,
                   const std::vector<Readable>& readables, Formula& formula);
  std::optional<std::size_t> place_of(const Variable& variable);
  void keep_before();

  Formula until_;
  bool has_until_ = false;
  bool summary_ = false;
  bool reads_messages_ = false;
  bool is_over_ = false;
  std::vector<Quantity> quantities_;
  std::array<Variable, kMostVariables> variables_{};
  std::array<double, kMostVariables> values_{};
  std::size_t variables_used_ = 0;
  std::uint64_t episodes_ = 0;  // begun
  bool has_begun_ = false;      // an episode
  double last_step_ = 0.0, last_time_s_ = 0.0;
  Statistic lengths_, times_;
};

/// The names for expressions of a graph's program.
std::vector<Readable> readables_of(const GraphFacts& facts, const std::vector<Field>& states);

}  // namespace eagerx::linux_sim
