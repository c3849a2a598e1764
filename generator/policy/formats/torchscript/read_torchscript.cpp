// The file does not contain the size of the observation. The reader tries the sizes of its tensors,
// smallest first, until it can follow `forward` to the end.
#include "generator/policy/formats/torchscript/read_torchscript.hpp"

#include <fmt/format.h>

#include <deque>
#include <set>
#include <unordered_set>
#include <utility>

#include "generator/policy/formats/torchscript/interpreter.hpp"
#include "generator/policy/formats/torchscript/states.hpp"
#include "generator/policy/network/graph/ends.hpp"
#include "generator/policy/network/graph/lower.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kConstants = "constants.pkl";
constexpr std::int64_t kMostStatements = 400'000;
constexpr std::size_t kMostTries = 1500;
constexpr const char* kSayResult =
    "say it in the graph: `agent: {policy: …, output_name: \"0\"}`; for `policy` with `--output 0`";

/// One try.
struct TorchTry {
  NetCall::State state;
  std::optional<TorchInterpreter> interpreter;
  std::optional<NetAction> action;
  std::vector<std::string> others;  // results that are not the action, for people
  PolicyProblem problem;
  std::set<std::uint32_t> histories{};                 // buffers that are read as such
  std::pair<std::size_t, std::int64_t> reached{0, 0};  // steps, statements
};

/// A part of what `forward` returns, and its place: "0", "1.0".
struct TorchResult {
  std::string place;
  const TorchValue* value;
};

void add_results(const TorchValue& value, const std::string& place,
                 std::vector<TorchResult>& results) {
  constexpr std::size_t kMostResults = 64;
  if (value.kind != TorchValue::Kind::sequence) {
    if (value.is_tensor() && results.size() < kMostResults) results.push_back({place, &value});
    return;
  }
  for (std::size_t i = 0; i < value.items.size() && results.size() < kMostResults; ++i) {
    add_results(value.items[i], fmt::format("{}{}{}", place, place.empty() ? "" : ".", i), results);
  }
}

std::string shown(const TorchResult& result) {
  const auto& shape = result.value->tensor->value.shape;
  return fmt::format("`{}`{}", result.place, shape ? " " + show(*shape) : "");
}

class TorchReading {
 public:
  TorchReading(TorchArchive& archive, const ReadContext& context, PolicyProblem& problem)
      : archive_(archive),
        output_(context.output_name),
        said_(context.input_sizes),
        problem_(problem) {}

  std::optional<Network> run() {
    const auto names = inputs_of_forward();
    if (!names) return std::nullopt;
    std::vector<std::int64_t> sizes = said_;
    if (said_.empty() ? !find_sizes(names->size(), sizes) || !is_only(*names, sizes)
                      : !check_said(*names)) {
      return std::nullopt;
    }
    TorchTry found;
    follow(sizes, found);
    if (!check_torch_states(archive_, *found.interpreter, found.state, found.action->step,
                            problem_)) {
      return std::nullopt;
    }
    Network network;
    std::uint32_t observed = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      observed += static_cast<std::uint32_t>(sizes[i]);
      if (sizes.size() == 1) continue;
      network.contract.observations.push_back(
          {printable((*names)[i]), static_cast<std::uint64_t>(sizes[i])});
    }
    if (found.action->is_choice) network.action = ActionKind::argmax;
    network.contract.groups = found.action->groups;
    std::unordered_set<const NetTensor*> used;
    auto layers = make_layers(found.state.steps, found.action->step, observed, used, problem_);
    if (!layers) return std::nullopt;
    network.layers = std::move(*layers);
    network.format = "TorchScript";
    network.ignored = std::move(found.others);
    for (std::size_t i = 0; said_.empty() && i < sizes.size(); ++i) {
      std::vector<std::int64_t> longer = sizes;
      ++longer[i];
      if (!goes(longer)) continue;
      network.assumed.push_back(
          sizes.size() == 1
              ? fmt::format("an observation of {} numbers: the file takes longer ones too",
                            observed)
              : fmt::format("{} numbers for `{}`: the file takes more, too", sizes[i],
                            printable((*names)[i])));
    }
    return network;
  }

 private:
  /// Names of the arguments of `forward`.
  std::optional<std::vector<std::string>> inputs_of_forward() {
    const Pickle& modules = archive_.pickle(0);
    const std::string type(modules.at(modules.top().function).text);
    const std::size_t dot = type.rfind('.');
    if (modules.top().kind != PickleValue::Kind::object || dot == std::string::npos) {
      return refuse(problem_, "E0753", "is a TorchScript archive without a module",
                    "export the actor again");
    }
    const TorchFunction* forward =
        archive_.function(type.substr(0, dot), type.substr(dot + 1) + ".forward", problem_);
    if (forward == nullptr) return std::nullopt;
    std::vector<std::string> names;
    for (const TorchFunction::Parameter& parameter : forward->parameters) {
      if (parameter.otherwise) continue;
      names.push_back(parameter.name);
      const bool is_self = names.size() == 1;
      if (!is_self && !parameter.type.empty() && parameter.type != "Tensor") {
        return refuse(problem_, "E0754",
                      fmt::format("has a `forward` that takes `{}`, which is not a tensor but {}",
                                  printable(parameter.name), printable(parameter.type)),
                      "export a module that keeps its state in buffers, or export it to ONNX with "
                      "the state as an input and an output");
      }
    }
    if (!names.empty()) names.erase(names.begin());  // self
    constexpr std::size_t kMostInputs = 8;
    if (!names.empty() && names.size() <= kMostInputs) return names;
    return refuse(problem_, "E0754", fmt::format("has a `forward` with {} arguments", names.size()),
                  "export a module that takes the observation");
  }

  /// Again with each buffer that `forward` changes as a history: what is known of its former
  /// numbers is only where they are.
  void follow(const std::vector<std::int64_t>& sizes, TorchTry& made) {
    follow_changes(sizes, made);
    while (!made.action && add_history(sizes, made)) follow_changes(sizes, made);
  }
  /// If it does not come farther like that, the buffer is no history, which is the problem.
  void follow_changes(const std::vector<std::int64_t>& sizes, TorchTry& made) {
    PolicyProblem changes;
    std::int64_t followed = -1;
    for (;;) {
      made.state = {};
      made.action.reset();
      made.others.clear();
      made.problem = {};
      follow_once(sizes, made);
      made.reached =
          std::max(made.reached, {made.state.steps.size(), made.interpreter->followed()});
      const auto changed = made.interpreter->changed();
      if (!changed || !made.histories.insert(*changed).second) break;
      if (followed >= 0) continue;
      followed = made.interpreter->followed();
      refuse(changes, "E0756",
             fmt::format("has a buffer `{}` {}",
                         printable(made.interpreter->cells().at(*changed)->buffer), kUnknownState),
             kHistoryAsInput);
      if (!made.action) changes = made.problem;
    }
    if (!made.action && made.interpreter->followed() <= followed) made.problem = changes;
  }
  /// A buffer of zeros with which `forward` comes farther if it is a history: it may be read in a
  /// way that zeros cannot be, before it is changed.
  bool add_history(const std::vector<std::int64_t>& sizes, TorchTry& made) {
    constexpr std::size_t kMostBuffers = 8;
    std::size_t tried = 0;
    for (const std::uint32_t index : made.interpreter->zeros()) {
      if (made.histories.contains(index) || ++tried > kMostBuffers) continue;
      TorchTry other;
      other.histories = made.histories;
      other.histories.insert(index);
      follow_once(sizes, other);
      if (!other.action && other.interpreter->followed() <= made.interpreter->followed()) continue;
      made.histories = other.histories;
      return true;
    }
    return false;
  }
  void follow_once(const std::vector<std::int64_t>& sizes, TorchTry& made) {
    made.state.has_gates_of_onnx = false;
    made.state.budget = values_;
    std::vector<NetValue> inputs;
    for (const std::int64_t size : sizes) {
      if (sizes.size() > 1) {
        inputs.push_back(observation_part(made.state, "observation", {1, size}));
        continue;
      }
      inputs.push_back(data_value(-1, {1, size}));
      made.state.observed = size;
    }
    made.interpreter.emplace(archive_, made.state, statements_, made.problem, made.histories);
    const auto result = made.interpreter->run(inputs);
    values_ = made.state.budget;
    const TorchValue* action = result ? action_among(*result, made) : nullptr;
    if (action == nullptr) return;
    made.action = action_of(action->tensor->value, "export the actor", made.problem);
  }

  /// Of several results the one that was asked for.
  const TorchValue* action_among(const TorchValue& all, TorchTry& made) const {
    std::vector<TorchResult> results;
    add_results(all, "", results);
    const auto fail = [&](const char* code, std::string message, const char* help) {
      return refuse(made.problem, code, std::move(message), help);
    };
    if (results.empty()) {
      return fail("E0754", "has a `forward` that returns no tensor",
                  "export a module that returns the action");
    }
    if (all.is_tensor() && !output_.empty()) {
      return fail("E0751", "has one result, which has no name", "leave `output_name` out");
    }
    if (output_.empty() && results.size() == 1) return results.front().value;
    std::vector<std::string> texts;
    texts.reserve(results.size());
    for (const TorchResult& result : results) texts.push_back(shown(result));
    const TorchValue* action = nullptr;
    for (const TorchResult& result : results) {
      if (result.place == output_) {
        action = result.value;
      } else {
        made.others.push_back("result " + shown(result));
      }
    }
    if (action != nullptr) return action;
    const std::string listed = fmt::format("{}", join(texts, ", "));
    if (!output_.empty()) {
      return fail("E0751", fmt::format("has no result `{}`: it has {}", printable(output_), listed),
                  "name one of them");
    }
    return fail("E0751",
                fmt::format("has {} results, and it is not known which one is the action: {}",
                            results.size(), listed),
                kSayResult);
  }

  /// Whether `forward` goes through with these sizes.
  bool goes(const std::vector<std::int64_t>& sizes) {
    TorchTry made;
    follow(sizes, made);
    return made.action.has_value();
  }

  /// Whether sizes that the graph says go through; else why not.
  bool check_said(const std::vector<std::string>& names) {
    if (said_.size() != names.size()) {
      return refuse(problem_, "E0755",
                    fmt::format("has a `forward` that takes {}, not {}: {}",
                                counted(names.size(), "input"), said_.size(), quoted(names)),
                    "write one size for each in `input_sizes`");
    }
    TorchTry made;
    follow(said_, made);
    if (made.action) return true;
    problem_ = made.problem;
    problem_.help = fmt::format("if `input_sizes` are not those of {}, write these; else {}",
                                quoted(names), problem_.help);
    return false;
  }
  static std::string quoted(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
      text += fmt::format("{}`{}`", text.empty() ? "" : ", ", printable(name));
    }
    return text;
  }

  /// Whether no number can belong to another input instead: in cat([command, state]) only the sum
  /// of the sizes is in the file.
  bool is_only(const std::vector<std::string>& names, const std::vector<std::int64_t>& sizes) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        std::vector<std::int64_t> other = sizes;
        ++other[i];
        if (i == k || --other[k] < 1 || !goes(other)) continue;
        return say_sizes(names, fmt::format("`{}` and `{}` could have {} and {}, as well as {} "
                                            "and {}",
                                            printable(names[i]), printable(names[k]), sizes[i],
                                            sizes[k], other[i], other[k]));
      }
    }
    return true;
  }
  Refused say_sizes(const std::vector<std::string>& names, const std::string& why) {
    return refuse(
        problem_, "E0755", fmt::format("does not say how many numbers its inputs have: {}", why),
        fmt::format("say how many {} have, in this order: `agent: {{policy: …, "
                    "input_sizes: [{}]}}`; for `policy` with `--input-sizes`",
                    quoted(names), join(std::vector<std::string>(names.size(), "…"), ", ")));
  }

  /// The first sizes that go through. Else the problem of the try that came farthest. What a layer
  /// lacks in a try is given to each of the inputs in turn.
  bool find_sizes(std::size_t count, std::vector<std::int64_t>& sizes) {
    const std::vector<std::int64_t> candidates = candidates_for(count);
    std::vector<std::size_t> at(count, 0);
    std::pair<std::size_t, std::int64_t> farthest;  // steps, statements
    bool any = false;
    std::deque<std::vector<std::int64_t>> better;
    std::set<std::vector<std::int64_t>> tried;
    bool all = candidates.empty();
    for (std::size_t tries = 0; tries < kMostTries && !(all && better.empty()); ++tries) {
      sizes.clear();
      if (!better.empty()) {
        sizes = better.front();
        better.pop_front();
      } else {
        for (const std::size_t i : at) sizes.push_back(candidates[i]);
        std::size_t k = count;
        while (k-- > 0 && ++at[k] == candidates.size()) at[k] = 0;
        all = k >= count;
      }
      if (!tried.insert(sizes).second) continue;
      TorchTry made;
      follow(sizes, made);
      if (made.action) return true;
      if (!any || made.reached > farthest) {
        farthest = made.reached;
        problem_ = made.problem;
      }
      any = true;
      if (statements_ < 0 || values_ < 0) break;
      for (std::size_t i = 0; count > 1 && made.state.lacks != 0 && i < count; ++i) {
        std::vector<std::int64_t> changed = sizes;
        changed[i] += made.state.lacks;
        if (changed[i] >= 1 && changed[i] <= kMaxValues) better.push_back(std::move(changed));
      }
    }
    if (!any) {
      problem_ = {"E0755", "has no tensors, so that the size of its observation is not known",
                  "export the actor again"};
    }
    return false;
  }

  /// Sizes of tensors; for one input also their sums, as a part of an observation goes to a layer
  /// and the rest to another, and then what a history of such sizes has.
  std::vector<std::int64_t> candidates_for(std::size_t count) const {
    constexpr std::size_t kMostSums = 40;
    constexpr std::int64_t kLongestHistory = 50;
    const std::vector<std::int64_t> sizes = archive_.sizes();
    std::set<std::int64_t> all(sizes.begin(), sizes.end());
    for (std::size_t i = 0; count == 1 && sizes.size() <= kMostSums && i < sizes.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) all.insert(sizes[i] + sizes[k]);
    }
    std::vector<std::int64_t> result(all.begin(), all.end());
    if (count > 1) return result;
    std::set<std::int64_t> histories;
    for (const std::int64_t size : sizes) {
      for (std::int64_t k = 2; k <= kLongestHistory; ++k) {
        if (size <= kMaxValues / k && !all.contains(size * k)) histories.insert(size * k);
      }
    }
    result.insert(result.end(), histories.begin(), histories.end());
    return result;
  }

  TorchArchive& archive_;
  std::string output_;
  std::vector<std::int64_t> said_;  // sizes of the inputs, as the graph says
  PolicyProblem& problem_;
  std::int64_t statements_ = kMostStatements;
  std::int64_t values_ = NetCall::State().budget;
};

}  // namespace

namespace {

/// A function of `code` that samples random numbers, or "".
std::string_view random_function(std::string_view code) {
  for (const std::string_view name :
       {"randn_like", "randn", "rand_like", "rand", "normal", "bernoulli", "multinomial"}) {
    for (const std::string_view ending : {"(", "_("}) {
      if (code.find(fmt::format("torch.{}{}", name, ending)) != std::string_view::npos) return name;
    }
  }
  return {};
}

/// A module that samples its action calls what belongs to that, too: then this is the reason.
void add_sampling(const Archive& archive, PolicyProblem& problem) {
  if (problem.code != "E0754") return;
  for (const std::string& name : archive.names()) {
    if (!name.ends_with(".py")) continue;
    std::string buffer;
    PolicyProblem ignored;
    const auto code = archive.read(name, buffer, ignored);
    const std::string_view random = code ? random_function(*code) : std::string_view{};
    if (random.empty()) continue;
    problem.message += fmt::format("; its code samples random numbers (`{}`)", random);
    problem.help = "export the deterministic action: means instead of samples, in eval mode";
    return;
  }
}

}  // namespace

bool is_torchscript(const Archive& archive) {
  return ranges::any_of(archive.names(),
                        [](const std::string& name) { return name.ends_with("/constants.pkl"); });
}

std::optional<Network> read_torchscript(const Archive& archive, const ReadContext& context,
                                        PolicyProblem& problem) {
  std::string folder;
  for (const std::string& name : archive.names()) {
    if (name.ends_with("/constants.pkl")) {
      folder = name.substr(0, name.size() - kConstants.size());
    }
  }
  TorchArchive program(archive, folder);
  if (!program.open(problem)) return std::nullopt;
  auto network = TorchReading(program, context, problem).run();
  if (!network) add_sampling(archive, problem);
  return network;
}

}  // namespace eagerx::gen
