// Watches a run that clients can change.
#pragma once

#include <targets/linux-sim/publish/publish_watch.hpp>
#include <targets/linux-sim/publish/remote.hpp>

namespace eagerx::linux_sim {

/// Handles their requests between two steps. A paused run waits there, and before the first step of
/// an episode; nothing else waits.
class RemoteWatch : public PublishWatch {
 public:
  RemoteWatch(GraphProgram& program, const RunInputs& inputs, host::TextFile& csv,
              host::TextFile& trace, Publishing& publishing, Remote& remote);

  bool go_on() override;
  bool begin_episode(EpisodeKey key, StateRow states) override;
  bool tune(std::uint32_t episode, Seq step, StateRow states) override;
  void reset(std::uint32_t episode) override;
  void step(Seq step, bool has_ended, const OutcomeView& outcome) override {
    pace(step, count(step, has_ended, outcome));
  }
  void given(Seq step, void* action) override;

 protected:
  bool set_states(EpisodeKey key, StateRow states) override;
  bool set_parameters(Seq step, StateRow states) override;
  void pace(Seq step, bool has_ended);

 private:
  /// One number for each element, if there are any.
  struct Values {
    std::vector<double> numbers;  // [elements]
    bool are_set = false;
    bool are_new = false;  // parameters that are set before the next step
  };

  void take_requests();
  void serve(const Remote::Request& request);
  void stand_still();
  bool waits() const { return is_paused_ && in_episode_ && to_go_ == 0 && !is_over_; }
  void finish_service();

  Remote& remote_;
  const Fields& fields_;
  std::vector<Values> states_, actions_;
  const bool had_faults_;
  bool is_paused_ = false;
  bool in_episode_ = false;
  bool is_reset_wanted_ = false;
  std::uint32_t to_go_ = 0;   // steps, of those that were asked for
  std::uint64_t served_ = 0;  // number of the latest service that was taken
};

}  // namespace eagerx::linux_sim
