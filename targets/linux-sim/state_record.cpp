#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <runtime/host/base/number.hpp>
#include <string>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/state_record.hpp>
#include <type_traits>
#include <utility>

namespace eagerx::linux_sim {

StateRecord::StateRecord(const std::vector<Field>& states) : states_(states), current_(states) {
  std::size_t elements = 0;
  for (const Field& state : states) elements += state.type.size;
  least_.assign(elements, std::numeric_limits<double>::infinity());
  most_.assign(elements, -std::numeric_limits<double>::infinity());
}

void StateRecord::begin(StateRow states) {
  const StateRow now = current();
  std::size_t at = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MessageType& type = states_[i].type;
    const std::size_t first = std::exchange(at, at + type.size);
    if (states.has_value[i]) {
      std::memcpy(now.messages[i], states.messages[i], type.bytes);
      now.has_value[i] = true;
    }
    if (!now.has_value[i]) continue;
    for (std::size_t k = 0; k < type.size; ++k) {
      const double x = number_of(type.scalar, now.messages[i], k);
      least_[first + k] = std::min(least_[first + k], x);
      most_[first + k] = std::max(most_[first + k], x);
    }
  }
}

/// `before` comes before the first value, a comma before each other.
void StateRecord::values(host::TextFile& out, std::size_t state, const char* before) const {
  const MessageType& type = states_[state].type;
  with_elements(type.scalar, current().messages[state], [&](const auto* elements) {
    for (std::size_t i = 0; i < type.size; ++i) {
      out.text(i == 0 ? before : ",");
      out.number(elements[i]);
    }
  });
}

void StateRecord::trace(host::TextFile& out, std::uint32_t episode) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!current().has_value[i]) continue;
    out.text("# state ");
    out.number(episode);
    out.text(" ");
    out.text(states_[i].name);
    values(out, i, " ");
    out.text("\n");
  }
}

void StateRecord::trace_set(host::TextFile& out, std::uint32_t episode, Seq step,
                            StateRow states) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!states.has_value[i]) continue;
    out.text("# set ");
    out.number(episode);
    out.text(" ");
    out.number(step);
    out.text(" ");
    out.text(states_[i].name);
    values(out, i, " ");
    out.text("\n");
  }
}

void StateRecord::column_names(host::TextFile& out) const {
  for (const Field& state : states_) {
    for (std::size_t i = 0; i < state.type.size; ++i) {
      out.text(",state:");
      out.text(state.name);
      if (state.type.is_scalar()) continue;
      out.text("[");
      out.number(i);
      out.text("]");
    }
  }
}

void StateRecord::columns(host::TextFile& out) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (current().has_value[i]) {
      values(out, i, ",");
    } else {
      for (std::size_t k = 0; k < states_[i].type.size; ++k) out.text(",");
    }
  }
}

void StateRecord::describe(Summary& summary) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const MessageType& type = states_[i].type;
    const std::size_t first = std::exchange(at, at + type.size);
    if (!current().has_value[i]) continue;
    const auto text_of = [&](const std::vector<double>& numbers) {
      std::string text;
      for (std::size_t k = first; k < at; ++k) {
        text += (k > first ? ", " : "") + (type.scalar == Scalar::f32
                                               ? host::number_text(static_cast<float>(numbers[k]))
                                               : host::number_text(numbers[k]));
      }
      return type.size > 1 ? "[" + text + "]" : text;
    };
    const std::string least = text_of(least_), most = text_of(most_);
    summary.states.emplace_back(states_[i].name, least == most ? least : least + " to " + most);
  }
}

namespace {

template <class T>
bool read(const std::string& text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    value = text == "1";
    return true;
  } else {
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
  }
}

/// False: the program has no such state.
bool take(const std::string& name, const std::vector<std::string>& values,
          const std::vector<Field>& states, StateRow row) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const MessageType& type = states[i].type;
    // Logs of 0.2 have the id.
    if ((name != states[i].name && name != states[i].id) || values.size() != type.size) continue;
    std::vector<std::byte> message(type.bytes);
    return with_scalar(type.scalar, [&](auto zero) {
      auto* const elements = reinterpret_cast<decltype(zero)*>(message.data());
      for (std::size_t k = 0; k < type.size; ++k) {
        if (!read(values[k], elements[k])) return false;
      }
      std::memcpy(row.messages[i], message.data(), type.bytes);
      return row.has_value[i] = true;
    });
  }
  return false;
}

}  // namespace

void repeat_states(const trace_log::Log& log, std::uint32_t episode,
                   const std::vector<Field>& states, StateRow row) {
  for (const trace_log::RecordedState& recorded : log.states)
    if (recorded.episode == episode) take(recorded.name, recorded.values, states, row);
}

bool repeat_settings(const trace_log::Log& log, std::uint32_t episode, Seq step,
                     const std::vector<Field>& states, StateRow row) {
  std::fill_n(row.has_value, states.size(), false);
  bool any = false;
  for (const trace_log::RecordedSetting& recorded : log.settings) {
    if (recorded.episode == episode && recorded.step == step)
      any = take(recorded.name, recorded.values, states, row) || any;
  }
  return any;
}

}  // namespace eagerx::linux_sim
