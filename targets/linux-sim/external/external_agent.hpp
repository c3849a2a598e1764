// An external agent, such as Python's, at the other end of a socket. The loop waits for it for a
// part of a period only, and then applies a safe action.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <targets/linux-sim/external/external_rows.hpp>
#include <targets/linux-sim/external/protocol.hpp>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <vector>

namespace eagerx::linux_sim {

struct Options;

/// Nothing here allocates between two steps, but for answers to `describe` and `counts`.
class ExternalAgent {
 public:
  /// `traced`: which of the two programs runs.
  ExternalAgent(const Options& options, const Fields& fields, GraphProgram& program, bool traced);

  ExternalAgent(const ExternalAgent&) = delete;
  ExternalAgent& operator=(const ExternalAgent&) = delete;
  ~ExternalAgent();

  /// Checks the socket. Empty, or the problem.
  std::string open();

  /// Memory for the agent's next observation.
  ObservationRow observation() { return {seen_.data(), sizes_.data()}; }
  /// The action applied in the step whose observation comes next.
  void applied(const void* action) { rows_.write_action(action, applied_row()); }
  void reset(std::uint32_t episode);
  /// `is_longest`: there are no more steps in an episode.
  void step(Seq step, bool has_ended, bool is_longest, const OutcomeView& outcome);

  /// Answers, and waits for the next request. In an episode this is an action: waits until it would
  /// be late if time does not wait for it, otherwise forever. Between episodes it is a reset.
  /// False: the run ends.
  bool go_on();
  /// Whether an episode ends because the agent requests another one.
  bool wants_reset() const { return wants_reset_; }
  /// The action of the next step: the agent's, or its last one if it is late.
  const void* action() const { return action_.data(); }
  /// Steps in a row that had no action in time.
  std::uint64_t late_in_a_row() const { return late_in_a_row_; }

  /// The key of an episode that begins: of the seed that the agent gave.
  EpisodeKey key(EpisodeKey planned);
  /// Replaces sampled states with those of the agent. False if there are none.
  bool apply_states(StateRow states);
  /// The same of parameters that it gave since the last step.
  bool apply_parameters(StateRow states);

  /// Whether the run ends within an episode, and the hardware may have relied on the agent.
  bool leaves_something() const { return in_episode_ && ends_ && (is_real_ || !is_announced_); }
  /// The agent's fault that ended the run, or empty.
  const std::string& problem() const { return problem_; }

 private:
  enum class Got : std::uint8_t { request, nothing, end };

  bool is_gone() const;
  Got receive(std::int64_t until_ns);
  bool serve();
  bool take_reset();
  bool take_step();
  void take_parameters();
  void give_picture();
  void answer_observation();
  void answer_problem(const std::string& text);
  void answer_piece(const void* data, std::size_t bytes);
  void say(Answer answer, const void* data, std::size_t bytes);
  std::string description() const;
  void describe_task(host::Json& json) const;
  void describe_render(host::Json& json) const;
  std::string counts() const;
  void lose(std::string why);

  float* applied_row() { return row_.data() + terms_.size(); }
  float* observation_row() { return applied_row() + rows_.action_numbers(); }

  const Options& options_;
  const GraphFacts& facts_;
  GraphProgram& program_;
  const Fields& fields_;
  ExternalRows rows_;
  MessageRows seen_;
  StateMemory sampled_;
  std::vector<std::uint32_t> sizes_;  // [observations]
  std::vector<std::max_align_t> action_;
  std::vector<double> terms_;  // of all steps since the last answer
  std::vector<float> row_;     // of an answer: terms, action, observation
  std::vector<float> given_;   // of a request: a row of actions or states
  std::vector<float> states_;  // of the next episode
  std::vector<float> tuned_;   // before the next step; NaN: as it is
  Answer answer_{};            // the next one with an observation
  Request request_{};          // the last one
  std::string text_;           // of which pieces are asked for
  int socket_ = -1;
  std::int64_t patience_ns_ = 0;  // 0: for ever
  bool is_traced_ = false, is_real_ = false;

  std::uint64_t late_in_a_row_ = 0;
  std::uint64_t seed_ = 0;
  std::uint32_t episode_of_seed_ = 0;
  bool has_seed_ = false, has_states_ = false, has_tuned_ = false;
  bool waits_ = false;        // the agent waits for an observation
  bool in_episode_ = false;   // and not behind its last step
  bool end_is_news_ = false;  // an episode has ended in a step that the agent was late for
  bool wants_reset_ = false;
  bool ends_ = false;
  bool is_announced_ = false;  // the agent has said that the run ends
  std::string problem_;
};

}  // namespace eagerx::linux_sim
