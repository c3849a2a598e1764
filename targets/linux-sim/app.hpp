// The program of a graph on target linux-sim: the loop over its steps, and code that depends on its
// types. Everything else is in the library behind graph_program.hpp, compiled once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math/rounding_check.hpp>
#include <memory>
#include <optional>
#include <runtime/host/base/exhaustion.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <string_view>
#include <targets/common/csv.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/hooks.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/rows.hpp>
#include <targets/linux-sim/watch.hpp>
#include <utility>

// Called before and after all episodes, if defined: tests link a guard that forbids allocations in
// between, benchmarks a counter.
extern "C" {
[[gnu::weak]] void eagerx_run_begins();
[[gnu::weak]] void eagerx_run_ends();
}

namespace eagerx::linux_sim {

/// The link of a split graph: split_app.hpp. A whole one has none.
template <class Graph>
class LinkOf {
 public:
  static constexpr bool kIsSplit = false;
  static constexpr bool kPartDecides = false;
  template <class Hooks>
  using Program = typename Graph::template Program<Hooks>;

  static void tell(GraphFacts& /*facts*/) {}
  static SplitLink* link(std::size_t /*part*/) { return nullptr; }
  template <class Program>
  static void connect(Program& /*program*/) {}
  static void begin(EpisodeKey /*key*/, target::Agent /*agent*/) {}
  template <class Program>
  static void make_safe(Program& /*program*/) {}
};

/// Passes the events of run_episodes() to the library's watch.
template <class Graph>
class GraphWatch : public target::Watch<Graph> {
 public:
  using typename target::Watch<Graph>::Action;
  using typename target::Watch<Graph>::Observation;
  using typename target::Watch<Graph>::Outcome;
  using typename target::Watch<Graph>::States;

  GraphWatch(Watch& watch, LinkOf<Graph>& link) : watch_(watch), link_(link) {}

  bool go_on() { return watch_.go_on(); }
  bool link_again() { return LinkOf<Graph>::kIsSplit && watch_.link_again(); }
  bool is_over() const { return watch_.is_over(); }
  bool looks() const { return watch_.looks(); }
  std::uint64_t late_in_a_row() const { return watch_.late_in_a_row(); }

  EpisodeKey key(EpisodeKey planned) { return watch_.key(planned); }
  void begin(EpisodeKey key) { link_.begin(key, watch_.agent()); }
  States states(EpisodeKey key) {
    States states = Graph::sample(key);
    const StateRow row = watch_.states();
    copy_states<Graph>(states, row);
    if (watch_.begin_episode(key, row)) take_states<Graph>(row, states);
    return states;
  }
  void reset(std::uint32_t episode, const Observation& observation) {
    if (auto* const table = watch_.table()) {
      // The first episode of all may be over before its first observation.
      if (!std::exchange(has_header_, true))
        Table::header(*table, observation, [&](auto&) { watch_.state_column_names(); });
      row(*table, episode, 0, observation, nullptr, nullptr);
    }
    if (watch_.has_external_agent())
      copy_observation<Graph>(observation, watch_.external_observation());
    watch_.reset(episode);
  }
  void step(std::uint32_t episode, Seq step, const Action& action, const Observation& observation,
            const Outcome& outcome) {
    if (auto* const table = watch_.table())
      row(*table, episode, step, observation, &action, &outcome);
    if (watch_.has_external_agent()) {
      copy_observation<Graph>(observation, watch_.external_observation());
      watch_.applied(&action);
    }
    watch_.step(step, target::has_ended(outcome), view_of_outcome(outcome));
  }

  /// The agent's action, with faults of its inputs and outputs. Parameters are set before it.
  template <class Program>
  Action action(EpisodeKey key, Seq step, const Observation& observation, Program& program) {
    if constexpr (requires { Graph::kTunable; }) {
      if (watch_.tunes()) tune(key, step, program);
    }
    if (!watch_.has_faults()) return wanted(key, step, observation, program);
    copy_observation<Graph>(observation, watch_.observations());
    Observation seen = observation;
    show_row<Graph>(watch_.seen(step), seen);
    Action action = wanted(key, step, seen, program);
    watch_.given(step, &action);
    return action;
  }

 private:
  using Table = target::CsvTable<Graph, TableWriter>;

  template <class Program>
  [[gnu::noinline, gnu::cold]] void tune(EpisodeKey key, Seq step, Program& program) {
    const StateRow row = watch_.states();
    if (!watch_.tune(key.episode, step, row)) return;
    States states;
    take_states<Graph>(row, states);
    target::tune(program, states);
  }
  template <class Program>
  Action wanted(EpisodeKey key, Seq step, const Observation& observation, Program& program) {
    if (watch_.agent() < target::Agent::csv)
      return target::act<Graph>(watch_.agent(), key, step, observation, program);
    return given(step, observation);
  }
  /// The action of a file, or of another process.
  [[gnu::noinline, gnu::cold]] Action given(Seq step, const Observation& observation) {
    if (watch_.agent() == kDdsAgent) copy_observation<Graph>(observation, watch_.observations());
    const void* const row = watch_.given_action(step);
    return row != nullptr ? *static_cast<const Action*>(row) : Graph::zero();
  }
  [[gnu::noinline, gnu::cold]] void row(TableWriter& table, std::uint32_t episode, Seq step,
                                        const Observation& observation, const Action* action,
                                        const Outcome* outcome) {
    Table::row(table, episode, step, observation, action, outcome,
               [&](auto&) { watch_.state_columns(); });
  }

  Watch& watch_;
  LinkOf<Graph>& link_;
  bool has_header_ = false;
};

/// The action of the supervisor with its copy of `program` if this one is killed; nullptr: none.
template <class Program>
host::Supervisor::TakeOver how_to_take_over(const Program& program) {
  if constexpr (requires(Program & copy) { copy.take_over(); }) {
    if (target::is_real(program)) {
      return [](void* context) {
        auto& copy = *static_cast<Program*>(context);
        copy.take_over();
        bool is_safe = true;
        target::for_each_fault(copy, [&](std::string_view name, std::uint64_t count) {
          is_safe = is_safe && (count == 0 || name != "ends without a safe action");
        });
        return is_safe;
      };
    }
  }
  return nullptr;
}

/// A run from its first reset to its last step, and then until everything is safe.
template <class Graph, class Program>
void run_program(Watch& watch, LinkOf<Graph>& link, Program& program) {
  GraphWatch<Graph> seen(watch, link);
  const auto agent = [&](EpisodeKey key, Seq step, const typename Graph::Observation& observation) {
    if constexpr (LinkOf<Graph>::kPartDecides) {
      // That part has agent and guard.
      program.link().set_late(watch.late_in_a_row());
      return Graph::zero();
    } else {
      return seen.action(key, step, observation, program);
    }
  };
  link.connect(program);
  const host::Supervisor supervisor(how_to_take_over(program), &program,
                                    Graph::kSafety.heartbeat_timeout_ns);
  target::warm_up(program);  // a library may need memory for it, and none afterwards
  const host::MadeSafe<Program> made_safe(program);
  if (eagerx_run_begins != nullptr) eagerx_run_begins();
  target::run_episodes<Graph>(watch.plan(), program, agent, seen);
  const bool ends_early = watch.ends_early();
  if constexpr (requires { program.make_safe(); }) {
    // At once: a last step may wait for its instant, or for a board.
    if (ends_early && program.is_real()) program.make_safe();
  }
  if (Graph::kSafety.declared && ends_early && target::is_linked(program)) {
    LinkOf<Graph>::make_safe(program);
    target::step_safely<Graph>(program);
  }
  target::drain(program);
  if (eagerx_run_ends != nullptr) eagerx_run_ends();
  target::stop(program);
}

/// Both programs of a graph. All zero until their first reset, so they take no space in the
/// executable.
template <class Graph>
struct Programs {
  template <class Hooks>
  using Of = typename LinkOf<Graph>::template Program<Hooks>;

  Of<UntracedHooks<Graph>> untraced;
  Of<TracedHooks<Graph>> traced;
};

template <class Graph>
class ProgramOf final : public GraphProgram {
 public:
  explicit ProgramOf(Programs<Graph>& programs)
      : untraced_(programs.untraced), traced_(programs.traced) {
    untraced_.hooks.spaces = &spaces;
    traced_.hooks.spaces = &spaces;
    traced_.hooks.recorder = &recorder;
    if constexpr (requires { Graph::kRenders; }) {
      pictures_ = make_pictures();
      untraced_.hooks.pictures = pictures_.get();
      traced_.hooks.pictures = pictures_.get();
    }
  }
  const GraphFacts& facts() const override {
    static const GraphFacts facts = known();
    return facts;
  }
  void list_fields(FieldListener& listener) const override {
    list_actions<Graph>(listener);
    list_observations<Graph>(listener);
    list_states<Graph>(listener);
    list_outcomes<Graph>(listener);
  }
  bool policies_answer() const override { return Graph::policies_answer(); }
  bool rounds_each_operation() const override { return eagerx::rounds_each_operation(); }
  bool is_real() const override { return target::is_real(untraced_); }
  Pictures* pictures() const override { return pictures_.get(); }
  SplitLink* link(std::size_t part) override { return link_.link(part); }

  void run(Watch& watch, bool is_traced) override {
    is_traced ? run_program<Graph>(watch, link_, traced_)
              : run_program<Graph>(watch, link_, untraced_);
  }
  void list_counts(bool is_traced, CountListener& listener) const override {
    const auto count = [&](const char* name, std::uint64_t n) { listener.count(name, n); };
    is_traced ? target::for_each_fault(traced_, count) : target::for_each_fault(untraced_, count);
  }
  std::uint64_t hash() const override { return traced_.hooks.hash(); }

  std::size_t action_bytes() const override { return sizeof(Action); }
  void zero(void* action) const override { *static_cast<Action*>(action) = Graph::zero(); }
  void sample(EpisodeKey key, StateRow states) const override {
    copy_states<Graph>(Graph::sample(key), states);
  }
  void warm_up() override { target::warm_up(traced_); }
  void reset(std::uint32_t episode, StateRow states) override {
    if constexpr (!LinkOf<Graph>::kIsSplit) {
      typename Graph::States begin;
      take_states<Graph>(states, begin);
      traced_.hooks.on_episode(episode);
      observation_.emplace(traced_.reset(begin));
    }
  }
  void act(target::Agent agent, EpisodeKey key, Seq step, void* action) override {
    if constexpr (!LinkOf<Graph>::kIsSplit)
      *static_cast<Action*>(action) = target::act<Graph>(agent, key, step, *observation_, traced_);
  }
  void tune(StateRow states) override {
    if constexpr (!LinkOf<Graph>::kIsSplit) {
      typename Graph::States set;
      take_states<Graph>(states, set);
      target::tune(traced_, set);
    }
  }
  void guard(void* action) override {
    auto& checked = *static_cast<Action*>(action);
    checked = target::guarded(traced_, checked, 0);  // a log tells no lateness
  }
  void apply(void* action) override {
    if constexpr (!LinkOf<Graph>::kIsSplit)
      observation_.emplace(target::apply(traced_, *static_cast<Action*>(action)));
  }

 private:
  using Action = typename Graph::Action;
  using UntracedProgram = decltype(Programs<Graph>::untraced);

  static GraphFacts known() {
    GraphFacts facts{};
    facts.name = Graph::kName;
    facts.engine = Graph::kEngine;
    facts.graph_hash = Graph::kGraphHash;
    facts.plan = target::default_plan<Graph>();
    facts.agent = target::default_agent<Graph>();
    facts.agent_csv = Graph::kAgentCsv;
    facts.has_policy = Graph::kHasPolicy;
    facts.has_fast_policy = requires {
      Graph::kHasFastPolicy;
    };
    facts.self_test_rows = Graph::kSelfTestRows;
    facts.rate_num = Graph::Rate::num;
    facts.rate_den = Graph::Rate::den;
    facts.safety = Graph::kSafety;
    facts.channels = Graph::kChannels;
    facts.channel_count = sizeof(Graph::kChannels) / sizeof(Channel);
    if constexpr (requires { Graph::kShapes; }) {
      facts.shapes = Graph::kShapes;
      facts.shape_count = sizeof(Graph::kShapes) / sizeof(ChannelShape);
    }
    if constexpr (requires { Graph::kAliases; }) {
      facts.aliases = Graph::kAliases;
      facts.alias_count = sizeof(Graph::kAliases) / sizeof(ChannelAlias);
    }
    if constexpr (requires { Graph::kBounds; }) facts.bounds = Graph::kBounds;
    facts.waits_in_resets = requires(UntracedProgram program) {
      program.reset_timeouts();
    };
    if constexpr (requires { Graph::kRenders; }) {
      facts.is_shown = true;
      facts.render_num = Graph::RenderRate::num;
      facts.render_den = Graph::RenderRate::den;
    }
    if constexpr (shows_scene<Graph>) {
      facts.is_scene = true;
      facts.scene_rows = kSceneRows<typename Graph::Rendered>;
    }
    LinkOf<Graph>::tell(facts);
    return facts;
  }

  UntracedProgram& untraced_;
  decltype(Programs<Graph>::traced)& traced_;
  std::unique_ptr<Pictures> pictures_;
  [[no_unique_address]] LinkOf<Graph> link_;
  std::optional<typename Graph::Observation> observation_;
};

template <class Graph>
int run(int argc, char** argv) {
  host::end_when_exhausted();
  constinit static Programs<Graph> programs{};
  static ProgramOf<Graph> program(programs);
  return run(argc, argv, program);
}

}  // namespace eagerx::linux_sim
