#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/dds/topics.hpp>
#include <runtime/host/trace/log_clock.hpp>
#include <targets/linux-sim/dds/remote_agent.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/pacer.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr std::int64_t kMsInNs = 1'000'000;
constexpr std::int64_t kSlice = 50 * kMsInNs;  // in which a signal is seen

std::size_t units(std::size_t bytes) {
  return bytes / sizeof(std::max_align_t) + 1;
}

/// Whether `number` is one of the type of `zero`.
template <class T>
bool fits(double number, T /*zero*/) {
  if constexpr (std::is_same_v<T, double>) return true;
  if constexpr (std::is_same_v<T, float>)
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
  if constexpr (std::is_same_v<T, bool>) return number == 0.0 || number == 1.0;
  // 2^63 is no int64, but the double that is nearest to the largest one.
  return number == std::trunc(number) &&
         number >= static_cast<double>(std::numeric_limits<T>::min()) &&
         number < std::ldexp(1.0, std::numeric_limits<T>::digits);
}

}  // namespace

RemoteAgent::RemoteAgent(const Options& options, const GraphFacts& facts, const Fields& fields,
                         const void* zero, std::size_t bytes)
    : options_(options), facts_(facts), fields_(fields), action_(units(bytes)) {
  std::memcpy(action_.data(), zero, bytes);
  wanted_ = action_;
  for (const Field& field : fields.actions)
    inputs_.push_back({&field, dds::topic_of_environment(facts.name, "actions", field.name)});
  for (const Field& field : fields.observations)
    outputs_.push_back({&field, dds::topic_of_environment(facts.name, "observations", field.name)});
}

std::string RemoteAgent::open() {
  if (inputs_.empty())
    return "error: this graph has no action that `--agent dds` could give\nhelp: leave it out";
  std::vector<std::string> inputs;
  std::vector<dds::JointExchange::Output> outputs;
  for (const Input& input : inputs_) inputs.push_back(input.topic);
  for (const Output& output : outputs_)
    outputs.push_back({output.topic, output.field->name, output.field->type.size});
  std::vector<std::string> names = inputs;
  for (const Output& output : outputs_) names.push_back(output.topic);
  const std::string problem = dds::problem_of_names(names);
  return problem.empty() ? exchange_->open(options_.agent_domain, inputs, outputs) : problem;
}

std::string RemoteAgent::wait_for_agent() {
  const std::int64_t until = now_ns() + static_cast<std::int64_t>(options_.agent_timeout_s * 1e9);
  while (!exchange_->is_there()) {
    host::stop_if_requested();
    look_for_strangers();
    if (host::interrupted()) return {};
    const std::int64_t now = now_ns();
    if (now >= until)
      return silence("there is no agent in domain " + std::to_string(options_.agent_domain));
    MonotonicClock::sleep_until(std::min(until, now + 10 * kMsInNs));
  }
  return {};
}

const void* RemoteAgent::act(Seq step, ObservationRow observations, std::int64_t until_ns) {
  const bool in_real_time = until_ns != 0;
  const std::int64_t began = now_ns();
  if (!in_real_time) until_ns = began + static_cast<std::int64_t>(options_.agent_timeout_s * 1e9);
  frame_ = std::to_string(episode_) + "/" + std::to_string(step);
  now_ = dds::stamp_of(trace_log::time_of_tick(++written_, facts_.rate_num, facts_.rate_den));
  for (Input& input : inputs_) input.has_come = false;
  for (Output& output : outputs_) output.is_written = false;
  bool is_written = write(observations);
  std::int64_t again = began + kSlice;
  while (!take_all()) {
    host::stop_if_requested();
    const std::int64_t now = now_ns();
    if (host::interrupted()) return action_.data();
    if (now >= until_ns) {
      ++missed_;
      ++missed_in_a_row_;
      look_for_strangers();
      if (!in_real_time)
        problem_ = silence("the agent gave no action for step " + std::to_string(step) +
                           " of episode " + std::to_string(episode_));
      return action_.data();
    }
    // An agent that has only now found all topics did not see the first ones.
    if (!has_answered_ && now >= again) {
      for (Output& output : outputs_) output.is_written = false;
      again = now + kSlice;
      is_written = false;
    }
    if (!is_written) is_written = write(observations);
    exchange_->wait(std::min(until_ns - now, is_written ? kSlice : kMsInNs));
  }
  has_answered_ = true;
  missed_in_a_row_ = 0;
  before_ = now_;
  action_ = wanted_;
  return action_.data();
}

bool RemoteAgent::write(ObservationRow observations) {
  bool complete = true;
  for (std::size_t o = 0; o < outputs_.size(); ++o) {
    Output& output = outputs_[o];
    if (output.is_written) continue;
    const MessageType& type = output.field->type;
    output.numbers.clear();
    for (std::uint32_t w = 0; w < observations.sizes[o]; ++w) {
      const auto* const message = static_cast<const std::byte*>(observations.messages[o]);
      for (std::size_t i = 0; i < type.size; ++i)
        output.numbers.push_back(number_of(type.scalar, message + w * type.bytes, i));
    }
    output.is_written = exchange_->write(o, now_, frame_, output.numbers);
    complete = complete && output.is_written;
  }
  return complete;
}

bool RemoteAgent::take_all() {
  bool complete = true;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    Input& input = inputs_[i];
    exchange_->read(i, [this, &input](dds::Stamp when, std::span<const double> numbers) {
      check(input, when, numbers);
    });
    complete = complete && input.has_come;
  }
  return complete;
}

void RemoteAgent::check(Input& input, dds::Stamp when, std::span<const double> numbers) {
  if (when != now_) {
    // One that was answered may have been asked for twice.
    if (when != before_ || !has_answered_) ++(when < now_ ? late_ : others_);
    return;
  }
  if (input.has_come) return;
  if (std::uint64_t* const wrong = wrong_with(*input.field, numbers)) {
    ++*wrong;
    return;
  }
  auto* const to = reinterpret_cast<std::byte*>(wanted_.data()) + input.field->offset;
  with_elements(input.field->type.scalar, static_cast<void*>(to), [&](auto* elements) {
    using T = std::remove_reference_t<decltype(*elements)>;
    for (std::size_t i = 0; i < input.field->type.size; ++i)
      elements[i] = static_cast<T>(numbers[i]);
  });
  input.has_come = true;
}

std::uint64_t* RemoteAgent::wrong_with(const Field& field, std::span<const double> numbers) {
  const MessageType& type = field.type;
  if (numbers.size() != type.size) return &lengths_;
  for (std::size_t i = 0; i < type.size; ++i) {
    const double number = numbers[i];
    if (!std::isfinite(number)) return &not_finite_;
    if (!with_scalar(type.scalar, [&](auto zero) { return fits(number, zero); }))
      return &not_whole_;
    if (field.low != nullptr && number < number_of(type.scalar, field.low, i)) return &beyond_;
    if (field.high != nullptr && number > number_of(type.scalar, field.high, i)) return &beyond_;
  }
  return nullptr;
}

void RemoteAgent::look_for_strangers() {
  for (const std::string& topic : exchange_->strangers()) {
    ++strangers_;
    stranger_ =
        "\nnote: what another program writes to `" + topic + "` is not a sensor_msgs/JointState";
  }
}

std::string RemoteAgent::silence(const std::string& what) const {
  std::string text = std::to_string(options_.agent_timeout_s);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return "error: " + what + ", after " + text + " s" + stranger_ + "\nhelp: it answers on `" +
         inputs_.front().topic +
         "` with the time of the observation; `--agent-timeout` says how long it may take";
}

void RemoteAgent::finish(Summary& summary) {
  look_for_strangers();
  const auto add = [&](const char* name, std::uint64_t count) {
    if (count > 0) summary.faults.emplace_back(name, count);
  };
  add("agent: steps without its action in time", missed_);
  add("agent: actions too late", late_);
  add("agent: actions of no step", others_);
  add("agent: actions of another length", lengths_);
  add("agent: actions not finite", not_finite_);
  add("agent: actions that are not numbers of their type", not_whole_);
  add("agent: actions out of their space", beyond_);
  add("agent: writers of another type", strangers_);
}

}  // namespace eagerx::linux_sim
