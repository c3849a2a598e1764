#include "targets/environments/train/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/renamed.hpp>
#include <stdexcept>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/client/words.hpp"
#include "targets/environments/options/train_settings.hpp"
#include "targets/environments/train/simd.hpp"

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
      layers_at("net_arch", &S::net_arch),
      word_at("activation_fn", &S::activation_fn, {Activation::tanh, Activation::relu}),
      word_at("rnn", &S::rnn),
      number_at("rnn_hidden_size", &S::rnn_hidden_size),
      number_at("bptt_steps", &S::bptt_steps),
      number_at("gamma", &S::gamma),
      number_at("gae_lambda", &S::gae_lambda),
      number_at("n_envs", &S::n_envs),
      truth_at("stagger", &S::stagger),
      number_at("n_steps", &S::n_steps),
      number_at("max_n_steps", &S::max_n_steps),
      number_at("n_minibatches", &S::n_minibatches),
      number_at("n_epochs", &S::n_epochs),
      number_at("clip_range", &S::clip_range),
      number_at("ent_coef", &S::ent_coef),
      number_at("max_grad_norm", &S::max_grad_norm),
      number_at("learning_rate", &S::learning_rate),
      word_at("schedule", &S::schedule),
      number_at("min_learning_rate", &S::min_learning_rate),
      number_at("max_learning_rate", &S::max_learning_rate),
      number_at("target_kl", &S::target_kl),
      number_at("kl_stop_factor", &S::kl_stop_factor),
      number_at("decay_steps", &S::decay_steps),
      number_at("initial_std", &S::initial_std),
      number_at("min_std", &S::min_std),
      number_at("max_std", &S::max_std),
      number_at("std_learning_rate_ratio", &S::std_learning_rate_ratio),
      number_at("sac_n_envs", &sac::Settings::n_envs),
      number_at("train_freq", &sac::Settings::train_freq),
      number_at("batch_size", &sac::Settings::batch_size),
      number_at("utd_ratio", &sac::Settings::utd_ratio),
      number_at("buffer_size", &sac::Settings::buffer_size),
      number_at("learning_starts", &sac::Settings::learning_starts),
      number_at("tau", &sac::Settings::tau),
      number_at("sac_ema_rate", &sac::Settings::ema_rate),
      number_at("initial_ent_coef", &sac::Settings::initial_ent_coef),
      number_at("target_entropy_per_action", &sac::Settings::target_entropy_per_action),
      number_at("reward_scale", &sac::Settings::reward_scale),
      number_at("norm_window_steps", &sac::Settings::norm_window_steps),
      truth_at("norm_obs", &S::norm_obs),
      number_at("freeze_after", &S::freeze_after),
      number_at("ema_decay", &S::ema_decay),
      number_at("ema_window_fraction", &S::ema_window_fraction),
      number_at("failure_replay_fraction", &S::failure_replay_fraction),
      number_at("eval_interval", &S::eval_interval),
      number_at("n_eval_episodes", &S::n_eval_episodes),
      number_at("target_success_rate", &S::target_success_rate),
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

/// Names of CleanRL, rsl_rl, Spinning Up and others, and ours for the same.
constexpr auto kOtherNames = std::to_array<std::array<std::string_view, 2>>({
    {"lr", "learning_rate"},
    {"alpha_lr", "learning_rate"},
    {"lambda", "gae_lambda"},
    {"lam", "gae_lambda"},
    {"num_envs", "n_envs"},
    {"num_steps", "n_steps"},
    {"update_epochs", "n_epochs"},
    {"num_minibatches", "n_minibatches"},
    {"clip_coef", "clip_range"},
    {"clip_param", "clip_range"},
    {"entropy_coef", "ent_coef"},
    {"desired_kl", "target_kl"},
    {"hidden_sizes", "net_arch"},
    {"gradient_steps", "utd_ratio"},
    {"target_entropy", "target_entropy_per_action"},
});

/// Names of what has an option of its own.
constexpr auto kOptions = std::to_array<std::array<std::string_view, 2>>({
    {"seed", "seed N"},
    {"algo", "algorithm NAME"},
    {"algorithm", "algorithm NAME"},
    {"preset", "preset NAME"},
    {"steps", "steps N"},
    {"total_timesteps", "steps N"},
    {"num_threads", "threads N"},
    {"n_threads", "threads N"},
    {"tensorboard_log", "tensorboard DIR"},
});

std::string help_with(std::string_view name) {
  constexpr const char* kAll = "`eagerx-gen help train-settings` lists them";
  if (const std::string renamed = host::help_for_renamed(host::kTrainSettings, name);
      !renamed.empty())
    return renamed;
  for (const auto& [theirs, option] : kOptions)
    if (theirs == name) return fmt::format("it is an option: `--{}`", option);
  for (const auto& [theirs, ours] : kOtherNames)
    if (theirs == name) return fmt::format("it is `{}` here; {}", ours, kAll);
  std::vector<std::string> known;
  for (const Setting& row : kTrainSettings) known.emplace_back(row.name);
  const std::string near = host::did_you_mean(name, known);
  return near.empty() ? kAll : fmt::format("{} {}", near, kAll);
}

}  // namespace

Settings::Settings() {
  for (const Setting& row : kTrainSettings) place_of(row).set(*this, row, row.otherwise);
}

void set(Settings& settings, std::string_view name, const std::string& text) {
  const auto* row = std::ranges::find(kTrainSettings, name, &Setting::name);
  if (row == std::end(kTrainSettings))
    throw client::Problem(client::kUsage, fmt::format("there is no setting `{}`", name),
                          help_with(name));
  place_of(*row).set(settings, *row, text);
}

void check(const Settings& settings) {
  constexpr std::size_t kRow = kParts * kLanes;
  const std::size_t samples = settings.n_envs * settings.n_steps;
  const bool is_few = kRow % settings.n_envs == 0;
  if (!is_few && settings.n_envs % kRow != 0)
    refuse_settings({"n_envs"},
                    fmt::format("n_envs: {} is neither 8, 16, 32, 64 nor a multiple of {}",
                                settings.n_envs, kRow));
  if (settings.sac.batch_size % kRow != 0)
    refuse_settings({"batch_size"}, fmt::format("batch_size: {} is not a multiple of {}",
                                                settings.sac.batch_size, kRow));
  const bool remembers = settings.rnn != Memory::none;
  const std::size_t steps = remembers ? settings.bptt_steps : 1;
  if (settings.n_steps % steps != 0)
    refuse_settings(
        {"n_steps", "bptt_steps"},
        fmt::format("n_steps: {} is not a multiple of bptt_steps, {}", settings.n_steps, steps));
  if (samples % (kRow * steps) != 0)
    refuse_settings({"n_steps", "n_envs", "bptt_steps"},
                    fmt::format("n_steps: {} of {} environments are {} steps, no multiple of {}{}",
                                settings.n_steps, settings.n_envs, samples, kRow,
                                remembers ? " * bptt_steps" : ""));
  if (settings.min_std > settings.max_std)
    refuse_settings({"min_std", "max_std"}, "min_std is more than max_std");
  if (settings.initial_std < settings.min_std)
    refuse_settings({"initial_std", "min_std"},
                    fmt::format("initial_std: {} is less than min_std, {}", settings.initial_std,
                                settings.min_std));
  if (settings.initial_std > settings.max_std)
    refuse_settings({"initial_std", "max_std"},
                    fmt::format("initial_std: {} is more than max_std, {}", settings.initial_std,
                                settings.max_std));
  if (settings.min_learning_rate > settings.max_learning_rate)
    refuse_settings({"min_learning_rate", "max_learning_rate"},
                    "min_learning_rate is more than max_learning_rate");
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

std::string with_new_names(std::string_view text) {
  std::string result;
  for (std::string_view part : client::pieces_of(text, ';')) {
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    const std::string_view name = part.substr(0, part.find(' '));
    const std::string_view now = host::new_name(host::kTrainSettings, name);
    result += fmt::format("{}{}{}", result.empty() ? "" : "; ", now.empty() ? name : now,
                          part.substr(name.size()));
  }
  return result;
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
