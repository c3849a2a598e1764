// The seam between a graph's program and the library that is compiled once for all graphs: the
// library's view of a graph, and what it calls. The program's own code (app.hpp) has the loop over
// steps and everything that depends on the graph's types; the library handles files, options,
// clocks, terminals and text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/link/star.hpp>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/safety.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/message_view.hpp>
#include <targets/linux-sim/recorder.hpp>
#include <targets/linux-sim/spaces.hpp>

namespace eagerx::linux_sim {

/// Another process is the agent: over DDS, or the one that started the program.
inline constexpr target::Agent kDdsAgent{target::kAgents}, kExternalAgent{target::kAgents + 1};

class Pictures;
class SplitLink;
class Watch;

/// The constants of a graph. Texts and tables are valid as long as the program.
struct GraphFacts {
  const char* name;
  const char* engine;
  std::uint64_t graph_hash;  // of what the program was generated from
  target::RunPlan plan;
  target::Agent agent;    // unless another one is named
  const char* agent_csv;  // its file, if it is `csv`
  bool has_policy;
  bool has_fast_policy;
  std::size_t self_test_rows;
  std::uint64_t rate_num, rate_den;  // of the environment [Hz]
  Safety safety;
  const Channel* channels;
  std::size_t channel_count;
  const ChannelShape* shapes;  // of channels whose messages are not one number
  std::size_t shape_count;
  const ChannelAlias* aliases;  // ports of composites
  std::size_t alias_count;
  const Bounds* bounds;  // null: no channel has some
  bool waits_in_resets;  // reset nodes
  bool is_shown;         // `render:`
  bool is_scene;         // … which is not an image
  std::size_t scene_rows;
  std::uint64_t render_num, render_den;  // pictures a second
  const link::PartFacts* parts;          // that are programs of their own
  std::size_t part_count;
  bool part_decides, part_knows_random;

  /// Whether others run a part of the graph.
  bool is_split() const { return part_count > 0; }

  double period_s() const { return static_cast<double>(rate_den) / static_cast<double>(rate_num); }
  /// Time of step `n`, with the bits of Rate::seconds<double>().
  double seconds(Seq n) const {
    return static_cast<double>(n * rate_den) / static_cast<double>(rate_num);
  }
};

/// One action, observation or state. Texts live as long as the program.
struct Field {
  const char* name = "";
  MessageType type;
  const void* low = nullptr;  // messages of the type, if there is a space; the listener copies them
  const void* high = nullptr;
  const char* id = "";     // of a state: what its samples are called
  std::size_t offset = 0;  // of an action, in Action
  bool tunable = false;    // a state that can be set while an episode runs
  std::uint32_t most = 1;  // messages of an observation that there can be
  bool varies = false;     // there can be fewer
};

/// Receives the fields of a graph, each kind in the graph's order.
class FieldListener {
 public:
  virtual void action(const Field& field) = 0;
  virtual void observation(const Field& field) = 0;
  virtual void state(const Field& field) = 0;
  /// A state that is sampled from the range of its space.
  virtual void range(const Field& field) = 0;
  /// A result of a step: the reward, flags, then the terms of the reward.
  virtual void outcome(const char* name, bool is_flag) = 0;

 protected:
  ~FieldListener() = default;
};

/// All states, each in its place; those without a value are unchanged.
struct StateRow {
  void* const* messages;  // [states]
  bool* has_value;        // [states]
};
/// All messages of all observations, each observation in its place.
struct ObservationRow {
  void* const* messages;  // [observations] oldest first, room for Field::most
  std::uint32_t* sizes;   // [observations] how many there are
};
/// The reward of a step.
struct OutcomeView {
  double reward = 0.0;
  bool terminated = false, truncated = false, success = false;
  const void* terms = nullptr;  // weighted; null without a task
  Scalar scalar = Scalar::f32;  // of the terms
};

/// Hears counts that are not 0, or all. A name is valid during the call.
class CountListener {
 public:
  virtual void count(const char* name, std::uint64_t count) = 0;

 protected:
  ~CountListener() = default;
};

/// The program of a graph. There are two of it: one that says nothing, which run() takes unless
/// `traced`, and one whose trace shows its messages to `recorder`, which all other functions mean.
/// Actions are Action objects of the program, as bytes.
class GraphProgram {
 public:
  Recorder recorder;
  SpaceCounts spaces;  // of both

  virtual const GraphFacts& facts() const = 0;
  virtual void list_fields(FieldListener& listener) const = 0;
  /// Whether the policy gives the same answers as in the generator.
  virtual bool policies_answer() const = 0;
  /// Whether the program's text was compiled with flags that keep its bits.
  virtual bool rounds_each_operation() const = 0;
  virtual bool is_real() const = 0;
  /// Null if nothing is shown.
  virtual Pictures* pictures() const = 0;
  /// To part `part` of GraphFacts::parts. Null: there are fewer.
  virtual SplitLink* link(std::size_t part) = 0;

  /// The episodes of `watch.plan()`; ends early when `watch` says so. Safe when it returns.
  virtual void run(Watch& watch, bool traced) = 0;
  virtual void list_counts(bool traced, CountListener& listener) const = 0;
  virtual std::uint64_t hash() const = 0;

  virtual std::size_t action_bytes() const = 0;
  virtual void zero(void* action) const = 0;
  virtual void sample(EpisodeKey key, StateRow states) const = 0;
  virtual void warm_up() = 0;
  /// Begins episode `episode` with the values in `states`.
  virtual void reset(std::uint32_t episode, StateRow states) = 0;
  /// The request of an agent that is not a file, after the observation that the last call led to.
  virtual void act(target::Agent agent, EpisodeKey key, Seq step, void* action) = 0;
  virtual void guard(void* action) = 0;
  /// Sets the values in `states` between two steps. Only for fields with Field::tunable.
  virtual void tune(StateRow states) = 0;
  /// One step with an action that the guard has seen, or that is repeated from a log.
  virtual void apply(void* action) = 0;

 protected:
  ~GraphProgram() = default;
};

/// The main function: reads the command line, runs, returns the exit code (see --help).
int run(int argc, char** argv, GraphProgram& program);

}  // namespace eagerx::linux_sim
