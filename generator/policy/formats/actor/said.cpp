// Orders layers whose names do not give an order: as the graph says, or by their sizes.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/policy/formats/actor/parts.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kWeightEnd = ".weight";

const StoredTensor* weight_of(const TensorTable& table, const std::string& base) {
  return table.find(base + std::string(kWeightEnd));
}

bool is_linear(const TensorTable& table, const std::string& base) {
  const StoredTensor* weight = weight_of(table, base);
  return weight != nullptr && weight->shape.size() == 2;
}

/// Names of its layers, without those of a critic or of the training.
std::vector<std::string> layers_of(const TensorTable& table) {
  std::vector<std::string> result;
  for (const auto& [name, tensor] : table.tensors) {
    if (!name.ends_with(kWeightEnd) || is_critic(name) || is_for_training(name)) continue;
    result.push_back(name.substr(0, name.size() - kWeightEnd.size()));
  }
  return result;
}

/// "net.10" as "net." and 10.
std::pair<std::string, std::int64_t> position_of(const std::string& base) {
  constexpr std::size_t kMostDigits = 4;
  const std::size_t letters = base.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
  std::int64_t position = -1;
  if (letters < base.size() && base.size() - letters <= kMostDigits) {
    position = std::stoll(base.substr(letters));
  }
  return {base.substr(0, letters), position};
}

/// Puts layers into an order in which each takes what the one before gives.
class Chain {
 public:
  explicit Chain(const TensorTable& table) : table_(table), bases_(layers_of(table)) {
    std::sort(bases_.begin(), bases_.end(), [](const std::string& a, const std::string& b) {
      return position_of(a) < position_of(b);
    });
    used_.assign(bases_.size(), false);
  }

  std::vector<std::string> find() {
    constexpr std::size_t kMost = 16;
    std::set<std::string> beginnings;
    for (const std::string& base : bases_) {
      const auto [beginning, position] = position_of(base);
      beginnings.insert(position < 0 ? base : beginning);
    }
    const auto linear = [this](const std::string& base) { return is_linear(table_, base); };
    const bool is_one = beginnings.size() < 2;
    if (is_one || bases_.size() > kMost || std::count_if(bases_.begin(), bases_.end(), linear) < 2)
      return {};
    return follow(-1) ? order_ : std::vector<std::string>{};
  }

 private:
  /// Whether all layers that are left can come after one that gives `size` values, -1 being any.
  bool follow(std::int64_t size) {
    if (order_.size() == bases_.size()) return true;
    if (--tries_ < 0) return false;
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      if (used_[i] || !comes_next(i)) continue;
      const Dims& shape = weight_of(table_, bases_[i])->shape;
      if (shape.empty() || shape.size() > 2 || (size >= 0 && shape.back() != size)) continue;
      used_[i] = true;
      order_.push_back(bases_[i]);
      if (follow(shape.front())) return true;
      order_.pop_back();
      used_[i] = false;
    }
    return false;
  }
  /// Positions of one beginning stay in their order.
  bool comes_next(std::size_t i) const {
    const auto [beginning, position] = position_of(bases_[i]);
    if (position < 0) return true;
    for (std::size_t k = 0; k < i; ++k) {
      if (!used_[k] && position_of(bases_[k]).first == beginning) return false;
    }
    return true;
  }

  const TensorTable& table_;
  std::vector<std::string> bases_, order_;
  std::vector<bool> used_;
  int tries_ = 10'000;
};

/// Activations between layers if the graph names none: the one of all, after each Linear or the
/// norm behind it, but for the last.
void activate_between(const TensorTable& table, ActorLayout& layout) {
  bool any_linear = false;
  for (std::size_t i = 0; i + 1 < layout.modules.size(); ++i) {
    any_linear = any_linear || is_linear(table, layout.modules[i].base);
    layout.modules[i].activation_after = any_linear && is_linear(table, layout.modules[i + 1].base);
  }
}

}  // namespace

std::vector<std::string> order_by_sizes(const TensorTable& table) {
  return Chain(table).find();
}

std::optional<ActorLayout> said_layout(const TensorTable& table,
                                       const std::vector<std::string>& layers,
                                       std::optional<Activation>& output, PolicyProblem& problem) {
  ActorLayout layout{{.about = "layers as the graph says", .output_rule = OutputRule::unknown}};
  layout.is_said = true;
  bool names_activations = false;
  for (const std::string& name : layers) {
    if (weight_of(table, name) != nullptr || is_batch_norm(table, name)) {
      layout.modules.push_back({name, false, {}});
      continue;
    }
    const auto activation = activation_of(name);
    if (!activation || layout.modules.empty() || layout.modules.back().activation) {
      std::vector<std::string> known;
      for (const std::string& base : layers_of(table)) known.push_back(printable(base));
      return refuse(problem, "E0624",
                    fmt::format("has no layer `{}`: its layers are `{}`", printable(name),
                                join(known, "`, `")),
                    "name layers, each followed by its activation or none");
    }
    names_activations = true;
    layout.modules.back().activation = activation;
    layout.modules.back().activation_after = *activation != Activation::identity;
  }
  if (layout.modules.empty()) {
    return refuse(problem, "E0624", "has no layers in the graph's `layers`", kOtherActor);
  }
  if (names_activations) {
    output = layout.modules.back().activation.value_or(Activation::identity);
    layout.modules.back().activation_after = false;
  } else {
    activate_between(table, layout);
  }
  return layout;
}

}  // namespace eagerx::gen
