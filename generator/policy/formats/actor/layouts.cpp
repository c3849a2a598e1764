// Names of an actor's parts in each library.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "generator/policy/formats/actor/known_layouts.hpp"
#include "generator/policy/formats/actor/parts.hpp"
#include "generator/policy/formats/common/foreign.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kWeight = ".weight";
constexpr std::string_view kMean = ".running_mean";  // of a batch norm, which may have no weight
constexpr std::string_view kRenormMean = ".ra_mean";
constexpr std::int64_t kWidestGap = 3;  // Linear, activation, Dropout, Linear

/// Parameters of one torch Sequential, by position.
using Sequence = std::map<std::int64_t, std::string>;
/// By what stands before the position: "actor.latent_pi.", "fc".
using Sequences = std::map<std::string, Sequence, std::less<>>;

Sequences find_sequences(const TensorTable& table) {
  constexpr std::size_t kMostDigits = 4;
  Sequences sequences;
  for (const auto& [name, tensor] : table.tensors) {
    std::optional<std::string> base_of_name;
    for (const std::string_view end : {kWeight, kMean, kRenormMean}) {
      if (name.ends_with(end)) base_of_name = name.substr(0, name.size() - end.size());
    }
    if (!base_of_name) continue;
    const std::string& base = *base_of_name;
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
  Layouts(const TensorTable& table, bool is_zip, PolicyProblem& problem)
      : table_(table), is_zip_(is_zip), problem_(problem), sequences_(find_sequences(table)) {}

  std::optional<ActorLayout> find() {
    if (!check_supported()) return std::nullopt;
    std::vector<ActorLayout> found;
    for (const KnownLayout& known : kKnownLayouts) {
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
  bool any_starts_with(std::string_view start) const {
    const auto next = table_.tensors.lower_bound(start);
    return next != table_.tensors.end() && std::string_view(next->first).starts_with(start);
  }
  bool matches(const KnownLayout& known) const {
    const bool is_alone = table_.tensors.size() == 1 && table_.find("action_net.weight") != nullptr;
    if (known.is_alone != is_alone) return false;
    if (known.must_not_have != nullptr && any_starts_with(known.must_not_have)) return false;
    return std::any_of(known.must_have.begin(), known.must_have.end(),
                       [&](const char* name) { return name != nullptr && any_starts_with(name); });
  }
  /// Whether the file is of this library, and does not only have names like its.
  bool is_certain(const KnownLayout& known) const {
    const auto is_there = [&](const char* mark) {
      if (mark == nullptr) return false;
      const std::string_view name = mark;
      return name.ends_with('.') ? any_starts_with(name) : table_.find(name) != nullptr;
    };
    return is_zip_ || known.marks.front() == nullptr || ranges::any_of(known.marks, is_there);
  }

  /// Refuses layouts of libraries that are not supported, by their names.
  bool check_supported() {
    constexpr const char* kExport = "export the actor to ONNX, which says every step";
    const auto fail = [&](const char* how) { return refuse(problem_, "E0628", how, kExport); };
    if (any_starts_with("a2c_network.logits.0.")) {
      return fail("is of rl_games and makes several choices at once (MultiDiscrete)");
    }
    if (any_starts_with("action_parameterization.") && any_starts_with("obs_normalizer.") &&
        any_starts_with("encoder.encoders.obs.") &&
        !any_starts_with("encoder.encoders.obs.mlp_head.")) {
      return fail("is of Sample Factory, with an encoder that is not an MLP");
    }
    if (!any_starts_with("action_parameterization.distribution_linear.")) return true;
    if (!any_starts_with("action_parameterization.learned_stddev")) {
      return fail(
          "is of Sample Factory, and does not say whether its outputs are scores of choices, or "
          "means with deviations (`adaptive_stddev`)");
    }
    const bool remembers = any_starts_with("core.") || any_starts_with("actor_core.");
    const bool decodes = any_starts_with("decoder.") || any_starts_with("actor_decoder.");
    return !remembers || !decodes || fail("is of Sample Factory, with a memory and a decoder");
  }

  Refused ambiguous(std::string_view a, std::string_view b) {
    return refuse(
        problem_, "E0625", fmt::format("has two actors: {} and {}", a, b),
        "say which one by how its tensors' names begin: `agent: {policy: …, actor: NAME}`; "
        "for `policy` with `--actor NAME`");
  }
  /// Names of several beginnings say neither what comes after what, nor what is between them.
  Refused say_order(const std::vector<std::string>& order) {
    std::vector<std::string> names;
    for (const std::string& name : order) names.push_back(printable(name));
    return refuse(
        problem_, "E0629",
        fmt::format("does not say in which order its layers come, nor which activations follow "
                    "them: `{}`",
                    join(names, "`, `")),
        fmt::format("say both in the graph: `agent: {{policy: …, layers: [{0}], activation: relu, "
                    "output_activation: none}}`; for `policy` with `--layers {1} --activation relu "
                    "--output-activation none`",
                    join(names, ", "), join(names, ",")));
  }
  Refused missing(const std::string& what) {
    return refuse(problem_, "E0624",
                  fmt::format("has an actor without tensor `{}`", printable(what)), kOtherActor);
  }

  /// Appends the modules of a sequence; `last_activates`: an activation follows the last one too.
  bool append(std::string_view prefix, bool last_activates, ActorLayout& layout,
              bool is_list = false) {
    const auto found = sequences_.find(prefix);
    if (found == sequences_.end()) return true;
    const Sequence& sequence = found->second;
    const bool dotted = prefix.empty() || prefix.back() == '.';
    std::int64_t before = dotted ? -1 : sequence.begin()->first - 1;
    for (auto it = sequence.begin(); it != sequence.end(); ++it) {
      // A hole wider than activation and dropout is a layer that is not there.
      if (it->first - before > (before < 0 ? 2 : kWidestGap)) {
        return missing(
            fmt::format("{}{}.weight", prefix, dotted && before >= 0 ? before + 2 : before + 1));
      }
      const bool had_gap = before >= 0 && it->first - before > 1;
      before = it->first;
      const auto next = std::next(it);
      const bool last = next == sequence.end();
      const bool gap = !dotted || (!last && (is_list || next->first - it->first > 1));
      if (!gap && !last && is_linear(it->second) && is_linear(next->second)) {
        return nothing_between(it->second, next->second);
      }
      // CrossQ's last batch norm follows an activation, and nothing follows it.
      const bool activates = last_activates && !(had_gap && is_batch_norm(table_, it->second));
      layout.modules.push_back({it->second, last ? activates : gap, {}});
    }
    return true;
  }
  bool is_linear(const std::string& base) const {
    const StoredTensor* weight = table_.find(base + std::string(kWeight));
    return weight != nullptr && weight->shape.size() == 2;
  }
  /// Only the owner of a ModuleList knows what comes between its layers; in a Sequential, no Linear
  /// directly follows another.
  bool nothing_between(const std::string& a, const std::string& b) {
    return refuse(
        problem_, "E0628",
        fmt::format("has nothing between the layers `{}` and `{}`, as a ModuleList, which "
                    "does not say what follows its layers",
                    printable(a), printable(b)),
        "export the actor to ONNX, or save it as a `Sequential` with its activations");
  }

  std::optional<ActorLayout> make(const KnownLayout& known) {
    ActorLayout layout{known};
    if (!is_certain(known)) {
      layout.about = "a torch module";
      layout.activation.reset();
      layout.output = Activation::identity;
      layout.squash = Squash::never;
      layout.memory_place = MemoryPlace::unknown;
      layout.output_rule = OutputRule::unknown;
    }
    for (const char* prefix : known.extractors) {
      if (prefix == nullptr || !layout.extractor.empty()) continue;
      if (any_starts_with(prefix)) layout.extractor = prefix;
    }
    for (const char* body : known.bodies) {
      if (body != nullptr && !append(body, true, layout)) return std::nullopt;
    }
    if (known.head_is_sequence) {
      if (!append(known.head, false, layout, known.is_list)) return std::nullopt;
    } else {
      const std::string head = known.head;
      const std::string weight = head + std::string(kWeight);
      // With gSDE SAC's mean is a Linear and a Hardtanh.
      const bool limited = table_.find(head + ".0.weight") != nullptr;
      if (table_.find(weight) == nullptr && !limited) return missing(weight);
      layout.modules.push_back({limited ? head + ".0" : head, false, {}, limited});
    }
    if (layout.modules.empty()) return missing(std::string(known.head) + "0.weight");
    return layout;
  }

  static ActorLayout unknown(std::string_view about) {
    return {{.about = about, .output_rule = OutputRule::unknown}};
  }

  /// A GRU or LSTM with single Linear layers before or behind it: {"gru.weight_ih_l0",
  /// "head.weight"}.
  std::optional<ActorLayout> around_memory() const {
    constexpr std::string_view kInput = ".weight_ih_l0";
    ActorLayout layout = unknown("a torch module with a memory");
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

  /// Whose names the tensors have, if it is no library of torch.
  std::optional<std::string> other_library() const {
    for (const auto& [name, tensor] : table_.tensors) {
      const std::string_view last = std::string_view(name).substr(name.find_last_of("./") + 1);
      if (last == "kernel" || last == "kernel:0") {
        return fmt::format("names its weights as Flax and Keras do: `{}`", printable(name));
      }
      if (last == "Wx") return fmt::format("has a memory of MLX: `{}`", printable(name));
    }
    return std::nullopt;
  }

  /// A file of nothing but one network.
  std::optional<ActorLayout> only_sequence() {
    if (auto layout = around_memory()) return layout;
    if (sequences_.empty()) {
      if (const auto other = other_library()) return refuse(problem_, "E0624", *other, kJaxWay);
      return refuse(
          problem_, "E0624",
          fmt::format("has no actor among its {} tensors", table_.tensors.size()),
          "known actors are those of Stable-Baselines3 (PPO, A2C, SAC, TD3, DDPG, DQN) and "
          "sb3-contrib (ARS, CrossQ, QR-DQN, RecurrentPPO, TQC, TRPO), rsl_rl, rl_games, "
          "skrl, CleanRL, Sample Factory, safe-control-gym, and one torch `Sequential` alone");
    }
    const std::string critic = sequences_.begin()->first;
    std::erase_if(sequences_, [](const auto& item) { return is_critic(item.first); });
    if (sequences_.empty()) {
      return refuse(problem_, "E0624",
                    fmt::format("holds a critic (`{}…`) and no actor", printable(critic)),
                    "save the tensors of the actor");
    }
    if (const auto order = order_by_sizes(table_); !order.empty()) return say_order(order);
    if (sequences_.size() > 1) {
      const auto second = std::next(sequences_.begin());
      return ambiguous(fmt::format("`{}…`", printable(sequences_.begin()->first)),
                       fmt::format("`{}…`", printable(second->first)));
    }
    ActorLayout layout = unknown("a torch `Sequential`");
    if (!append(sequences_.begin()->first, false, layout)) return std::nullopt;
    return layout;
  }

  const TensorTable& table_;
  bool is_zip_;
  PolicyProblem& problem_;
  Sequences sequences_;
};

}  // namespace

bool is_critic(std::string_view name) {
  const auto has = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  return has("critic") || has("value") || has("qf") || has("vf") || name.starts_with("memory_c");
}

std::optional<ActorLayout> find_actor(const TensorTable& table, bool is_zip,
                                      PolicyProblem& problem) {
  return Layouts(table, is_zip, problem).find();
}

}  // namespace eagerx::gen
