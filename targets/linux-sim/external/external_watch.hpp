// Watches a run whose agent is at the other end of a socket.
#pragma once

#include <algorithm>
#include <targets/linux-sim/external/external_agent.hpp>
#include <targets/linux-sim/run_watch.hpp>

namespace eagerx::linux_sim {

/// `Base`: RunWatch, or a class derived from it. The agent gets its answer before the wait for the
/// step, so that it has the whole period for its action.
template <class Base>
class ExternalWatch final : public Base {
 public:
  template <class... Arguments>
  ExternalWatch(ExternalAgent& agent, GraphProgram& program, const RunInputs& inputs,
                Arguments&... arguments)
      : Base(program, inputs, arguments...), agent_(agent) {
    this->paces_ = true;
    this->tunes_ = this->tunes_ || std::ranges::any_of(inputs.fields.states, &Field::tunable);
  }

  bool go_on() override {
    if (!Base::go_on()) return false;
    const bool continues = agent_.go_on();
    this->is_over_ = this->is_over_ || agent_.wants_reset();
    return continues;
  }
  bool ends_early() const override {
    return Base::ends_early() || (this->has_begun() && agent_.leaves_something());
  }
  EpisodeKey key(EpisodeKey planned) override { return agent_.key(planned); }
  void reset(std::uint32_t episode) override {
    Base::reset(episode);
    agent_.reset(episode);
  }
  void step(Seq step, bool has_ended, const OutcomeView& outcome) override {
    has_ended = Base::count(step, has_ended, outcome);
    agent_.step(step, has_ended, step == this->plan_.steps, outcome);
    Base::pace(step, has_ended);
  }
  const void* given_action(Seq /*step*/) override { return agent_.action(); }
  ObservationRow external_observation() override { return agent_.observation(); }
  void applied(const void* action) override { agent_.applied(action); }

 private:
  bool set_states(EpisodeKey key, StateRow states) override {
    const bool changed = Base::set_states(key, states);
    return agent_.apply_states(states) || changed;
  }
  bool set_parameters(Seq step, StateRow states) override {
    const bool changed = Base::set_parameters(step, states);
    return agent_.apply_parameters(states) || changed;
  }
  std::uint64_t lateness() const override {
    return std::max(Base::lateness(), agent_.late_in_a_row());
  }

  ExternalAgent& agent_;
};

}  // namespace eagerx::linux_sim
