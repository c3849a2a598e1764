// Where the environments of PPO begin anew, and how they get there again.
#include <algorithm>
#include <utility>

#include "targets/environments/train/ppo.hpp"

namespace eagerx::train {

void Ppo::begin_era() {
  for (std::size_t part = 0; part < kParts; ++part) {
    if (pace.begins(part)) parts_[part]->taken.clear();
  }
  in_parts([&](std::size_t part) {
    if (pace.begins(part)) reset(part);
  });
  if (model_.observations.count > 0.0 || !settings_.normalise) return;
  for (auto& part : parts_) model_.observations.add(part->observation_sums);
}

void Ppo::reset(std::size_t part) {
  rollout(part).reset(settings_.seed + (std::uint64_t{pace.eras[part].number} << 32U));
}

void Ppo::remember_actions() {
  remembers_ = true;
  for (std::size_t part = own_.first; part < own_.end; ++part) rollout(part).remembers = true;
}

std::size_t Ppo::actions_of(std::size_t part) const {
  return pace.eras[part].since * settings_.environments * head_.numbers / kParts;
}

std::vector<float> Ppo::actions() const {
  std::vector<float> actions;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::vector<float>& taken = parts_[part]->taken;
    const std::size_t count = std::min(actions_of(part), taken.size());
    actions.insert(actions.end(), taken.begin(),
                   taken.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return actions;
}

void Ppo::take_up(const std::vector<float>& actions) {
  std::size_t count = 0;
  for (std::size_t part = 0; part < kParts; ++part) count += actions_of(part);
  if (actions.size() != count) return;
  auto first = actions.begin();
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto end = first + static_cast<std::ptrdiff_t>(actions_of(part));
    parts_[part]->taken.assign(first, end);
    first = end;
  }
}

void Ppo::go_on() {
  std::vector<std::vector<float>> taken;
  for (auto& part : parts_) taken.push_back(std::exchange(part->taken, {}));
  in_parts([&](std::size_t part) { reset(part); });
  for (std::size_t part = 0; part < kParts && remembers_; ++part) parts_[part]->taken = taken[part];
  in_parts([&](std::size_t part) {
    rollout(part).replay(taken[part], settings_.discount);
    const std::size_t states = model_.remembered.size() / kParts;
    if (!taken[part].empty()) rollout(part).recall(model_.remembered.data() + part * states);
  });
}

}  // namespace eagerx::train
