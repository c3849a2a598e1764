#include "targets/environments/train/sac/model.hpp"

#include <algorithm>

namespace eagerx::train::sac {

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
