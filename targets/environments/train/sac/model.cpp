#include "targets/environments/train/sac/model.hpp"

#include <algorithm>

namespace eagerx::train::sac {

/// Before anything is learned, temporal-difference errors have the variance σ² = V[R] + V[Γ] E[G²]
/// (Schaul et al. 2021, arXiv:2105.05347). If errors were independent, the returns would have some
/// N = 1 / (1 - γ) times that. Where they have more, an action matters little next to them, and
/// needs critics that are as much finer: Adam's step has the size of the learning rate, whatever
/// the returns are. Not more than kMost times, because larger returns are learned later.
double Model::estimated_scale() const {
  constexpr double kMost = 10.0;  // deviations of the returns
  const double of_returns = returns.scale(0);
  if (settings_.reward_scale > 0.0F) return of_returns * double{settings_.reward_scale};
  if (returns.count == 0.0 || rewards.count == 0.0) return of_returns;
  const auto variance = [](const Statistics& seen, std::size_t i) {
    return seen.squares[i] / seen.count;
  };
  const double size = variance(returns, 0) + returns.mean[0] * returns.mean[0];
  const double error = variance(rewards, 0) + gamma_ * gamma_ * variance(rewards, 1) * size;
  const double finer = variance(returns, 0) * (1.0 - gamma_);  // over error
  return of_returns * (finer < kMost * error ? std::max(finer / error, 1.0) : kMost);
}

Network deployed(const train::Settings& settings, const Model& model) {
  return {model.actor.inputs(), settings.net_arch, model.actor.outputs() / 2,
          settings.activation_fn};
}

std::vector<float> deployed_parameters(const Network& network, const Model& model) {
  std::vector<float> parameters(network.parameters());
  const Network::Layer& last = network.layers().back();
  const Network::Layer& all = model.actor.layers().back();
  // Layers before the last are the same, and of that the means are the first rows.
  const auto first = model.averaged.begin();
  std::copy_n(first, last.bias, parameters.begin());
  std::copy_n(first + static_cast<std::ptrdiff_t>(all.bias), network.outputs(),
              parameters.begin() + static_cast<std::ptrdiff_t>(last.bias));
  return folded(network, std::move(parameters), model.observations);
}

}  // namespace eagerx::train::sac
