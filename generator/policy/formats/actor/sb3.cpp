// Stable-Baselines3's `data`: JSON with a pickle in text form for everything that JSON cannot hold.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/formats/tensors/numbers.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/json/base64.hpp"

namespace eagerx::gen {
namespace {

constexpr std::uint64_t kMostNumbers = std::uint64_t{1} << 23U;  // of a space

std::optional<Pickle> unpickled(const Json& value, std::string& bytes, PolicyProblem& problem) {
  auto decoded = from_base64(text_of(member(&value, ":serialized:")));
  if (!decoded || decoded->empty()) return std::nullopt;
  bytes = std::move(*decoded);
  return read_pickle(bytes, PickleNames::statistics, problem);
}

bool is_space(const Pickle& pickle, const PickleValue& value, std::string_view name) {
  return value.kind == PickleValue::Kind::object && pickle.at(value.function).text.ends_with(name);
}

/// The bounds of a Box, or nothing.
std::optional<std::vector<double>> bounds(const Pickle& pickle, const PickleValue& box,
                                          const char* key) {
  const auto array = pickle.array(pickle.find(box, key));
  return array ? std::optional(values_of(*array)) : std::nullopt;
}

class DataReader {
 public:
  DataReader(const Json* data, PolicyProblem& problem) : data_(data), problem_(problem) {}

  std::optional<PolicyFacts> read() {
    read_algorithm();
    read_own_class();
    if (!read_keywords() || !read_observations() || !read_actions()) return std::nullopt;
    return std::move(facts_);
  }

 private:
  Refused fail(const std::string& how) {
    return refuse(problem_, "E0626", fmt::format("has `data` {}", how),
                  "save it again, or use the ONNX file of the actor");
  }

  /// From the module of its policy: "stable_baselines3.sac.policies".
  void read_algorithm() {
    const Json* policy = member(data_, "policy_class");
    const std::string module = text_of(member(policy, "__module__"));
    for (const char* name : {"sac", "td3", "dqn", "tqc", "qrdqn", "ars", "crossq"}) {
      if (module.find(fmt::format(".{}.", name)) == std::string::npos) continue;
      for (const char* c = name; *c != '\0'; ++c) {
        facts_.contract.algorithm +=
            static_cast<char>(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
      }
    }
    if (module == "stable_baselines3.common.policies") {
      facts_.contract.algorithm = member(data_, "n_epochs") != nullptr ? "PPO" : "A2C";
    }
    if (module.find("recurrent") != std::string::npos) {
      facts_.contract.algorithm = "RecurrentPPO";
    }
    if (module.find("maskable") != std::string::npos) facts_.contract.algorithm = "MaskablePPO";
    if (facts_.contract.algorithm == "A2C" && member(data_, "cg_max_steps") != nullptr) {
      facts_.contract.algorithm = "TRPO";
    }
    if (facts_.contract.algorithm == "ARS" && policy != nullptr) read_class(*policy);
  }
  /// A class that the libraries do not have may calculate anything from the same tensors.
  void read_own_class() {
    const Json* policy = member(data_, "policy_class");
    const std::string module = text_of(member(policy, "__module__"));
    if (module.empty() || is_of_library(module)) return;
    facts_.own_class = module;
    const auto* members = policy->as<Json::Object>();
    if (members == nullptr) return;
    std::string name;
    for (const auto& [key, value] : *members) {
      // "<function NAME.METHOD at 0x7f…>"
      constexpr std::string_view kFunction = "<function ";
      const std::string text = text_of(&value);
      if (!text.starts_with(kFunction)) continue;
      const std::string path = text.substr(kFunction.size(), text.find(" at ") - kFunction.size());
      const std::size_t dot = path.rfind('.');
      if (name.empty() && dot != std::string::npos) name = "." + path.substr(0, dot);
      facts_.own_methods.push_back(key);
    }
    *facts_.own_class += name;
  }
  static bool is_of_library(std::string_view name) {
    return name.starts_with("stable_baselines3.") || name.starts_with("sb3_contrib.");
  }
  /// ARS's two policies differ by a tanh. The name of the class is in a pickle of nothing else.
  void read_class(const Json& policy) {
    const auto pickled = from_base64(text_of(member(&policy, ":serialized:")));
    if (!pickled) return;
    if (pickled->find("ARSPolicy") != std::string::npos) facts_.squash = true;
    if (pickled->find("ARSLinearPolicy") != std::string::npos) facts_.squash = false;
  }

  bool read_keywords() {
    const Json* keywords = member(data_, "policy_kwargs");
    if (keywords == nullptr) return true;
    if (const auto squash = truth_of(member(keywords, "squash_output"))) facts_.squash = squash;
    if (const auto limit = number_of(member(keywords, "clip_mean"))) facts_.limit = *limit;
    if (const auto epsilon = number_of(member(keywords, "batch_norm_eps"))) {
      facts_.norm_epsilon = *epsilon;
    }
    if (const auto scales = truth_of(member(keywords, "normalize_images"))) {
      scales_pixels_ = *scales;
    }
    if (std::string name = text_of(member(keywords, "features_extractor_class")); !name.empty()) {
      // "<class 'stable_baselines3.common.torch_layers.NatureCNN'>"
      while (!name.empty() && (name.back() == '>' || name.back() == '\'')) name.pop_back();
      name.erase(0, name.find('\'') + 1);
      const bool is_own = !is_of_library(name);
      facts_.extractor = is_own ? name : name.substr(name.rfind('.') + 1);
    }
    if (const std::string name = text_of(member(keywords, "activation_fn")); !name.empty()) {
      facts_.activation = activation_of(name);
      if (!facts_.activation) {
        return fail(fmt::format("with activation `{}`, which is not supported", printable(name)));
      }
    }
    if (const Json* arch = member(keywords, "net_arch")) read_hidden(*arch);
    return true;
  }

  /// [64, 64], {"pi": [64, 64], "vf": …} or [{"pi": …}].
  void read_hidden(const Json& arch) {
    const Json* list = &arch;
    const auto* items = arch.as<Json::List>();
    if (items != nullptr && items->size() == 1 && items->front().is<Json::Object>()) {
      list = &items->front();
    }
    if (list->is<Json::Object>()) list = member(list, "pi");
    const auto sizes = numbers_of(list);
    if (!sizes || number_of(list)) return;
    facts_.hidden.emplace();
    for (const double size : *sizes) {
      if (!(size >= 0.0 && size < 1e9)) return facts_.hidden.reset();
      facts_.hidden->push_back(static_cast<std::int64_t>(size));
    }
  }

  /// Only spaces: other pickles in `data` may hold anything, and are not looked at.
  std::optional<Pickle> space(const char* key, std::string& bytes) {
    const Json* value = member(data_, key);
    if (value == nullptr) {
      return fail(fmt::format("without `{}`", key));
    }
    PolicyProblem why;
    auto pickle = unpickled(*value, bytes, why);
    if (!pickle) {
      if (why.code == "E0622") {
        problem_ = why;
      } else {
        fail(fmt::format("whose `{}` cannot be read", key));
      }
    }
    return pickle;
  }

  std::optional<std::uint64_t> size_of_box(const Pickle& pickle, const PickleValue& box) const {
    const PickleValue* shape = pickle.find(box, "_shape");
    if (shape == nullptr) shape = pickle.find(box, "shape");
    const auto dims = pickle.integers(shape);
    const auto count = dims ? element_count(*dims) : std::nullopt;
    return count ? std::optional<std::uint64_t>(static_cast<std::uint64_t>(*count)) : std::nullopt;
  }

  /// An image is a Box of three dimensions of bytes from 0 to 255; SB3 puts its channels first.
  void read_image(const Pickle& pickle, const PickleValue& box) {
    const auto dims = pickle.integers(pickle.find(box, "_shape"));
    if (!dims || dims->size() != 3) return;
    facts_.image = *dims;
    const PickleValue* type = pickle.find(box, "dtype");
    const PickleValue* arguments = type != nullptr && pickle.made_by(*type, "numpy.dtype")
                                       ? &pickle.at(type->arguments)
                                       : nullptr;
    const bool is_bytes = arguments != nullptr && !arguments->items.empty() &&
                          pickle.at(arguments->items.front()).text == "u1";
    const auto all = [&](const char* key, double wanted) {
      const auto values = bounds(pickle, box, key);
      return values && std::all_of(values->begin(), values->end(),
                                   [wanted](double value) { return value == wanted; });
    };
    facts_.scales_pixels = scales_pixels_ && is_bytes && all("low", 0.0) && all("high", 255.0);
  }

  /// The choices of a Discrete or MultiDiscrete, `[0, …]` of a MultiBinary or Box; nothing if it is
  /// no space, or none that can be read.
  std::optional<std::vector<std::uint32_t>> choices_of(const Pickle& pickle,
                                                       const PickleValue& space) const {
    constexpr double kMost = 1e6;
    const auto count = [&](double value) -> std::optional<std::uint32_t> {
      if (!(value >= 1.0 && value < kMost)) return std::nullopt;
      return static_cast<std::uint32_t>(value);
    };
    const auto starts_at_zero = [&] {
      const PickleValue* start = pickle.find(space, "start");
      if (start == nullptr || start->kind == PickleValue::Kind::none) return true;
      const auto array = pickle.array(start);
      if (!array) return pickle.number(start) == 0.0;
      const std::vector<double> starts = values_of(*array);
      return ranges::all_of(starts, [](double value) { return value == 0.0; });
    };
    if (is_space(pickle, space, ".Discrete")) {
      const auto n = pickle.number(pickle.find(space, "n"));
      const auto choices = n && starts_at_zero() ? count(*n) : std::nullopt;
      return choices ? std::optional(std::vector{*choices}) : std::nullopt;
    }
    if (is_space(pickle, space, ".MultiDiscrete")) {
      const auto array = pickle.array(pickle.find(space, "nvec"));
      if (!array || array->shape.size() != 1 || !starts_at_zero()) return std::nullopt;
      std::vector<std::uint32_t> all;
      for (const double n : values_of(*array)) {
        const auto choices = count(n);
        if (!choices) return std::nullopt;
        all.push_back(*choices);
      }
      return all;
    }
    const bool is_plain =
        is_space(pickle, space, ".Box") || is_space(pickle, space, ".MultiBinary");
    auto size = is_plain ? size_of_box(pickle, space) : std::nullopt;
    if (is_plain && !size) {
      const auto n = pickle.number(pickle.find(space, "n"));
      if (n) size = count(*n);
    }
    if (!size || *size > kMostNumbers) return std::nullopt;
    return std::vector<std::uint32_t>(static_cast<std::size_t>(*size), 0);
  }

  /// A space other than Box has no bounds of its own: they are those of its choices.
  void add_bounds_of_choices(bool is_binary) {
    PolicyContract& contract = facts_.contract;
    for (const std::uint32_t count : contract.choices) {
      contract.observation_low.push_back(0.0);
      contract.observation_high.push_back(is_binary ? 1.0 : static_cast<double>(count) - 1.0);
    }
  }

  bool read_dictionary(const Pickle& pickle, const PickleValue& top) {
    const PickleValue* spaces = pickle.find(top, "spaces");
    if (spaces == nullptr) return fail("whose `observation_space` cannot be read");
    constexpr std::size_t kMostParts = 10'000;  // one may be there often
    if (spaces->items.size() > 2 * kMostParts)
      return fail("whose `observation_space` has too many parts");
    std::vector<std::uint32_t>& choices = facts_.contract.choices;
    for (std::size_t i = 0; i + 1 < spaces->items.size(); i += 2) {
      const PickleValue& name = pickle.at(spaces->items[i]);
      if (name.text.size() > kLongestPickledName) {
        return fail("whose `observation_space` has a name of impossible length");
      }
      const auto part = choices_of(pickle, pickle.at(spaces->items[i + 1]));
      if (!part) {
        return fail(
            "whose `observation_space` has parts that are not Box, Discrete from 0 on, "
            "MultiDiscrete or MultiBinary");
      }
      facts_.contract.observations.push_back({std::string(name.text), part->size()});
      if (choices.size() + part->size() > kMostNumbers)
        return fail("whose `observation_space` is too large");
      choices.insert(choices.end(), part->begin(), part->end());
    }
    return true;
  }

  bool read_observations() {
    std::string bytes;
    const auto pickle = space("observation_space", bytes);
    if (!pickle) return false;
    const PickleValue& top = pickle->top();
    std::vector<std::uint32_t>& choices = facts_.contract.choices;
    if (is_space(*pickle, top, ".Dict")) {
      if (!read_dictionary(*pickle, top)) return false;
    } else {
      auto found = choices_of(*pickle, top);
      if (!found) {
        return fail(
            "whose `observation_space` is not a Box, Discrete from 0 on, MultiDiscrete of one "
            "dimension, MultiBinary, or Dict of them");
      }
      choices = std::move(*found);
      if (is_space(*pickle, top, ".Box")) {
        read_image(*pickle, top);
        facts_.contract.observation_low =
            bounds(*pickle, top, "low").value_or(std::vector<double>());
        facts_.contract.observation_high =
            bounds(*pickle, top, "high").value_or(std::vector<double>());
      } else {
        add_bounds_of_choices(is_space(*pickle, top, ".MultiBinary"));
      }
    }
    facts_.observations = static_cast<std::int64_t>(choices.size());
    if (ranges::all_of(choices, [](std::uint32_t count) { return count == 0; })) {
      choices.clear();
    }
    return true;
  }

  bool read_actions() {
    std::string bytes;
    const auto pickle = space("action_space", bytes);
    if (!pickle) return false;
    const PickleValue& top = pickle->top();
    if (is_space(*pickle, top, ".Discrete")) {
      const auto count = pickle->number(pickle->find(top, "n"));
      if (!count || !(*count >= 1.0 && *count < 1e6)) return fail("whose `action_space` is empty");
      facts_.actions = static_cast<std::int64_t>(*count);
      facts_.action = ActionKind::argmax;
      const auto start = pickle->number(pickle->find(top, "start"));
      facts_.contract.first_choices = {
          start && *start > -1e9 && *start < 1e9 ? static_cast<std::int64_t>(*start) : 0};
      return true;
    }
    if (!is_space(*pickle, top, ".Box")) return read_choices(*pickle, top);
    const auto low = bounds(*pickle, top, "low");
    const auto high = bounds(*pickle, top, "high");
    if (!low || !high || low->size() != high->size()) {
      return fail("whose `action_space` has no bounds");
    }
    facts_.actions = static_cast<std::int64_t>(low->size());
    facts_.contract.action_low = *low;
    facts_.contract.action_high = *high;
    return true;
  }

  /// Actions of several whole numbers. Their scores are outputs side by side.
  bool read_choices(const Pickle& pickle, const PickleValue& space) {
    const bool is_binary = is_space(pickle, space, ".MultiBinary");
    auto counts = is_binary || is_space(pickle, space, ".MultiDiscrete") ? choices_of(pickle, space)
                                                                         : std::nullopt;
    if (!counts || counts->empty()) {
      return fail(
          "whose `action_space` is not a Box, Discrete, MultiDiscrete of one dimension and from 0 "
          "on, "
          "or MultiBinary");
    }
    facts_.action = is_binary ? ActionKind::binary : ActionKind::argmax;
    facts_.actions = 0;
    for (const std::uint32_t count : *counts) *facts_.actions += is_binary ? 1 : count;
    if (is_binary) return true;
    facts_.contract.first_choices = {0};
    facts_.contract.groups = std::move(*counts);
    return true;
  }

  const Json* data_;  // an object
  PolicyProblem& problem_;
  PolicyFacts facts_;
  bool scales_pixels_ = true;
};

}  // namespace

std::optional<PolicyFacts> facts_of_sb3(std::string_view text, PolicyProblem& problem) {
  const auto data = parse_json(text);
  if (!data || !data->is<Json::Object>()) {
    return refuse(problem, "E0626", "has `data` that is not one JSON object", kSaveAgain);
  }
  return DataReader(&*data, problem).read();
}

}  // namespace eagerx::gen
