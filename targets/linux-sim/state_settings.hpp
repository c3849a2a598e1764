// --set: values of states for this run, in place of the graph's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/draw.hpp>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>
#include <eagerx/space.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::linux_sim {

/// One `NAME=VALUE`, `NAME=VALUE,VALUE,…` or `NAME=DISTRIBUTION:NUMBER,NUMBER,…`.
struct StateSetting {
  enum class Kind : std::uint8_t { value, uniform, log_uniform, normal, choice };
  std::string name;  // "pendulum.mass"
  Kind kind = Kind::value;
  std::vector<double> numbers;
  std::string written;  // the text behind `=`

  /// For elements beyond the last number, the first group again.
  double number(std::size_t group, std::size_t i) const {
    const std::size_t size = numbers.size() / groups();
    return numbers[group * size + (size == 1 ? 0 : i)];
  }
  /// Lists that the numbers are: low and high, mean and std; else one.
  std::size_t groups() const { return kind == Kind::value || kind == Kind::choice ? 1 : 2; }
};

/// nullopt if the text is none of the forms.
std::optional<StateSetting> parse_setting(std::string_view text);

/// What a program says of a state that it does not have.
std::string unknown_state(const std::string& name, const std::vector<std::string>& known);
/// The problem with the numbers for a state of `size` elements within [low[i], high[i]], or
/// nothing.
std::string problem_of(const StateSetting& setting, const std::vector<double>& low,
                       const std::vector<double>& high);

/// The settings of a run for the states of a graph.
template <class Graph>
class StateSettings {
 public:
  using States = typename Graph::States;

  /// What is wrong with `texts`, or nothing.
  std::string read(const std::vector<std::string>& texts) {
    std::vector<std::string> known;
    Graph::for_each_state([&](const char* name, const auto&...) { known.emplace_back(name); });
    settings_.resize(known.size());
    for (const std::string& text : texts) {
      std::optional<StateSetting> setting = parse_setting(text);
      if (!setting) {
        return "error: `" + text +
               "` is no setting\nhelp: write NAME=NUMBER, NAME=NUMBER,NUMBER,… (one for each "
               "element), or NAME=uniform:LOW,HIGH, log_uniform:LOW,HIGH, normal:MEAN,STD, "
               "choice:NUMBER,NUMBER,…";
      }
      std::size_t index = 0;
      std::string problem = unknown_state(setting->name, known);
      Graph::for_each_state(
          [&](const char* name, const char* /*id*/, auto /*member*/, const auto& space) {
            if (setting->name == name) {
              problem = problem_of(*setting, bounds(space.low), bounds(space.high));
              settings_[index] = setting;
            }
            ++index;
          });
      if (!problem.empty()) return problem;
    }
    return {};
  }

  /// Puts what is set into `states`, as the graph's own draws would be: the same numbers for the
  /// same key. Does not allocate.
  void apply(EpisodeKey key, States& states) const {
    if (settings_.empty()) return;
    std::size_t index = 0;
    Graph::for_each_state(
        [&](const char* /*name*/, const char* id, auto member, const auto& space) {
          const auto& setting = settings_[index++];
          if (setting) states.*member = drawn(*setting, key, id, space);
        });
  }

 private:
  template <class Message>
  static std::vector<double> bounds(const Message& message) {
    std::vector<double> result;
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      result.push_back(static_cast<double>(element(message, i)));
    return result;
  }

  template <class Message>
  static Message message_of(const StateSetting& setting, std::size_t group) {
    Message message{};
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      element(message, i) = static_cast<ScalarOf<Message>>(setting.number(group, i));
    return message;
  }

  template <class Message>
  static Message drawn(const StateSetting& setting, EpisodeKey key, const char* id,
                       const Space<Message>& space) {
    Random random(key, entity_id(id));
    switch (setting.kind) {
      case StateSetting::Kind::uniform:
        return Space<Message>{message_of<Message>(setting, 0), message_of<Message>(setting, 1)}
            .sample(random);
      case StateSetting::Kind::log_uniform:
        if constexpr (std::is_floating_point_v<ScalarOf<Message>>) {
          return draw_log_uniform(random, message_of<Message>(setting, 0),
                                  message_of<Message>(setting, 1));
        }
        break;
      case StateSetting::Kind::normal:
        if constexpr (std::is_floating_point_v<ScalarOf<Message>>) {
          return space.clipped(draw_normal(random, message_of<Message>(setting, 0),
                                           message_of<Message>(setting, 1)));
        }
        break;
      case StateSetting::Kind::choice: {
        const auto chosen = random.below(static_cast<std::uint32_t>(setting.numbers.size()));
        return filled<Message>(static_cast<ScalarOf<Message>>(setting.numbers[chosen]));
      }
      case StateSetting::Kind::value:
        break;
    }
    return message_of<Message>(setting, 0);
  }

  std::vector<std::optional<StateSetting>> settings_;  // by the order of for_each_state()
};

}  // namespace eagerx::linux_sim
