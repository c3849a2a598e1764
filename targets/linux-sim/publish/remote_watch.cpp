#include <algorithm>
#include <bit>
#include <limits>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/publish/remote_watch.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

/// They were checked to be some of the type.
void put(const Field& field, void* message, const std::vector<double>& numbers) {
  with_elements(field.type.scalar, message, [&](auto* elements) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      elements[i] = static_cast<std::remove_reference_t<decltype(elements[i])>>(numbers[i]);
  });
}

}  // namespace

RemoteWatch::RemoteWatch(GraphProgram& program, const RunInputs& inputs, host::TextFile& csv,
                         host::TextFile& trace, Publishing& publishing, Remote& remote)
    : PublishWatch(program, inputs, csv, trace, publishing),
      remote_(remote),
      fields_(inputs.fields),
      states_(inputs.fields.states.size()),
      actions_(inputs.fields.actions.size()),
      had_faults_(has_faults_) {
  tunes_ = tunes_ || std::ranges::any_of(fields_.states, &Field::tunable);
  for (std::size_t i = 0; i < states_.size(); ++i)
    states_[i].numbers.resize(fields_.states[i].type.size);
  for (std::size_t i = 0; i < actions_.size(); ++i)
    actions_[i].numbers.resize(fields_.actions[i].type.size);
}

bool RemoteWatch::go_on() {
  take_requests();
  if (waits()) stand_still();
  return PublishWatch::go_on();
}

void RemoteWatch::stand_still() {
  constexpr std::int64_t kPauseNs = 2'000'000;
  const std::int64_t begin = now_ns();
  while (waits() && PublishWatch::go_on()) {
    MonotonicClock::sleep_until(now_ns() + kPauseNs);
    take_requests();
  }
  time_stood_still(now_ns() - begin);
}

void RemoteWatch::take_requests() {
  Remote::Request request{};
  while (remote_.next(request)) {
    if (request.wish == Remote::Wish::state || request.wish == Remote::Wish::action) {
      auto& all = request.wish == Remote::Wish::state ? states_ : actions_;
      Values& values = all[request.index];
      values.are_set = request.count > 0;
      values.are_new = values.are_set && request.wish == Remote::Wish::state &&
                       fields_.states[request.index].tunable;
      for (std::size_t i = 0; i < request.count; ++i)
        values.numbers[i] = std::bit_cast<double>(request.values[i]);
      has_faults_ = had_faults_;
      for (const Values& each : actions_) has_faults_ = has_faults_ || each.are_set;
    } else {
      serve(request);
    }
    remote_.pop(request);
  }
}

/// A service takes the place of one that is not done yet.
void RemoteWatch::serve(const Remote::Request& request) {
  to_go_ = 0;
  ++served_;
  switch (request.wish) {
    case Remote::Wish::pause:
      is_paused_ = true;
      break;
    case Remote::Wish::resume:
      is_paused_ = false;
      break;
    case Remote::Wish::step:
      is_paused_ = true;
      to_go_ = request.index;
      return;
    default:
      // An episode that comes on top; between two there is a reset anyway.
      if (in_episode_ && !is_reset_wanted_) {
        is_over_ = true;
        if (plan_.episodes < std::numeric_limits<std::uint32_t>::max()) ++plan_.episodes;
      }
      is_reset_wanted_ = true;
      return;
  }
  if (!is_reset_wanted_) finish_service();
}

void RemoteWatch::finish_service() {
  remote_.set_done(served_);
}

bool RemoteWatch::begin_episode(EpisodeKey key, StateRow states) {
  const bool changed = PublishWatch::begin_episode(key, states);
  remote_.tell_states(states);
  return changed;
}

bool RemoteWatch::set_states(EpisodeKey key, StateRow states) {
  bool changed = PublishWatch::set_states(key, states);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!states_[i].are_set) continue;
    put(fields_.states[i], states.messages[i], states_[i].numbers);
    states.has_value[i] = changed = true;
    states_[i].are_new = false;
  }
  return changed;
}

bool RemoteWatch::tune(std::uint32_t episode, Seq step, StateRow states) {
  const bool changed = PublishWatch::tune(episode, step, states);
  if (changed) remote_.tell_states(current_states());
  return changed;
}

bool RemoteWatch::set_parameters(Seq step, StateRow states) {
  bool changed = PublishWatch::set_parameters(step, states);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!std::exchange(states_[i].are_new, false)) continue;
    put(fields_.states[i], states.messages[i], states_[i].numbers);
    states.has_value[i] = changed = true;
  }
  return changed;
}

void RemoteWatch::reset(std::uint32_t episode) {
  PublishWatch::reset(episode);
  in_episode_ = true;
  if (is_reset_wanted_ && to_go_ == 0) finish_service();
  is_reset_wanted_ = false;
}

void RemoteWatch::pace(Seq step, bool has_ended) {
  PublishWatch::pace(step, has_ended);
  in_episode_ = !has_ended;
  if (to_go_ > 0 && --to_go_ == 0) finish_service();
}

void RemoteWatch::given(Seq step, void* action) {
  PublishWatch::given(step, action);
  for (std::size_t i = 0; i < actions_.size(); ++i)
    if (actions_[i].are_set)
      put(fields_.actions[i], static_cast<std::byte*>(action) + fields_.actions[i].offset,
          actions_[i].numbers);
}

}  // namespace eagerx::linux_sim
