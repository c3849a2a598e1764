// Soft actor-critic on a few environments.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/sac/collector.hpp"
#include "targets/environments/train/sac/learner.hpp"
#include "targets/environments/train/sac/model.hpp"

namespace eagerx::train::sac {

class Sac : public Algorithm {
 public:
  /// Throws Problem if the action is a choice.
  Sac(const train::Settings& settings, const Library& library, const Kernels& kernels,
      ThreadPool& pool, std::uint32_t longest);

  const Model& model() const { return model_; }

  std::size_t environments() const override { return settings_.sac.n_envs; }
  std::string stepping() const override { return collector_.stepping(); }
  void set_stage(const std::string& name) override;
  void begin_era() override;
  void remember_actions() override {}  // the memory has them
  void go_on() override;
  Result iterate() override;
  Network deployed() const override { return deployed_; }
  std::vector<float> deployed_parameters() const override;
  const Statistics& observations() const override { return model_.observations; }
  double deviation() const override { return deviation_; }
  double step_size() const override { return settings_.learning_rate * settings_.decay(steps()); }
  Spent spent() const override;
  Done done() const override { return done_; }
  std::string checkpoint(const std::string& conditions, const std::string& interface,
                         Progressed& progressed) const override;
  void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
               Progressed& progressed) override;
  void begin_from(const std::string& bytes, const std::string& name,
                  const std::string& interface) override;
  std::string replay(const std::string& text, const std::string& name) override;

 private:
  void update(const Normaliser& normaliser);
  void average();
  void see();

  const train::Settings settings_;
  const Description& description_;
  Model model_;
  const std::string critic_;  // what only the critics see, in words, for checkpoints
  const Network deployed_;
  const Kernels& kernels_;
  ThreadPool& pool_;
  Collector collector_;
  std::vector<std::unique_ptr<Learner>> learners_;  // [kParts]
  double deviation_ = 0.0;
  std::vector<double> learning_s_ = std::vector<double>(kParts);  // of processor time
  double updating_s_ = 0.0;                                       // the same, by the caller alone
  Done done_;
};

}  // namespace eagerx::train::sac
