#include "targets/environments/train/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/number.hpp>
#include <stdexcept>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/client/words.hpp"
#include "targets/environments/options/train_settings.hpp"
#include "targets/environments/train/packs.hpp"

namespace eagerx::train {
namespace {

using client::refuse;
using options::kTrainSettings;
using options::Setting;

/// Where a setting's value is kept.
struct Place {
  std::string_view name;
  std::function<void(Settings&, const Setting&, const std::string&)> set;
  std::function<std::string(const Settings&)> text;
};

template <class T>
Place number_at(std::string_view name, T Settings::*member) {
  return {name,
          [member](Settings& settings, const Setting& row, const std::string& text) {
            settings.*member =
                client::number<T>(text, static_cast<T>(row.low), static_cast<T>(row.high));
          },
          [member](const Settings& settings) { return fmt::format("{}", settings.*member); }};
}

/// Of SAC.
template <class T>
Place number_at(std::string_view name, T sac::Settings::*member) {
  return {name,
          [member](Settings& settings, const Setting& row, const std::string& text) {
            settings.sac.*member =
                client::number<T>(text, static_cast<T>(row.low), static_cast<T>(row.high));
          },
          [member](const Settings& settings) { return fmt::format("{}", settings.sac.*member); }};
}

/// `values`: what the words of the row mean, in their order; empty: 0, 1, ….
template <class T>
Place word_at(std::string_view name, T Settings::*member, std::vector<T> values = {}) {
  const auto words = [](const Setting& row) { return client::pieces_of(row.words, ','); };
  return {name,
          [=](Settings& settings, const Setting& row, const std::string& text) {
            const auto known = words(row);
            const auto found = std::ranges::find(known, text);
            if (found == known.end())
              refuse(fmt::format("`{}` is none of {}", text, fmt::join(known, ", ")));
            const auto place = static_cast<std::size_t>(found - known.begin());
            settings.*member = values.empty() ? static_cast<T>(place) : values.at(place);
          },
          [=](const Settings& settings) {
            const auto* row = std::ranges::find(kTrainSettings, name, &Setting::name);
            const auto found = std::ranges::find(values, settings.*member);
            return std::string(
                words(*row)[values.empty() ? static_cast<std::size_t>(settings.*member)
                                           : static_cast<std::size_t>(found - values.begin())]);
          }};
}

Place truth_at(std::string_view name, bool Settings::*member) {
  return {name,
          [member](Settings& settings, const Setting& /*row*/, const std::string& text) {
            if (text != "true" && text != "false")
              refuse(fmt::format("`{}` is neither true nor false", text));
            settings.*member = text == "true";
          },
          [member](const Settings& settings) {
            return std::string(settings.*member ? "true" : "false");
          }};
}

Place layers_at(std::string_view name, std::vector<std::size_t> Settings::*member) {
  return {name,
          [member](Settings& settings, const Setting& row, const std::string& text) {
            std::vector<std::size_t> widths;
            for (const std::string_view width : client::pieces_of(text, ','))
              widths.push_back(client::number<std::size_t>(width, static_cast<std::size_t>(row.low),
                                                           static_cast<std::size_t>(row.high)));
            if (widths.size() > options::kMostLayers)
              refuse(fmt::format("there are at most {} layers", options::kMostLayers));
            settings.*member = std::move(widths);
          },
          [member](const Settings& settings) {
            return fmt::format("{}", fmt::join(settings.*member, ","));
          }};
}

const std::vector<Place>& places() {
  using S = Settings;
  static const std::vector<Place> all = {
      layers_at("layers", &S::layers),
      word_at("activation", &S::activation, {Activation::tanh, Activation::relu}),
      word_at("memory", &S::memory),
      number_at("memory_units", &S::memory_units),
      number_at("memory_steps", &S::memory_steps),
      number_at("discount", &S::discount),
      number_at("trace_decay", &S::trace_decay),
      number_at("environments", &S::environments),
      truth_at("stagger", &S::stagger),
      number_at("horizon", &S::horizon),
      number_at("most_horizon", &S::most_horizon),
      number_at("minibatches", &S::minibatches),
      number_at("epochs", &S::epochs),
      number_at("clip", &S::clip),
      number_at("entropy", &S::entropy),
      number_at("gradient_norm", &S::gradient_norm),
      number_at("learning_rate", &S::learning_rate),
      word_at("schedule", &S::schedule),
      number_at("least_learning_rate", &S::least_learning_rate),
      number_at("most_learning_rate", &S::most_learning_rate),
      number_at("divergence", &S::divergence),
      number_at("stop_divergence", &S::stop_divergence),
      number_at("decay_steps", &S::decay_steps),
      number_at("first_deviation", &S::first_deviation),
      number_at("least_deviation", &S::least_deviation),
      number_at("most_deviation", &S::most_deviation),
      number_at("deviation_rate", &S::deviation_rate),
      number_at("sac_environments", &sac::Settings::environments),
      number_at("sac_horizon", &sac::Settings::horizon),
      number_at("sac_batch", &sac::Settings::batch),
      number_at("sac_updates", &sac::Settings::updates),
      number_at("sac_memory", &sac::Settings::memory),
      number_at("sac_random_steps", &sac::Settings::random_steps),
      number_at("sac_target_share", &sac::Settings::target_share),
      number_at("sac_averaging", &sac::Settings::averaging),
      number_at("sac_first_temperature", &sac::Settings::first_temperature),
      number_at("sac_entropy", &sac::Settings::entropy),
      number_at("sac_reward_scale", &sac::Settings::reward_scale),
      number_at("sac_scale_steps", &sac::Settings::scale_steps),
      truth_at("normalise", &S::normalise),
      number_at("freeze_after", &S::freeze_after),
      number_at("averaging", &S::averaging),
      number_at("averaging_share", &S::averaging_share),
      number_at("hard_share", &S::hard_share),
      number_at("evaluation_every", &S::evaluation_every),
      number_at("evaluation_episodes", &S::evaluation_episodes),
      number_at("success_share", &S::success_share),
  };
  return all;
}

/// Each row has one place, in the same order: else it is a bug of this program.
const Place& place_of(const Setting& row) {
  const auto found = std::ranges::find(places(), row.name, &Place::name);
  if (found == places().end()) throw std::logic_error(row.name);
  return *found;
}

[[noreturn]] void refuse_settings(
    std::vector<std::string> about, const std::string& what,
    std::string help = "`eagerx-gen help train-settings` lists settings and ranges") {
  client::Problem problem(client::kUsage, what, std::move(help));
  problem.about = std::move(about);
  throw problem;
}

}  // namespace

Settings::Settings() {
  for (const Setting& row : kTrainSettings) place_of(row).set(*this, row, row.otherwise);
}

namespace {

/// Names of Stable-Baselines3, CleanRL and others, and ours for the same.
constexpr std::array<std::array<std::string_view, 2>, 29> kOtherNames = {
    {{"lr", "learning_rate"},
     {"alpha_lr", "learning_rate"},
     {"gamma", "discount"},
     {"gae_lambda", "trace_decay"},
     {"lambda", "trace_decay"},
     {"lam", "trace_decay"},
     {"n_envs", "environments"},
     {"num_envs", "environments"},
     {"n_steps", "horizon"},
     {"num_steps", "horizon"},
     {"n_epochs", "epochs"},
     {"update_epochs", "epochs"},
     {"num_minibatches", "minibatches"},
     {"n_minibatches", "minibatches"},
     {"clip_range", "clip"},
     {"clip_coef", "clip"},
     {"clip_param", "clip"},
     {"ent_coef", "entropy"},
     {"entropy_coef", "entropy"},
     {"max_grad_norm", "gradient_norm"},
     {"target_kl", "divergence"},
     {"desired_kl", "divergence"},
     {"net_arch", "layers"},
     {"hidden_sizes", "layers"},
     {"buffer_size", "sac_memory"},
     {"tau", "sac_target_share"},
     {"learning_starts", "sac_random_steps"},
     {"gradient_steps", "sac_updates"},
     {"target_entropy", "sac_entropy"}}};

std::string help_with(std::string_view name) {
  constexpr const char* kAll = "`eagerx-gen help train-settings` lists them";
  const auto lists = [&](std::string_view ours) {
    return std::ranges::find(kTrainSettings, ours, &Setting::name) != std::end(kTrainSettings);
  };
  for (const auto& [theirs, ours] : kOtherNames)
    if (theirs == name && lists(ours)) return fmt::format("it is `{}` here; {}", ours, kAll);
  if (name == "batch_size")
    return fmt::format(
        "of PPO it follows from `environments`, `horizon` and `minibatches`, of SAC it is "
        "`sac_batch`; {}",
        kAll);
  std::vector<std::string> known;
  for (const Setting& row : kTrainSettings) known.emplace_back(row.name);
  const std::string near = host::did_you_mean(name, known);
  return near.empty() ? kAll : fmt::format("{} {}", near, kAll);
}

}  // namespace

void set(Settings& settings, std::string_view name, const std::string& text) {
  const auto* row = std::ranges::find(kTrainSettings, name, &Setting::name);
  if (row == std::end(kTrainSettings))
    throw client::Problem(client::kUsage, fmt::format("there is no setting `{}`", name),
                          help_with(name));
  place_of(*row).set(settings, *row, text);
}

void check(const Settings& settings) {
  constexpr std::size_t kRow = kParts * kLanes;
  const std::size_t samples = settings.environments * settings.horizon;
  const bool is_few = kRow % settings.environments == 0;
  if (!is_few && settings.environments % kRow != 0)
    refuse_settings({"environments"},
                    fmt::format("environments: {} is neither 8, 16, 32, 64 nor a multiple of {}",
                                settings.environments, kRow));
  if (settings.sac.batch % kRow != 0)
    refuse_settings({"sac_batch"},
                    fmt::format("sac_batch: {} is no multiple of {}", settings.sac.batch, kRow));
  const bool remembers = settings.memory != Memory::none;
  const std::size_t steps = remembers ? settings.memory_steps : 1;
  if (settings.horizon % steps != 0)
    refuse_settings(
        {"horizon", "memory_steps"},
        fmt::format("horizon: {} is no multiple of memory_steps, {}", settings.horizon, steps));
  if (samples % (kRow * steps) != 0)
    refuse_settings({"horizon", "environments", "memory_steps"},
                    fmt::format("horizon: {} of {} environments are {} steps, no multiple of {}{}",
                                settings.horizon, settings.environments, samples, kRow,
                                remembers ? " * memory_steps" : ""));
  if (settings.least_deviation > settings.most_deviation)
    refuse_settings({"least_deviation", "most_deviation"},
                    "least_deviation is more than most_deviation");
  if (settings.first_deviation < settings.least_deviation)
    refuse_settings({"first_deviation", "least_deviation"},
                    fmt::format("first_deviation: {} is less than least_deviation, {}",
                                settings.first_deviation, settings.least_deviation));
  if (settings.first_deviation > settings.most_deviation)
    refuse_settings({"first_deviation", "most_deviation"},
                    fmt::format("first_deviation: {} is more than most_deviation, {}",
                                settings.first_deviation, settings.most_deviation));
  if (settings.least_learning_rate > settings.most_learning_rate)
    refuse_settings({"least_learning_rate", "most_learning_rate"},
                    "least_learning_rate is more than most_learning_rate");
}

void check_algorithm(const Settings& settings, std::string_view name) {
  const auto* row = std::ranges::find(kTrainSettings, name, &Setting::name);
  if (row == std::end(kTrainSettings) || *row->algorithm == '\0' ||
      row->algorithm == settings.algorithm)
    return;
  refuse_settings({std::string(name)},
                  fmt::format("{} is a setting of {}, and the algorithm is {}", name,
                              row->algorithm, settings.algorithm),
                  fmt::format("leave it out, or train with `--algorithm {}`", row->algorithm));
}

std::string text_of(const Settings& settings) {
  std::string text;
  for (const Setting& row : kTrainSettings)
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : "; ", row.name, place_of(row).text(settings));
  return text;
}

std::vector<Difference> differences(std::string_view theirs, std::string_view ours) {
  const auto a = client::pieces_of(theirs, ';'), b = client::pieces_of(ours, ';');
  std::vector<Difference> all;
  const auto name = [](std::string_view part) {
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    return part.substr(0, part.find(' '));
  };
  const auto value = [](std::string_view part) {
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    const std::size_t blank = part.find(' ');
    return blank == std::string_view::npos ? std::string_view() : part.substr(blank + 1);
  };
  for (const std::string_view one : a) {
    const auto other = std::ranges::find(b, name(one), name);
    if (other == b.end()) {
      all.push_back({std::string(name(one)),
                     fmt::format("{} {} (here there is none)", name(one), value(one))});
    } else if (value(*other) != value(one)) {
      all.push_back({std::string(name(one)),
                     fmt::format("{} {} (here {})", name(one), value(one), value(*other))});
    }
  }
  for (const std::string_view one : b) {
    if (std::ranges::find(a, name(one), name) == a.end())
      all.push_back(
          {std::string(name(one)), fmt::format("no {} (here {})", name(one), value(one))});
  }
  return all;
}

std::string text_of(const std::vector<Difference>& differences) {
  std::vector<std::string> texts;
  texts.reserve(differences.size());
  for (const Difference& one : differences) texts.push_back(one.text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string difference(std::string_view theirs, std::string_view ours) {
  return text_of(differences(theirs, ours));
}

}  // namespace eagerx::train
