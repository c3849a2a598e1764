// The state that a training continues from.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/curriculum.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/model.hpp"
#include "targets/environments/train/sac/model.hpp"

namespace eagerx::train {

/// How good a policy was in some episodes.
struct Score {
  double success = 0.0;  // share of the episodes
  double mean_return = 0.0;

  bool is_better_than(const Score& other) const {
    return success != other.success ? success > other.success : mean_return > other.mean_return;
  }
};

/// The best policy so far.
struct Best {
  std::vector<float> parameters;  // folded; empty: none was evaluated
  Score seen;                     // of the evaluation that each policy has
  /// Of that and those that only what seems good has; a return that is not a number: it has none.
  Score confirmed{0, std::numeric_limits<double>::quiet_NaN()};

  bool is_confirmed() const { return !std::isnan(confirmed.mean_return); }
};

/// Episodes that the mean return of a training is taken of.
inline constexpr std::size_t kRecent = 100;

struct Progressed {
  std::uint32_t iteration = 0;
  bool succeeded = false;  // and so ended
  Curriculum curriculum;
  std::vector<CurvePoint> curve;
  std::vector<Episode> recent;  // the last ones that ended, at most kRecent
  Best best;
  std::vector<float> actions;  // in this era so far; empty: it begins, or all has succeeded
};

/// The facts that must be the same when a training continues, as text: "graph 0x…; seed 1; layers
/// 64,64; …".
std::string conditions(const Settings& settings, const std::string& contract_hash);

/// The facts that must be the same when another training begins from this one, as text:
/// "observations angle[2], actions voltage[1], layers 64,64".
std::string interface_of(const Settings& settings, const Description& description);

/// The critic's inputs other than the observations, for both: "; critic mass[1]". Empty: none.
std::string critic_of(const Description& description);

std::string checkpoint_of(const std::string& conditions, const std::string& interface,
                          const Model& model, const Progressed& progressed);
std::string checkpoint_of(const std::string& conditions, const std::string& interface,
                          const sac::Model& model, const Progressed& progressed);

/// Find errors of restore() and begin_from() that can be found without a library, before it is
/// built.
void check_resumed(const std::string& bytes, const std::string& name, const Settings& settings);
void check_begun_from(const std::string& bytes, const std::string& name, const Settings& settings);

/// Fills model and progress. `name` is the file's, for messages. Throws Problem if `bytes` are no
/// checkpoint, are damaged, or belong to another training.
void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
             Model& model, Progressed& progressed);
void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
             sac::Model& model, Progressed& progressed);

/// Fills `model` with the parameters of another training: actor, critic, deviation of the actions
/// and statistics. Adam and its step size start from their initial state. Throws Problem like
/// restore(), and if the networks have a different interface.
void begin_from(const std::string& bytes, const std::string& name, const std::string& interface,
                Model& model);
void begin_from(const std::string& bytes, const std::string& name, const std::string& interface,
                sac::Model& model);

}  // namespace eagerx::train
