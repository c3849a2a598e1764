// Watches a run that is published.
#pragma once

#include <targets/linux-sim/publish/publishing.hpp>
#include <targets/linux-sim/run_watch.hpp>

namespace eagerx::linux_sim {

/// Tells others where steps end, too.
class PublishWatch : public RunWatch {
 public:
  PublishWatch(GraphProgram& program, const RunInputs& inputs, host::TextFile& csv,
               host::TextFile& trace, Publishing& publishing)
      : RunWatch(program, inputs, csv, trace), publishing_(publishing) {}

  void reset(std::uint32_t episode) override {
    episode_ = episode;
    publishing_.step(episode, 0);
    RunWatch::reset(episode);
  }
  void step(Seq step, bool has_ended, const OutcomeView& outcome) override {
    pace(step, count(step, has_ended, outcome));
  }

 protected:
  bool count(Seq step, bool has_ended, const OutcomeView& outcome) {
    publishing_.step(episode_, step);
    return RunWatch::count(step, has_ended, outcome);
  }

 private:
  Publishing& publishing_;
  std::uint32_t episode_ = 0;
};

}  // namespace eagerx::linux_sim
