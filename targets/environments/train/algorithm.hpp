// Interface of a learning algorithm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/train/network.hpp"
#include "targets/environments/train/pace.hpp"
#include "targets/environments/train/spent.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

struct Progressed;

/// An episode that ended during a rollout.
struct Episode {
  double sum = 0.0;           // of its rewards
  std::uint32_t step = 0;     // of the rollout
  std::uint32_t success = 0;  // 1 if it did
};

/// Steps all environments and learns, an iteration at a time.
class Algorithm {
 public:
  /// The data of an iteration.
  struct Result {
    std::vector<Episode> episodes;  // that ended, in order of time
    double divergence = 0.0;        // of the last minibatch
    std::size_t updates = 0;        // that were made
  };

  explicit Algorithm(const Pace& first) : pace(first) {}
  Algorithm(const Algorithm&) = delete;
  Algorithm& operator=(const Algorithm&) = delete;
  virtual ~Algorithm() = default;

  Pace pace;  // where it is

  virtual std::size_t environments() const = 0;
  /// Into which they are cut. A SIMD vector does not go beyond its part.
  virtual std::size_t parts() const { return 1; }
  /// Of all environments so far.
  std::uint64_t steps() const { return pace.time * environments(); }
  /// How environments are stepped, and the reason if that is slow.
  virtual std::string stepping() const = 0;

  /// Sets the stage of the task from the next era on; empty: the graph as written.
  virtual void set_stage(const std::string& name) = 0;
  /// Resets all environments, with episodes that depend on the era and the seed only. A training
  /// that continues from here needs only the learned parameters and the iteration.
  virtual void begin_era() = 0;
  /// From now on actions are remembered, which go_on() needs in the middle of an era.
  virtual void remember_actions() = 0;
  /// All environments are brought to where they were in the checkpoint of restore().
  virtual void go_on() = 0;
  /// A rollout and the updates from it.
  virtual Result iterate() = 0;

  /// The network that is deployed, and its parameters with the normalisation inside.
  virtual Network deployed() const = 0;
  virtual std::vector<float> deployed_parameters() const = 0;
  /// The observed data.
  virtual const Statistics& observations() const = 0;
  /// Of the actions, mean over their numbers; NaN for choices.
  virtual double deviation() const = 0;
  /// Of Adam.
  virtual double step_size() const = 0;
  /// By this process, since it has begun.
  virtual Spent spent() const = 0;
  virtual Done done() const = 0;

  /// The bytes of a checkpoint. See checkpoint.hpp.
  virtual std::string checkpoint(const std::string& conditions, const std::string& interface,
                                 Progressed& progressed) const = 0;
  /// Takes up a checkpoint. Throws Problem.
  virtual void restore(const std::string& bytes, const std::string& name,
                       const std::string& conditions, Progressed& progressed) = 0;
  /// Starts from the parameters of another training. Throws Problem.
  virtual void begin_from(const std::string& bytes, const std::string& name,
                          const std::string& interface) = 0;
  /// Also learns from the table of a run. Returns a message about it. Throws Problem; an algorithm
  /// that learns only from its own steps always does.
  virtual std::string replay(const std::string& text, const std::string& name) = 0;
};

}  // namespace eagerx::train
