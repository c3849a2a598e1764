#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/base/nearest.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/publish/parameters.hpp>
#include <targets/linux-sim/state_settings.hpp>

namespace eagerx::linux_sim {

using foxglove::ClientMessage;
using foxglove::ParameterValue;

namespace {

/// [elements] bounds of the space, or what the type can have.
std::vector<double> bounds(const Field& field, const void* of_space, bool is_low) {
  std::vector<double> result;
  for (std::size_t i = 0; i < field.type.size; ++i) {
    if (of_space != nullptr) {
      result.push_back(number_of(field.type.scalar, of_space, i));
      continue;
    }
    result.push_back(with_scalar(field.type.scalar, [&](auto zero) {
      using Limits = std::numeric_limits<decltype(zero)>;
      return static_cast<double>(is_low ? Limits::lowest() : Limits::max());
    }));
  }
  return result;
}

/// The largest whole number below 2^N is no double for 64 bits.
bool fits_type(Scalar scalar, double x) {
  return with_scalar(scalar, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::numeric_limits<T>::is_integer) {
      const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);
      return x == std::floor(x) && x < end && x >= (std::numeric_limits<T>::is_signed ? -end : 0.0);
    } else {
      return std::isfinite(static_cast<T>(x));
    }
  });
}

}  // namespace

Parameters::Parameters(const Fields& fields, Remote& remote, bool is_real)
    : remote_(remote), is_real_(is_real) {
  add(fields.states, Remote::Wish::state);
  add(fields.actions, Remote::Wish::action);
}

void Parameters::add(const std::vector<Field>& fields, Remote::Wish wish) {
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    const bool is_state = wish == Remote::Wish::state;
    const std::string name = (is_state ? "" : "environment/") + std::string(fields[i].name);
    known_.push_back({name, &fields[i], wish, i, at, {}, 0});
    at += fields[i].type.size;
  }
}

std::vector<ParameterValue> Parameters::values(const std::vector<std::string>& names) {
  std::vector<ParameterValue> result;
  const bool has_states = remote_.read_states(numbers_, has_value_);
  for (const Known& each : known_) {
    if (!names.empty() && std::find(names.begin(), names.end(), each.name) == names.end()) continue;
    const MessageType& type = each.field->type;
    ParameterValue value{each.name, type.size > 1, type.scalar == Scalar::f32, each.value};
    if (each.wish == Remote::Wish::state && value.numbers.empty() && has_states &&
        has_value_[each.index]) {
      const auto begin = numbers_.begin() + static_cast<std::ptrdiff_t>(each.at);
      value.numbers.assign(begin, begin + static_cast<std::ptrdiff_t>(type.size));
    }
    result.push_back(std::move(value));
  }
  return result;
}

bool Parameters::has(const std::string& name) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const Known& each) { return each.name == name; });
}

std::string Parameters::problem_with(const Known& known, const std::vector<double>& numbers) {
  const Field& field = *known.field;
  if (numbers.size() != field.type.size)
    return "`" + known.name + "` takes " + std::to_string(field.type.size) + " numbers, not " +
           std::to_string(numbers.size());
  // As `--set` says it.
  StateSetting setting;
  setting.name = known.name;
  setting.numbers = numbers;
  setting.written = "…";
  std::string problem =
      problem_of(setting, bounds(field, field.low, true), bounds(field, field.high, false));
  for (const double x : numbers)
    if (problem.empty() && !fits_type(field.type.scalar, x))
      problem = "`" + known.name + "`: no number of its type";
  problem.erase(std::min(problem.find("\nhelp:"), problem.size()));
  const std::size_t state = problem.find(" of the state");
  if (known.wish == Remote::Wish::action && state != std::string::npos) problem.erase(state, 13);
  return problem.starts_with("error: ") ? problem.substr(7) : problem;
}

std::string Parameters::set(ClientId client, const ClientMessage::Parameter& wanted) {
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& each) { return each.name == wanted.name; });
  if (found == known_.end()) {
    std::vector<std::string> names;
    for (const Known& each : known_) names.push_back(each.name);
    const std::string near = host::did_you_mean(wanted.name, names);
    return "there is no parameter `" + wanted.name + "`" + (near.empty() ? "" : "; " + near);
  }
  const bool takes_flags = found->field->type.scalar == Scalar::boolean;
  if (wanted.is_wrong || (wanted.has_flags && !takes_flags))
    return "`" + wanted.name + "` takes numbers";
  if (!wanted.numbers.empty()) {
    std::string problem = problem_with(*found, wanted.numbers);
    if (!problem.empty()) return problem;
  }
  if (!remote_.set(found->wish, found->index, wanted.numbers))
    return "the run is busy: `" + wanted.name + "` is not set";
  found->value = wanted.numbers;
  found->client = client;
  return {};
}

std::uint64_t Parameters::ask(foxglove::Service service, std::uint32_t steps) {
  using foxglove::Service;
  switch (service) {
    case Service::reset:
      return remote_.ask(Remote::Wish::reset, 0);
    case Service::pause:
      return remote_.ask(Remote::Wish::pause, 0);
    case Service::resume:
      return remote_.ask(Remote::Wish::resume, 0);
    case Service::step:
      return remote_.ask(Remote::Wish::step, steps);
    case Service::none:
      break;
  }
  return 0;
}

bool Parameters::release(ClientId client) {
  bool any = false;
  for (Known& each : known_) {
    if (each.wish != Remote::Wish::action || each.client != client || each.value.empty()) continue;
    each.client = kNoClient;
    if (!remote_.set(each.wish, each.index, {})) continue;  // later, of no client
    each.value.clear();
    any = true;
  }
  return any;
}

}  // namespace eagerx::linux_sim
