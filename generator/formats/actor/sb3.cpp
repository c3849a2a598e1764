// Stable-Baselines3's `data`: JSON with a pickle in text form for everything that JSON cannot hold.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/formats/actor/actor.hpp"
#include "generator/formats/tensors/archive.hpp"
#include "generator/formats/tensors/containers.hpp"
#include "generator/formats/tensors/numbers.hpp"

namespace eagerx::gen {
namespace {

/// The bytes of base64 text; nothing if it is not.
std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    std::uint32_t value = 0;
    if (c >= 'A' && c <= 'Z') {
      value = static_cast<std::uint32_t>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      value = static_cast<std::uint32_t>(c - 'a') + 26;
    } else if (c >= '0' && c <= '9') {
      value = static_cast<std::uint32_t>(c - '0') + 52;
    } else if (c == '+' || c == '/') {
      value = c == '+' ? 62 : 63;
    } else if (c == '=') {
      break;
    } else {
      return std::nullopt;
    }
    bits = bits << 6U | value;
    if (++count % 4 != 1) bytes += static_cast<char>(bits >> (2 * (3 - (count - 1) % 4)));
  }
  return bytes;
}

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
  const PickleValue* value = pickle.find(box, key);
  const auto array = value != nullptr ? pickle.array(*value) : std::nullopt;
  if (!array) return std::nullopt;
  return values_of(*array);
}

class DataReader {
 public:
  DataReader(const Json* data, PolicyProblem& problem) : data_(data), problem_(problem) {}

  std::optional<PolicyFacts> read() {
    read_algorithm();
    if (!read_keywords() || !read_observations() || !read_actions()) return std::nullopt;
    return std::move(facts_);
  }

 private:
  bool fail(const std::string& how) {
    problem_ = {"E0626", fmt::format("has `data` {}", how),
                "save it again, or use the ONNX file of the actor"};
    return false;
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
      facts_.extractor = name.substr(name.rfind('.') + 1);
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
      fail(fmt::format("without `{}`", key));
      return std::nullopt;
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
    const auto dims = shape != nullptr ? pickle.integers(*shape) : std::nullopt;
    const auto count = dims ? element_count(*dims) : std::nullopt;
    return count ? std::optional<std::uint64_t>(static_cast<std::uint64_t>(*count)) : std::nullopt;
  }

  /// An image is a Box of three dimensions of bytes from 0 to 255; SB3 puts its channels first.
  void read_image(const Pickle& pickle, const PickleValue& box) {
    const PickleValue* shape = pickle.find(box, "_shape");
    const auto dims = shape != nullptr ? pickle.integers(*shape) : std::nullopt;
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

  bool read_observations() {
    std::string bytes;
    const auto pickle = space("observation_space", bytes);
    if (!pickle) return false;
    const PickleValue& top = pickle->top();
    std::uint64_t total = 0;
    if (is_space(*pickle, top, ".Box")) {
      const auto size = size_of_box(*pickle, top);
      if (!size) return fail("whose `observation_space` has no shape");
      total = *size;
      read_image(*pickle, top);
      facts_.contract.observation_low = bounds(*pickle, top, "low").value_or(std::vector<double>());
      facts_.contract.observation_high =
          bounds(*pickle, top, "high").value_or(std::vector<double>());
    } else if (is_space(*pickle, top, ".Dict")) {
      const PickleValue* spaces = pickle->find(top, "spaces");
      if (spaces == nullptr) return fail("whose `observation_space` cannot be read");
      for (std::size_t i = 0; i + 1 < spaces->items.size(); i += 2) {
        const PickleValue& box = pickle->at(spaces->items[i + 1]);
        constexpr std::size_t kLongestName = 4096;  // one may be there often
        if (pickle->at(spaces->items[i]).text.size() > kLongestName) {
          return fail("whose `observation_space` has a name of impossible length");
        }
        const auto size = is_space(*pickle, box, ".Box") ? size_of_box(*pickle, box) : std::nullopt;
        if (!size) return fail("whose `observation_space` has parts that are not a Box");
        facts_.contract.observations.push_back(
            {std::string(pickle->at(spaces->items[i]).text), *size});
        total += *size;
      }
    } else {
      return fail("whose `observation_space` is neither a Box nor a Dict of them");
    }
    if (total < std::uint64_t{kMaxElements}) facts_.observations = static_cast<std::int64_t>(total);
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
      facts_.contract.first_choice =
          start && *start > -1e9 && *start < 1e9 ? static_cast<std::int64_t>(*start) : 0;
      return true;
    }
    if (!is_space(*pickle, top, ".Box")) {
      return fail("whose `action_space` is neither a Box nor Discrete");
    }
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
