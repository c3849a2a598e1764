// Parts of an actor besides dense layers: the image in front of it, batch norms, quantiles,
// statistics that lie among its tensors. Inside formats/actor only.
#pragma once

#include <set>
#include <string>

#include "generator/policy/formats/actor/actor.hpp"

namespace eagerx::gen {

/// The source and the target of parts.
struct ActorParts {
  const TensorTable& table;
  const PolicyFacts& facts;
  Network& network;
  std::set<std::string>& used;  // names of tensors
  PolicyProblem& problem;

  Refused fail(const char* code, std::string message, std::string help = kOtherActor) const {
    return refuse(problem, code, std::move(message), std::move(help));
  }
};

/// Adds the layers of the actor's modules, each followed by `activation` if the layout says so.
/// E0618, E0619, E0624, E0628.
bool add_modules(const ActorParts& parts, const ActorLayout& layout, Activation activation);

/// Adds the activation after the last layer (that of the file, else of its library, else of the
/// graph), and the form of its answers. E0624, E0626, E0750 and those of `average_quantiles`.
bool finish_output(const ActorParts& parts, const ActorLayout& layout, const ReadContext& context);

/// Checks unread parts, which may be between observation and action: E0628 unless they are for
/// training only. The rest is listed.
bool check_rest(const ActorParts& parts, const ActorLayout& layout);

/// Stable-Baselines3's NatureCNN whose tensors start with `prefix`, in front of everything else:
/// kernels of 8, 4 and 3 with strides of 4, 2 and 1, then a dense layer, each with relu. E0618,
/// E0619, E0628.
bool add_nature_cnn(const ActorParts& parts, const std::string& prefix);

/// Adds SB3's one-hot encoding of Discrete and MultiDiscrete observations: whole numbers become 1
/// at the chosen index and 0 elsewhere. E0619.
bool add_one_hot(const ActorParts& parts);

/// Whether `base` is a BatchNorm1d of torch, or sb3-contrib's BatchRenorm1d.
bool is_batch_norm(const TensorTable& table, const std::string& base);

/// scale (x - mean) / sqrt(variance + epsilon) + bias of the training, each its own step. E0618.
bool add_batch_norm(const ActorParts& parts, const std::string& base);

/// QR-DQN: the last layer gives quantiles [quantile][action]; their mean is taken of its weights.
/// E0626, E0628.
bool average_quantiles(const ActorParts& parts);

/// -limit <= x <= limit.
void add_limits(Network& network, float limit);

/// Statistics under the names of SB3, rl_games, rsl_rl and skrl. E0627.
bool add_statistics(const ActorParts& parts);

/// CleanRL's `action_scale` and `action_bias`, as bounds. E0626.
bool add_scaled_bounds(const ActorParts& parts);

}  // namespace eagerx::gen
