// How libraries name the parts of an actor.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>

#include "generator/policy/actor.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kWeight = ".weight";
constexpr std::int64_t kWidestGap = 3;  // Linear, activation, Dropout, Linear

/// Parameters of one torch Sequential, by position.
using Sequence = std::map<std::int64_t, std::string>;
/// By what stands before the position: "actor.latent_pi.", "fc".
using Sequences = std::map<std::string, Sequence, std::less<>>;

Sequences find_sequences(const TensorTable& table) {
  constexpr std::size_t kMostDigits = 4;
  Sequences sequences;
  for (const auto& [name, tensor] : table.tensors) {
    if (!name.ends_with(kWeight)) continue;
    const std::string base = name.substr(0, name.size() - kWeight.size());
    const std::size_t letters = base.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
    const std::size_t digits = base.size() - letters;
    if (digits == 0 || digits > kMostDigits) continue;
    std::int64_t position = 0;
    std::from_chars(base.data() + letters, base.data() + base.size(), position);
    sequences[base.substr(0, letters)][position] = base;
  }
  return sequences;
}

class Layouts {
 public:
  Layouts(const TensorTable& table, PolicyProblem& problem)
      : table_(table), problem_(problem), sequences_(find_sequences(table)) {}

  std::optional<ActorLayout> find() {
    std::vector<ActorLayout> found;
    for (const Known& known : kKnown) {
      if (!matches(known)) continue;
      auto layout = make(known);
      if (!layout) return std::nullopt;
      found.push_back(std::move(*layout));
    }
    if (found.size() > 1) return ambiguous(found[0].about, found[1].about);
    if (found.size() == 1) return found.front();
    return only_sequence();
  }

 private:
  /// `bodies` are followed by an activation each, then comes `head`: a layer or a sequence.
  struct Known {
    const char* about;
    const char* algorithms;
    std::array<const char*, 2> bodies;
    const char* head;
    bool head_is_sequence;
    const char* must_have;  // a name that starts like this; tells layouts apart
    const char* must_not_have;
    ActionKind action;
    std::optional<Activation> activation;
    Activation output;
    bool has_bias;
    const char* memory;  // a GRU or LSTM before the bodies
  };
  static constexpr std::array kKnown = {
      Known{"Stable-Baselines3's SAC",
            "SAC TQC",
            {"actor.latent_pi."},
            "actor.mu",
            false,
            "actor.latent_pi.",
            nullptr,
            ActionKind::squashed,
            Activation::relu,
            Activation::tanh,
            true,
            ""},
      Known{"Stable-Baselines3's TD3",
            "TD3 DDPG",
            {},
            "actor.mu.",
            true,
            "actor.mu.0.",
            "actor.latent_pi.",
            ActionKind::squashed,
            Activation::relu,
            Activation::tanh,
            true,
            ""},
      Known{"Stable-Baselines3's RecurrentPPO",
            "RecurrentPPO",
            {"mlp_extractor.policy_net."},
            "action_net",
            false,
            "lstm_actor.",
            nullptr,
            ActionKind::raw,
            Activation::tanh,
            Activation::identity,
            true,
            "lstm_actor"},
      Known{"Stable-Baselines3's PPO or A2C",
            "PPO A2C TRPO",
            {"mlp_extractor.shared_net.", "mlp_extractor.policy_net."},
            "action_net",
            false,
            "action_net.",
            "lstm_actor.",
            ActionKind::raw,
            Activation::tanh,
            Activation::identity,
            true,
            ""},
      Known{"Stable-Baselines3's DQN",
            "DQN",
            {},
            "q_net.q_net.",
            true,
            "q_net.q_net.",
            nullptr,
            ActionKind::argmax,
            Activation::relu,
            Activation::identity,
            true,
            ""},
      Known{"rl_games",
            "",
            {"a2c_network.actor_mlp."},
            "a2c_network.mu",
            false,
            "a2c_network.actor_mlp.",
            nullptr,
            ActionKind::raw,
            std::nullopt,
            Activation::identity,
            false,
            ""},
      Known{"rsl_rl",
            "",
            {},
            "actor.",
            true,
            "actor.0.",
            nullptr,
            ActionKind::raw,
            std::nullopt,
            Activation::identity,
            false,
            ""},
      Known{"CleanRL's PPO",
            "",
            {},
            "actor_mean.",
            true,
            "actor_mean.0.",
            nullptr,
            ActionKind::raw,
            std::nullopt,
            Activation::identity,
            false,
            ""},
  };

  bool any_starts_with(std::string_view start) const {
    const auto next = table_.tensors.lower_bound(start);
    return next != table_.tensors.end() && std::string_view(next->first).starts_with(start);
  }
  bool matches(const Known& known) const {
    if (known.must_not_have != nullptr && any_starts_with(known.must_not_have)) return false;
    return any_starts_with(known.must_have);
  }

  std::nullopt_t ambiguous(const std::string& a, const std::string& b) {
    return refuse(problem_, "E0625", fmt::format("has two actors: {} and {}", a, b),
                  "save a file with the tensors of one of them");
  }
  std::nullopt_t missing(const std::string& what) {
    return refuse(problem_, "E0624",
                  fmt::format("has an actor without tensor `{}`", printable(what)),
                  "the file is damaged: save it again");
  }

  /// Appends the modules of a sequence; `last_activates`: an activation follows the last one too.
  bool append(std::string_view prefix, bool last_activates, ActorLayout& layout) {
    const auto found = sequences_.find(prefix);
    if (found == sequences_.end()) return true;
    const Sequence& sequence = found->second;
    const bool dotted = prefix.empty() || prefix.back() == '.';
    std::int64_t before = dotted ? -1 : sequence.begin()->first - 1;
    for (auto it = sequence.begin(); it != sequence.end(); ++it) {
      // A hole wider than activation and dropout is a layer that is not there.
      if (it->first - before > (before < 0 ? 2 : kWidestGap)) {
        missing(
            fmt::format("{}{}.weight", prefix, dotted && before >= 0 ? before + 2 : before + 1));
        return false;
      }
      before = it->first;
      const auto next = std::next(it);
      const bool last = next == sequence.end();
      const bool gap = !dotted || (!last && next->first - it->first > 1);
      layout.modules.push_back({it->second, last ? last_activates : gap, {}});
    }
    return true;
  }

  std::optional<ActorLayout> make(const Known& known) {
    ActorLayout layout{known.about,  known.algorithms, {},          known.action, known.activation,
                       known.output, known.has_bias,   known.memory};
    for (const char* body : known.bodies) {
      if (body != nullptr && !append(body, true, layout)) return std::nullopt;
    }
    if (known.head_is_sequence) {
      if (!append(known.head, false, layout)) return std::nullopt;
    } else {
      const std::string weight = std::string(known.head) + std::string(kWeight);
      if (table_.find(weight) == nullptr) return missing(weight);
      layout.modules.push_back({known.head, false, {}});
    }
    if (layout.modules.empty()) return missing(std::string(known.head) + "0.weight");
    return layout;
  }

  /// A GRU or LSTM with single Linear layers before or behind it: {"gru.weight_ih_l0",
  /// "head.weight"}.
  std::optional<ActorLayout> around_memory() const {
    constexpr std::string_view kInput = ".weight_ih_l0";
    ActorLayout layout;
    layout.about = "a torch module with a memory";
    const StoredTensor* memory = nullptr;
    for (const auto& [name, tensor] : table_.tensors) {
      if (name.ends_with(kInput)) memory = memory == nullptr ? &tensor : nullptr;
      if (!name.ends_with(kWeight) || tensor.shape.size() != 2) continue;
      layout.modules.push_back({name.substr(0, name.size() - kWeight.size()), false, {}});
    }
    if (!sequences_.empty() || memory == nullptr || memory->shape.size() != 2) return std::nullopt;
    if (layout.modules.empty() || layout.modules.size() > 2) return std::nullopt;
    const auto gives = [&](const ActorModule& module) {
      return table_.find(module.base + ".weight")->shape[0];
    };
    if (layout.modules.size() == 2) {
      // The one before the memory gives what it takes, and is followed by an activation.
      if (gives(layout.modules[0]) != memory->shape[1])
        std::swap(layout.modules[0], layout.modules[1]);
      layout.modules[0].activation_after = true;
    }
    return layout;
  }

  /// A file of nothing but one network.
  std::optional<ActorLayout> only_sequence() {
    if (auto layout = around_memory()) return layout;
    if (sequences_.empty()) {
      return refuse(problem_, "E0624",
                    fmt::format("has no actor among its {} tensors", table_.tensors.size()),
                    "known are those of Stable-Baselines3 (PPO, A2C, SAC, TD3, DDPG, DQN), rsl_rl, "
                    "rl_games, CleanRL, and one torch `Sequential` alone");
    }
    if (sequences_.size() > 1) {
      const auto second = std::next(sequences_.begin());
      return ambiguous(fmt::format("`{}…`", printable(sequences_.begin()->first)),
                       fmt::format("`{}…`", printable(second->first)));
    }
    ActorLayout layout;
    layout.about = "a torch `Sequential`";
    if (!append(sequences_.begin()->first, false, layout)) return std::nullopt;
    return layout;
  }

  const TensorTable& table_;
  PolicyProblem& problem_;
  Sequences sequences_;
};

}  // namespace

std::optional<ActorLayout> find_actor(const TensorTable& table, PolicyProblem& problem) {
  return Layouts(table, problem).find();
}

}  // namespace eagerx::gen
