// Numbers among an actor's tensors that are no layers: statistics of observations, bounds of
// actions.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generator/policy/formats/actor/parts.hpp"

namespace eagerx::gen {
namespace {

constexpr double kNoClip = std::numeric_limits<double>::max();

/// How a library names and uses its statistics.
struct KnownStatistics {
  const char* mean;
  const char* spread;    // variance, or deviation
  bool is_deviation;     // (x - mean) / (deviation + epsilon)
  bool epsilon_in_root;  // (x - mean) / sqrt(variance + epsilon); else / (sqrt(variance) + epsilon)
  double epsilon, clip;
};

constexpr std::array kKnownStatistics = {
    KnownStatistics{"obs_normalizer.mean", "obs_normalizer.var", false, true, 1e-8, 10.0},
    KnownStatistics{"obs_normalizer.running_mean_std.running_mean_std.obs.running_mean",
                    "obs_normalizer.running_mean_std.running_mean_std.obs.running_var", false, true,
                    1e-5, 5.0},
    KnownStatistics{"obs_rms.mean", "obs_rms.var", false, true, 1e-8, 10.0},
    KnownStatistics{"running_mean_std.running_mean", "running_mean_std.running_var", false, true,
                    1e-5, 5.0},
    KnownStatistics{"actor_obs_normalizer._mean", "actor_obs_normalizer._std", true, false, 1e-2,
                    kNoClip},
    KnownStatistics{"obs_normalizer._mean", "obs_normalizer._std", true, false, 1e-2, kNoClip},
    KnownStatistics{"obs_norm_state_dict._mean", "obs_norm_state_dict._std", true, false, 1e-2,
                    kNoClip},
    KnownStatistics{"observation_preprocessor.running_mean",
                    "observation_preprocessor.running_variance", false, false, 1e-8, 5.0},
    // In skrl 2 that of the critic, if there are both.
    KnownStatistics{"state_preprocessor.running_mean", "state_preprocessor.running_variance", false,
                    false, 1e-8, 5.0},
};

/// As many numbers as the network has inputs, whatever axes of one there are.
std::optional<std::vector<double>> one_for_each_input(const ActorParts& parts, const char* name) {
  const StoredTensor& tensor = *parts.table.find(name);
  const std::int64_t inputs = parts.network.inputs();
  if (element_count(tensor.shape) != inputs || tensor.shape.empty() ||
      tensor.shape.back() != inputs) {
    return refuse(
        parts.problem, "E0627",
        fmt::format("has statistics of shape {} for {} inputs", show(tensor.shape), inputs),
        kOtherActor);
  }
  return finite_values_of(name, tensor, parts.problem);
}

bool add_known(const ActorParts& parts, const KnownStatistics& known) {
  if (parts.table.find(known.mean) == nullptr || parts.table.find(known.spread) == nullptr) {
    return parts.fail("E0627",
                      fmt::format("has only one of `{}` and `{}`", known.mean, known.spread));
  }
  auto mean = one_for_each_input(parts, known.mean);
  auto spread = mean ? one_for_each_input(parts, known.spread) : std::nullopt;
  if (!spread) return false;
  Normalization statistics;
  statistics.mean = std::move(*mean);
  statistics.clip = parts.facts.clip.value_or(known.clip);
  statistics.epsilon = parts.facts.epsilon.value_or(known.epsilon);
  for (double& value : *spread) {
    if (known.epsilon_in_root || value < 0.0) continue;
    const double deviation = (known.is_deviation ? value : std::sqrt(value)) + statistics.epsilon;
    value = deviation * deviation;
  }
  if (!known.epsilon_in_root) statistics.epsilon = 0.0;
  statistics.variance = std::move(*spread);
  if (!check_statistics(statistics, parts.problem)) return false;
  parts.network.normalization = std::move(statistics);
  const std::string mean_name = known.mean;
  const std::string prefix = mean_name.substr(0, mean_name.rfind('.') + 1);
  for (const auto& [name, tensor] : parts.table.tensors) {
    if (name.starts_with(prefix)) parts.used.insert(name);
  }
  for (const char* name : {"clip_obs", "epsilon", "low", "high", "rate", "squash"}) {
    parts.used.insert(name);
  }
  return true;
}

}  // namespace

bool add_statistics(const ActorParts& parts) {
  for (const KnownStatistics& known : kKnownStatistics) {
    if (parts.table.find(known.mean) == nullptr && parts.table.find(known.spread) == nullptr) {
      continue;
    }
    return add_known(parts, known);
  }
  return true;
}

bool add_scaled_bounds(const ActorParts& parts) {
  const StoredTensor* scale = parts.table.find("action_scale");
  const StoredTensor* bias = parts.table.find("action_bias");
  if (scale == nullptr || bias == nullptr) return true;
  auto scales = finite_values_of("action_scale", *scale, parts.problem);
  auto centres = scales ? finite_values_of("action_bias", *bias, parts.problem) : std::nullopt;
  if (!centres) return false;
  if (scales->size() != centres->size() ||
      (scales->size() != 1 && scales->size() != parts.network.outputs())) {
    return parts.fail("E0626",
                      fmt::format("has `action_scale` of {} and `action_bias` of {} numbers for {} "
                                  "actions",
                                  scales->size(), centres->size(), parts.network.outputs()));
  }
  if (std::any_of(scales->begin(), scales->end(), [](double value) { return value < 0; })) {
    return parts.fail("E0626", "has an `action_scale` below zero");
  }
  PolicyContract& contract = parts.network.contract;
  contract.action_low.clear();
  contract.action_high.clear();
  for (std::size_t i = 0; i < scales->size(); ++i) {
    contract.action_low.push_back((*centres)[i] - (*scales)[i]);
    contract.action_high.push_back((*centres)[i] + (*scales)[i]);
  }
  parts.used.insert("action_scale");
  parts.used.insert("action_bias");
  return true;
}

bool check_statistics(Normalization& statistics, PolicyProblem& problem) {
  const auto fail = [&](const char* how) {
    return refuse(problem, "E0627", fmt::format("has statistics {}", how), kOtherActor);
  };
  if (statistics.mean.empty() || statistics.mean.size() != statistics.variance.size()) {
    return fail("with different numbers of means and variances");
  }
  for (std::size_t i = 0; i < statistics.mean.size(); ++i) {
    if (!std::isfinite(statistics.mean[i]) || !std::isfinite(statistics.variance[i])) {
      return fail("with NaN or infinity");
    }
    const double sum = statistics.variance[i] + statistics.epsilon;
    if (statistics.variance[i] < 0.0 || !(sum > 0.0)) return fail("with a variance below zero");
  }
  if (!(statistics.epsilon >= 0.0)) return fail("whose epsilon is below zero");
  if (!(statistics.clip > 0.0)) return fail("whose clip is not above zero");
  statistics.clip = std::min(statistics.clip, std::numeric_limits<double>::max());
  return true;
}

}  // namespace eagerx::gen
