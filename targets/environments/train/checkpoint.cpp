#include "targets/environments/train/checkpoint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/number.hpp>
#include <string_view>

#include "targets/environments/train/bytes.hpp"
#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

constexpr std::string_view kKind = "eagerx-train checkpoint ";
constexpr std::string_view kFirstLine = "eagerx-train checkpoint 8\n";
/// Of 1.0, from whose networks a training begins. SAC had no `rewards` and no `reward_scale`.
constexpr std::string_view kFormerLine = "eagerx-train checkpoint 7\n";
static_assert(kFirstLine.size() == kFormerLine.size());
constexpr const char* kOwnFile = "give the file that `--checkpoint` wrote";

/// The sizes of what it visits.
struct Sizes {
  std::vector<std::size_t> all;

  template <class T>
  void operator()(const T& /*value*/) {}
  template <class T>
  void operator()(const std::vector<T>& values) {
    all.push_back(values.size());
  }
};

template <class Visitor, class SomeAdam>
void visit_adam(Visitor& visitor, SomeAdam& adam) {
  visitor(adam.mean);
  visitor(adam.square);
  visitor(adam.steps);
}

template <class Visitor, class SomeModel>
void visit_statistics(Visitor& visitor, SomeModel& model) {
  for (auto* statistics : {&model.observations, &model.returns}) {
    visitor(statistics->mean);
    visitor(statistics->squares);
    visitor(statistics->count);
  }
}

template <class Visitor, class SomeModel>
void visit_rewards(Visitor& visitor, SomeModel& model) {
  visitor(model.rewards.mean);
  visitor(model.rewards.squares);
  visitor(model.rewards.count);
  visitor(model.reward_scale);
}

/// All that has a number for each parameter, action or observation.
template <class Visitor, class SomeModel>
void visit_model(Visitor& visitor, SomeModel& model) {
  visitor(model.actor_parameters);
  if constexpr (requires { model.critics; }) {
    visitor(model.averaged);
    visit_adam(visitor, model.actor_adam);
    for (auto& critic : model.critics) {
      visitor(critic.parameters);
      visitor(critic.target);
      visit_adam(visitor, critic.adam);
    }
    visitor(model.log_temperature);
    visit_adam(visitor, model.temperature_adam);
    visit_statistics(visitor, model);
  } else {
    visitor(model.critic_parameters);
    visitor(model.log_deviation);
    visitor(model.averaged);
    for (auto* adam : {&model.actor_adam, &model.critic_adam, &model.deviation_adam})
      visit_adam(visitor, *adam);
    visit_statistics(visitor, model);
    visitor(model.step_size);
  }
}

template <class Visitor, class SomeModel, class SomeProgress>
void visit(Visitor& visitor, SomeModel& model, SomeProgress& progressed, bool is_former) {
  visitor(progressed.iteration);
  visitor(progressed.succeeded);
  visitor(progressed.curriculum);
  visitor(progressed.curve);
  visitor(progressed.recent);
  visitor(progressed.best.parameters);
  for (auto* score : {&progressed.best.seen, &progressed.best.confirmed}) {
    visitor(score->success);
    visitor(score->mean_return);
  }
  visitor(progressed.actions);
  visit_model(visitor, model);
  if constexpr (requires { model.remembered; }) {
    if (model.actor.memory() != nullptr) visitor(model.remembered);
  }
  if constexpr (requires { model.memory; }) {
    visitor(model.was_taught);
    visitor(model.replayed);
    visitor(model.memory.added);
    visitor(model.memory.rows);
    if (!is_former) visit_rewards(visitor, model);
  }
}

/// The line that starts at `position`, which is moved behind it; empty if there is none.
std::string_view next_line(std::string_view bytes, std::size_t& position) {
  const std::size_t end = bytes.find('\n', position);
  if (end == std::string_view::npos) return {};
  const std::string_view line = bytes.substr(position, end - position);
  position = end + 1;
  return line;
}

struct Parts {
  bool is_former = false;
  std::string conditions, interface;
  std::string_view values;
};

enum class Use : std::uint8_t { resume, begin_from };

Parts parts_of(std::string_view bytes, const std::string& name, Use use) {
  if (!bytes.starts_with(kKind))
    throw Problem(kInputOutput, "`" + name + "` is not a checkpoint", kOwnFile);
  const bool is_former = use == Use::begin_from && bytes.starts_with(kFormerLine);
  if (!is_former && !bytes.starts_with(kFirstLine))
    throw Problem(kInputOutput, "`" + name + "` was written by another version", kOwnFile);
  std::size_t position = kFirstLine.size();
  Parts parts;
  parts.is_former = is_former;
  parts.conditions = with_new_names(next_line(bytes, position));
  parts.interface = with_new_names(next_line(bytes, position));
  const std::string_view hash = next_line(bytes, position);
  parts.values = bytes.substr(position);
  if (hash != fmt::format("{:016x}", host::fnv1a(parts.values)))
    throw Problem(kInputOutput, "`" + name + "` is damaged", kOwnFile);
  return parts;
}

[[noreturn]] void refuse(const std::string& what, const std::vector<Difference>& differences,
                         std::string help) {
  Problem problem(kInputOutput, what + text_of(differences), std::move(help));
  for (const Difference& one : differences) problem.about.push_back(one.name);
  throw problem;
}

[[noreturn]] void refuse_resumed(const std::string& name, std::vector<Difference> all) {
  const auto graph = std::ranges::find(all, "graph", &Difference::name);  // its hash says nothing
  if (graph != all.end()) graph->text = "another graph, or this one before a change";
  refuse(fmt::format("`{}` belongs to another training: ", name), all,
         "resume with the same graph and options, or begin with what it has learnt: `--from`");
}

[[noreturn]] void refuse_begun_from(const std::string& name, const std::vector<Difference>& all) {
  refuse(fmt::format("`{}` is of other networks: ", name), all,
         "give the same algorithm, net_arch and activation_fn, and a graph with the same "
         "observations and actions");
}

/// Those that need no library to be known.
std::vector<Difference> of_settings(std::vector<Difference> all) {
  constexpr std::string_view kOfLibrary[] = {"graph", "critic", "failure-replay", "observations",
                                             "actions"};
  std::erase_if(all, [&](const Difference& one) {
    return std::ranges::find(kOfLibrary, one.name) != std::end(kOfLibrary);
  });
  return all;
}

/// The setting of a former checkpoint; its default then.
double former_reward_scale(std::string_view conditions) {
  constexpr std::string_view kName = "; reward_scale ";
  const std::size_t begin = conditions.find(kName);
  double value = 1.0;
  if (begin == std::string_view::npos) return value;
  const std::string_view rest = conditions.substr(begin + kName.size());
  return host::read_number(rest.substr(0, rest.find(';')), value) && value > 0.0 ? value : 1.0;
}

std::vector<std::size_t> sizes_of(const auto& model) {
  Sizes sizes;
  visit_model(sizes, model);
  if constexpr (requires { model.rewards; }) visit_rewards(sizes, model);
  return sizes.all;
}

std::size_t deployed_size(const Model& model) {
  return model.actor_parameters.size();
}
std::size_t deployed_size(const sac::Model& model) {
  const auto& last = model.actor.layers().back().sizes;
  return model.actor.parameters() - last.outputs / 2 * (last.inputs + 1);
}

bool has_scale(const Model& /*model*/) {
  return true;
}
bool has_scale(const sac::Model& model) {
  return std::isfinite(model.reward_scale) && model.reward_scale >= 0.0;
}

void read_values(const Parts& parts, const std::string& name, auto& model, Progressed& progressed) {
  const auto expected = sizes_of(model);
  Reader reader(parts.values);
  visit(reader, model, progressed, parts.is_former);
  const std::size_t best = progressed.best.parameters.size();
  const bool fits = sizes_of(model) == expected && progressed.recent.size() <= kRecent &&
                    progressed.curve.size() == progressed.iteration &&
                    progressed.curriculum.began <= progressed.iteration &&
                    (best == 0 || best == deployed_size(model)) && has_scale(model);
  if (!reader.complete || !fits)
    throw Problem(kInputOutput, "`" + name + "` is not complete", kOwnFile);
}

std::string names_and_sizes(const std::vector<Space>& spaces) {
  std::vector<std::string> texts;
  for (const Space& space : spaces) texts.push_back(fmt::format("{}[{}]", space.name, space.size));
  return fmt::format("{}", fmt::join(texts, " "));
}

std::string bytes_of(const std::string& conditions, const std::string& interface, const auto& model,
                     const Progressed& progressed) {
  Writer writer;
  visit(writer, model, progressed, false);
  return fmt::format("{}{}\n{}\n{:016x}\n", kFirstLine, conditions, interface,
                     host::fnv1a(writer.bytes)) +
         writer.bytes;
}

void read_own(const std::string& bytes, const std::string& name, const std::string& conditions,
              auto& model, Progressed& progressed) {
  const Parts parts = parts_of(bytes, name, Use::resume);
  if (parts.conditions != conditions)
    refuse_resumed(name, differences(parts.conditions, conditions));
  read_values(parts, name, model, progressed);
}

/// Takes what another training with these networks has learnt.
template <class SomeModel>
SomeModel learnt_by(const std::string& bytes, const std::string& name, const std::string& interface,
                    SomeModel learnt) {
  const Parts parts = parts_of(bytes, name, Use::begin_from);
  if (parts.interface != interface)
    refuse_begun_from(name, differences(parts.interface, interface));
  Progressed ignored;
  read_values(parts, name, learnt, ignored);
  if constexpr (requires { learnt.reward_scale; }) {
    if (parts.is_former && learnt.actor_adam.steps > 0)
      learnt.reward_scale = learnt.returns.scale(0) * former_reward_scale(parts.conditions);
  }
  return learnt;
}

}  // namespace

std::string conditions(const Settings& settings, const std::string& contract_hash) {
  std::string text = fmt::format("algorithm {}; graph {}; seed {}; {}", settings.algorithm,
                                 contract_hash, settings.seed, text_of(settings));
  if (std::isfinite(settings.until_return))
    text += fmt::format("; until-return {}", settings.until_return);
  return text;
}

std::string interface_of(const Settings& settings, const Description& description) {
  std::string rnn;
  if (settings.rnn != Memory::none)
    rnn = fmt::format("; rnn {} {}", settings.rnn == Memory::gru ? "gru" : "lstm",
                      settings.rnn_hidden_size);
  return fmt::format("algorithm {}; observations {}; actions {}; net_arch {}; activation_fn {}{}",
                     settings.algorithm, names_and_sizes(description.observations),
                     names_and_sizes(description.actions), fmt::join(settings.net_arch, ","),
                     settings.activation_fn == Activation::relu ? "relu" : "tanh", rnn);
}

std::string critic_of(const Description& description) {
  return description.critic.empty() ? "" : "; critic " + names_and_sizes(description.critic);
}

void check_resumed(const std::string& bytes, const std::string& name, const Settings& settings) {
  const auto all = of_settings(
      differences(parts_of(bytes, name, Use::resume).conditions, conditions(settings, {})));
  if (!all.empty()) refuse_resumed(name, all);
}

void check_begun_from(const std::string& bytes, const std::string& name, const Settings& settings) {
  const auto all = of_settings(
      differences(parts_of(bytes, name, Use::begin_from).interface, interface_of(settings, {})));
  if (!all.empty()) refuse_begun_from(name, all);
}

std::string checkpoint_of(const std::string& conditions, const std::string& interface,
                          const Model& model, const Progressed& progressed) {
  return bytes_of(conditions, interface, model, progressed);
}

std::string checkpoint_of(const std::string& conditions, const std::string& interface,
                          const sac::Model& model, const Progressed& progressed) {
  return bytes_of(conditions, interface, model, progressed);
}

void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
             Model& model, Progressed& progressed) {
  const std::size_t remembered = model.remembered.size();
  read_own(bytes, name, conditions, model, progressed);
  if (model.remembered.size() != remembered)
    throw Problem(kInputOutput, "`" + name + "` is not complete", kOwnFile);
}

void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
             sac::Model& model, Progressed& progressed) {
  read_own(bytes, name, conditions, model, progressed);
  if (!model.memory.is_whole() || !model.is_due(progressed.iteration))
    throw Problem(kInputOutput, "`" + name + "` is not complete", kOwnFile);
}

void begin_from(const std::string& bytes, const std::string& name, const std::string& interface,
                Model& model) {
  Model learnt = learnt_by(bytes, name, interface, model);
  model.actor_parameters = std::move(learnt.actor_parameters);
  model.critic_parameters = std::move(learnt.critic_parameters);
  model.log_deviation = std::move(learnt.log_deviation);
  model.averaged = std::move(learnt.averaged);
  model.observations = std::move(learnt.observations);
  model.returns = std::move(learnt.returns);
}

void begin_from(const std::string& bytes, const std::string& name, const std::string& interface,
                sac::Model& model) {
  sac::Model learnt = learnt_by(bytes, name, interface, model);
  model.actor_parameters = std::move(learnt.actor_parameters);
  model.averaged = std::move(learnt.averaged);
  for (std::size_t c = 0; c < model.critics.size(); ++c) {
    model.critics[c].parameters = std::move(learnt.critics[c].parameters);
    model.critics[c].target = std::move(learnt.critics[c].target);
  }
  model.log_temperature = std::move(learnt.log_temperature);
  model.observations = std::move(learnt.observations);
  model.returns = std::move(learnt.returns);
  model.rewards = std::move(learnt.rewards);
  model.reward_scale = learnt.reward_scale;
  model.was_taught = true;
}

}  // namespace eagerx::train
