// Watches a run whose agent is another process.
#pragma once

#include <algorithm>
#include <targets/linux-sim/dds/remote_agent.hpp>
#include <targets/linux-sim/run_watch.hpp>

namespace eagerx::linux_sim {

/// `Base`: RunWatch, or a class derived from it.
template <class Base>
class AgentWatch final : public Base {
 public:
  template <class... Arguments>
  explicit AgentWatch(RemoteAgent& agent, Arguments&... arguments)
      : Base(arguments...), agent_(agent) {}

  bool go_on() override { return Base::go_on() && !agent_.failed(); }
  bool ends_early() const override {
    return Base::ends_early() || (this->has_begun() && agent_.failed());
  }
  void reset(std::uint32_t episode) override {
    agent_.begin(episode);
    Base::reset(episode);
  }
  const void* given_action(Seq step) override {
    return agent_.act(step, this->observations(), this->pacer().in_time_until_ns());
  }

 private:
  /// A step whose action did not come in time is a late one.
  std::uint64_t lateness() const override {
    return std::max(Base::lateness(), agent_.missed_in_a_row());
  }

  RemoteAgent& agent_;
};

}  // namespace eagerx::linux_sim
