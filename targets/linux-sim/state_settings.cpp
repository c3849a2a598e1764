#include <algorithm>
#include <array>
#include <cmath>
#include <eagerx/space.hpp>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/number.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/say.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <type_traits>

namespace eagerx::linux_sim {
namespace {

using Kind = StateSetting::Kind;

struct Form {
  std::string_view prefix;
  Kind kind;
};
constexpr std::array kForms{Form{"uniform:", Kind::uniform},
                            Form{"log_uniform:", Kind::log_uniform}, Form{"normal:", Kind::normal},
                            Form{"choice:", Kind::choice}};

bool read_numbers(std::string_view text, std::vector<double>& numbers) {
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    double value = 0.0;
    if (!host::read_number(text.substr(0, comma), value) || !std::isfinite(value)) return false;
    numbers.push_back(value);
    if (comma == text.size()) return true;
    text.remove_prefix(comma + 1);
  }
}

std::string about(const StateSetting& setting) {
  return "error: `" + setting.name + "=" + setting.written + "`: ";
}

bool is_within(double x, double low, double high) {
  // A decimal may round to a neighboring float.
  return (x >= low && x <= high) || static_cast<float>(x) == static_cast<float>(low) ||
         static_cast<float>(x) == static_cast<float>(high);
}

}  // namespace

std::optional<StateSetting> parse_setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos) return std::nullopt;
  StateSetting setting;
  setting.name = text.substr(0, equals);
  std::string_view value = text.substr(equals + 1);
  setting.written = value;
  for (const Form& form : kForms) {
    if (!value.starts_with(form.prefix)) continue;
    setting.kind = form.kind;
    value.remove_prefix(form.prefix.size());
    break;
  }
  if (const std::size_t at = value.find('@'); at != std::string_view::npos) {
    if (setting.kind != Kind::value ||
        !host::read_number(value.substr(at + 1), setting.step.emplace()))
      return std::nullopt;
    value = value.substr(0, at);
  }
  if (!read_numbers(value, setting.numbers)) return std::nullopt;
  return setting;
}

std::string unknown_state(const std::string& name, const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& state : known) list += (list.empty() ? "" : ", ") + state;
  const std::string near = host::did_you_mean(name, known);
  return "error: this program has no state `" + name + "`\nhelp: " + near +
         (near.empty() ? "" : " ") + (known.empty() ? "it has none" : "it has " + list) +
         "; others are named under `states:` in the graph, and parameters of nodes under "
         "`tunable:`. What else is under `config:` is compiled into the program: change it in the "
         "graph";
}

std::string problem_of(const StateSetting& setting, const std::vector<double>& low,
                       const std::vector<double>& high) {
  const std::size_t size = low.size();
  const std::size_t given = setting.numbers.size() / setting.groups();
  const bool fits = setting.numbers.size() % setting.groups() == 0 && given >= 1 &&
                    (given == 1 || given == size || setting.kind == Kind::choice);
  if (!fits) {
    const std::string two = setting.groups() == 2 ? "2, or 2 for each element: " : "1, or ";
    return about(setting) + "there are " + std::to_string(setting.numbers.size()) +
           " numbers\nhelp: it takes " + two + std::to_string(setting.groups() * size) + " of them";
  }
  const bool log = setting.kind == Kind::log_uniform;
  for (std::size_t i = 0; i < std::max(size, setting.numbers.size()); ++i) {
    const std::size_t at = std::min(i, size - 1);
    const bool ordered = setting.kind == Kind::uniform || log;
    if (ordered && i < size && setting.number(0, i) > setting.number(1, i))
      return about(setting) + "the lower bound is above the upper one";
    if (log && i < size && setting.number(0, i) <= 0.0)
      return about(setting) + "the logarithm needs bounds above 0";
    if (setting.kind == Kind::normal) {
      if (i < size && setting.number(1, i) < 0.0)
        return about(setting) + "the deviation is below 0";
      continue;  // what is sampled is moved into the space
    }
    for (std::size_t group = 0; group < setting.groups(); ++group) {
      const double x = setting.kind == Kind::choice ? setting.numbers[std::min(i, given - 1)]
                       : i < size                   ? setting.number(group, i)
                                                    : low[at];
      if (is_within(x, low[at], high[at])) continue;
      return about(setting) + host::number_text(x) + " is out of the space of the state, from " +
             host::number_text(static_cast<float>(low[at])) + " to " +
             host::number_text(static_cast<float>(high[at])) +
             "\nhelp: a wider one is written in the graph: `states: {…: {uniform: space, space: "
             "{low: "
             "…, high: …}}}`";
    }
  }
  return {};
}

namespace {

std::vector<double> numbers_of(const Field& field, const void* message) {
  std::vector<double> result;
  for (std::size_t i = 0; i < field.type.size; ++i)
    result.push_back(number_of(field.type.scalar, message, i));
  return result;
}

/// Element after element, as Space::sample() and sample.hpp sample messages.
template <class T>
void sample(const StateSetting& setting, EpisodeKey key, const Field& field, T* elements) {
  Random random(key, entity_id(field.id));
  const std::size_t size = field.type.size;
  const auto number = [&](std::size_t group, std::size_t i) {
    return static_cast<T>(setting.number(group, i));
  };
  if (setting.kind == Kind::choice) {
    const auto chosen = random.below(static_cast<std::uint32_t>(setting.numbers.size()));
    std::fill_n(elements, size, static_cast<T>(setting.numbers[chosen]));
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    T& x = elements[i];
    x = number(0, i);
    if (setting.kind == Kind::uniform) x = random.uniform(number(0, i), number(1, i));
    if constexpr (std::is_floating_point_v<T>) {
      if (setting.kind == Kind::log_uniform) x = random.log_uniform(number(0, i), number(1, i));
      if (setting.kind == Kind::normal) {
        const T low = static_cast<const T*>(field.low)[i];
        const T high = static_cast<const T*>(field.high)[i];
        x = Space<T>{low, high}.clipped(random.normal(number(0, i), number(1, i)));
      }
    }
  }
}

}  // namespace

std::string StateSettings::read(const std::vector<std::string>& texts) {
  std::vector<std::string> known;
  for (const Field& state : states_) known.emplace_back(state.name);
  if (!texts.empty()) settings_.resize(known.size());
  for (const std::string& text : texts) {
    std::optional<StateSetting> setting = parse_setting(text);
    if (!setting) {
      return "error: `" + text +
             "` is not a setting\nhelp: write NAME=NUMBER, NAME=NUMBER,NUMBER,… (one for each "
             "element), or NAME=uniform:LOW,HIGH, log_uniform:LOW,HIGH, normal:MEAN,STD, "
             "choice:NUMBER,NUMBER,…; a parameter while it runs: NAME=NUMBER@STEP";
    }
    auto found = std::find(known.begin(), known.end(), setting->name);
    const std::string* const spelled =
        found == known.end() ? host::name_meant(setting->name, known) : nullptr;
    if (spelled != nullptr) {
      say_other_spelling(setting->name, *spelled);
      setting->name = *spelled;
      found = known.begin() + (spelled - known.data());
    }
    if (found == known.end()) return unknown_state(setting->name, known);
    const auto index = static_cast<std::size_t>(found - known.begin());
    const Field& state = states_[index];
    std::string problem =
        problem_of(*setting, numbers_of(state, state.low), numbers_of(state, state.high));
    if (!problem.empty()) return problem;
    if (!setting->step) {
      settings_[index] = std::move(setting);
    } else if (state.tunable) {
      running_.push_back({index, std::move(*setting)});
    } else {
      return not_tunable(*setting);
    }
  }
  return {};
}

std::string StateSettings::not_tunable(const StateSetting& setting) const {
  std::string list;
  for (const Field& state : states_)
    if (state.tunable) list += (list.empty() ? "" : ", ") + std::string(state.name);
  return about(setting) + "`" + setting.name +
         "` can be set at a reset, not while an episode runs" + "\nhelp: leave out `@" +
         std::to_string(*setting.step) + "`; while it runs " +
         (list.empty() ? "nothing of this program can be set" : "one can set " + list);
}

bool StateSettings::apply(EpisodeKey key, StateRow states) const {
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    if (!settings_[i]) continue;
    with_elements(states_[i].type.scalar, states.messages[i],
                  [&](auto* elements) { sample(*settings_[i], key, states_[i], elements); });
    states.has_value[i] = true;
  }
  return !settings_.empty();
}

bool StateSettings::apply_at(Seq step, StateRow states) const {
  bool any = false;
  for (const auto& [state, setting] : running_) {
    if (setting.step != step) continue;
    with_elements(states_[state].type.scalar, states.messages[state],
                  [&, state = state, &setting = setting](auto* elements) {
                    sample(setting, {}, states_[state], elements);
                  });
    states.has_value[state] = any = true;
  }
  return any;
}

}  // namespace eagerx::linux_sim
