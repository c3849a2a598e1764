// A simulation of a generated graph that JavaScript steps. No threads, no files, no clock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <eagerx/float_environment.hpp>
#include <eagerx/math/rounding_check.hpp>
#include <eagerx/message.hpp>
#include <eagerx/picture.hpp>
#include <eagerx/random.hpp>
#include <eagerx/trace.hpp>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <targets/common/from_number.hpp>
#include <targets/common/last_shown.hpp>
#include <targets/common/reward_check.hpp>
#include <targets/common/run.hpp>
#include <targets/wasm/fields.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::wasm {

/// The hash of all messages and, once requested, the newest message of each channel.
template <class Graph>
class Recorder : public target::LastShown<Graph> {
 public:
  /// `values`: a row with the numbers of all channels; `first` of each channel.
  void watch(double* values, const std::size_t* first) {
    values_ = values;
    first_ = first;
  }
  std::uint64_t hash() const { return hash_.hash(); }
  void on_episode(std::uint32_t index) { hash_.on_episode(index); }
  /// Never inlined: a program has a call for each of its messages.
  template <class Message>
  [[gnu::noinline]] void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    hash_.on_message(channel, seq, message);
    if (values_ == nullptr) return;
    double* const to = values_ + first_[channel];
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      to[i] = static_cast<double>(element(message, i));
  }

 private:
  HashTrace hash_;
  double* values_ = nullptr;
  const std::size_t* first_ = nullptr;
};

/// Source of the actions: target::Agent, or numbers from JavaScript.
enum class Driver : std::uint8_t { policy, zero, random, hand };

/// The problem of this machine.
enum class Check : std::uint8_t { good, floats, flags, policy };

/// All rows are float64, so float32 and whole numbers up to 2^53 are exact.
template <class Graph>
class Simulation {
 public:
  using Program = typename Graph::template Program<Recorder<Graph>>;
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  using States = typename Graph::States;

  Fields actions, states, messages, outcome;
  /// States of the next episodes; NaN: sampled as the graph says. [numbers of the states]
  std::vector<double> settings;

  Simulation() {
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char* name, const auto& message, const auto& space) {
      actions.add<std::remove_cvref_t<decltype(message)>>(name, space);
    });
    Graph::for_each_state([&](const char* name, const char*, auto, const auto& space) {
      states.add<std::remove_cvref_t<decltype(space.low)>>(name, space);
    });
    for (const auto& channel : Graph::kChannels) {
      first_of_channel_.push_back(messages.values.size());
      messages.add(*channel.port != '\0' ? channel.port : channel.name, channel.dtype,
                   static_cast<std::size_t>(channel.size));
    }
    Outcome{}.for_each([&](const char* name, auto value) {
      outcome.add(name, target::dtype_of<decltype(value)>(), 1);
    });
    settings.assign(states.values.size(), std::numeric_limits<double>::quiet_NaN());
  }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  static Check check() {
    if (!calculates_as_everywhere()) return Check::floats;
    if (!rounds_each_operation()) return Check::flags;
    return Graph::policies_answer() ? Check::good : Check::policy;
  }

  /// JSON, valid for ever.
  const char* describe() {
    if (text_.empty()) {
      text_ = "{\"graph\": " + quoted(Graph::kName) + ", \"engine\": " + quoted(Graph::kEngine) +
              ", \"rate\": [" + std::to_string(Graph::Rate::num) + ", " +
              std::to_string(Graph::Rate::den) + "], \"agent\": " + quoted(Graph::kDefaultAgent) +
              ", \"policy\": " + (Graph::kHasPolicy ? "true" : "false") +
              ", \"steps\": " + std::to_string(target::default_plan<Graph>().steps) +
              ", \"render\": " + (target::has_render<Graph> ? "true" : "false") +
              ", \"actions\": " + actions.list() + ", \"states\": " + states.list() +
              ", \"tunable\": " + tunable() + ", \"messages\": " + messages.list() +
              ", \"outcome\": " + outcome.list() + "}";
    }
    return text_.c_str();
  }

  /// A run begins: as a program that has just been started.
  void begin(std::uint64_t seed, std::uint32_t environment, bool watched) {
    if (has_begun_) target::stop(program_);
    has_begun_ = true;
    observation_.reset();
    std::destroy_at(&program_);
    std::construct_at(&program_);
    if (watched) {
      program_.hooks.watch(messages.values.data(), first_of_channel_.data());
      program_.hooks.draw_from_now_on();
    }
    target::warm_up(program_);
    key_ = {seed, environment, 0};
    next_episode_ = 0;
    rewards_ = {};
  }

  /// The next episode begins; false if a setting is outside of its space, and then nothing happens.
  bool reset() {
    key_.episode = next_episode_;
    States sampled = Graph::sample(key_);
    if (!apply_settings(sampled)) return false;
    write(sampled);
    ++next_episode_;
    steps_ = 0;
    ended_ = false;
    program_.hooks.forget();
    program_.hooks.on_episode(key_.episode);
    observation_.emplace(program_.reset(sampled));
    write(Outcome{});
    return true;
  }

  /// Sets the parameters in `settings` that can change during an episode, before the next step;
  /// false, without any change, if one is out of its space.
  bool tune() {
    States set{};
    if (!apply_settings(set, true)) return false;
    target::tune(program_, set);
    return true;
  }

  /// At most `steps` steps, fewer if the graph's task ends the episode; how many it were.
  std::uint32_t step(Driver driver, std::uint32_t steps) {
    std::uint32_t done = 0;
    if (!observation_) return done;
    for (; done < steps && !ended_; ++done) {
      const Action wanted = driver == Driver::hand ? hand() : act(driver);
      Action action = target::guarded(program_, wanted, 0);
      observation_.emplace(target::apply(program_, action));
      ++steps_;
      const Outcome result = target::outcome_of<Graph>(program_);
      rewards_.step(result);
      ended_ = target::has_ended(result);
      if (done + 1 < steps && !ended_) continue;
      write(action);
      write(result);
    }
    return done;
  }

  bool ended() const { return ended_; }
  std::uint64_t hash() { return program_.hooks.hash(); }

  /// [height][width][4], with the last one 255; null if there is no such picture.
  const std::uint8_t* picture(std::uint32_t width, std::uint32_t height) {
    if constexpr (target::has_render<Graph>) {
      static constinit picture::Painter<target::kWidestPicture, 384, target::kMostShapes> painter{};
      if (width == 0 || height == 0 || width > kWidest || height > kWidest) return nullptr;
      const std::size_t count = std::size_t{width} * height;
      pixels_.resize(4 * count);
      program_.hooks.paint(painter,
                           {pixels_.data(), static_cast<int>(width), static_cast<int>(height), 3});
      // From the end, because four take more room than three.
      for (std::size_t i = count; i-- > 0;) {
        for (std::size_t c = 3; c-- > 0;) pixels_[4 * i + c] = pixels_[3 * i + c];
        pixels_[4 * i + 3] = std::numeric_limits<std::uint8_t>::max();
      }
      return pixels_.data();
    } else {
      return static_cast<void>(width), static_cast<void>(height), nullptr;
    }
  }

  /// JSON of the nonzero counts. Valid until the next call.
  const char* counts() {
    counts_.clear();
    const auto add = [&](const char* name, std::uint64_t count) {
      if (count == 0) return;
      counts_ += (counts_.empty() ? "" : ", ") + quoted(name) + ": " + std::to_string(count);
    };
    target::for_each_fault(program_, add);
    rewards_.for_each_count(add);
    counts_ = "{" + counts_ + "}";
    return counts_.c_str();
  }

 private:
  using Outcome = typename target::OutcomeOf<Graph>::Type;
  static constexpr std::uint32_t kWidest = 2048;  // pixels

  /// A list of names.
  static std::string tunable() {
    std::string names;
    std::size_t state = 0;
    Graph::for_each_state([&](const char* name, const char*, auto, const auto&) {
      if (target::is_tunable<Graph>(state++)) names += (names.empty() ? "" : ", ") + quoted(name);
    });
    return "[" + names + "]";
  }

  Action act(Driver driver) {
    const target::Agent agent = driver == Driver::policy   ? target::Agent::policy
                                : driver == Driver::random ? target::Agent::random
                                                           : target::Agent::zero;
    return target::act<Graph>(agent, key_, steps_, *observation_, program_);
  }

  Action hand() const {
    Action action = Graph::zero();
    const double* from = actions.values.data();
    Graph::for_each_action(action, [&](const char*, auto& message, const auto&) {
      using Message = std::remove_cvref_t<decltype(message)>;
      for (std::size_t i = 0; i < size_of<Message>; ++i)
        element(message, i) = target::from_number<ScalarOf<Message>>(*from++);
    });
    return action;
  }

  bool apply_settings(States& to, bool only_tunable = false) const {
    for (std::size_t i = 0; i < settings.size(); ++i) {
      // NaN is no setting, and passes both.
      if (settings[i] < states.low[i] || settings[i] > states.high[i]) return false;
    }
    const double* from = settings.data();
    std::size_t state = 0;
    Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(to.*member)>::value_type;
      // While an episode runs, all numbers of one are set, or none.
      const bool skipped = only_tunable && (!target::is_tunable<Graph>(state++) ||
                                            std::any_of(from, from + size_of<Message>,
                                                        [](double x) { return x != x; }));
      for (std::size_t i = 0; i < size_of<Message>; ++i, ++from) {
        if (skipped || *from != *from) continue;
        if (!(to.*member)) to.*member = Message{};
        element(*(to.*member), i) = target::from_number<ScalarOf<Message>>(*from);
      }
    });
    return true;
  }

  /// NaN for empty states.
  void write(const States& from) {
    double* to = states.values.data();
    Graph::for_each_state([&](const char*, const char*, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(from.*member)>::value_type;
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        *to++ = from.*member ? static_cast<double>(element(*(from.*member), i))
                             : std::numeric_limits<double>::quiet_NaN();
      }
    });
  }
  void write(Action action) {
    double* to = actions.values.data();
    Graph::for_each_action(action, [&](const char*, const auto& message, const auto&) {
      for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i)
        *to++ = static_cast<double>(element(message, i));
    });
  }
  void write(const Outcome& from) {
    double* to = outcome.values.data();
    from.for_each([&](const char*, auto value) { *to++ = static_cast<double>(value); });
  }

  std::vector<std::size_t> first_of_channel_;
  std::vector<std::uint8_t> pixels_;
  std::string text_, counts_;
  Program program_{};
  std::optional<Observation> observation_;  // its windows lie in the program
  EpisodeKey key_{};
  std::uint32_t next_episode_ = 0;
  std::uint64_t steps_ = 0;  // of the episode
  target::RewardCheck<Outcome> rewards_;
  bool has_begun_ = false, ended_ = false;
};

}  // namespace eagerx::wasm
