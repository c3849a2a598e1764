// --fault: what the agent sees and gives, with faults.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <memory>
#include <string>
#include <targets/common/fault.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::linux_sim {

/// Faults between a graph and its agent. The messages of the graph stay as they are.
template <class Graph>
class AgentFaults {
 public:
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;

  /// What is wrong with `texts`, or nothing.
  std::string read(const std::vector<std::string>& texts) {
    if (!texts.empty()) list_places();
    for (const std::string& text : texts) {
      auto fault = target::parse_fault(text);
      if (!fault) return "error: `" + text + "` is no fault\nhelp: write " + target::kFaultForms;
      if (!fault->begins) fault->begins = 0;
      target::FaultProblem problem;
      auto placed = target::place_fault(std::move(*fault), places_, problem);
      if (!placed) return "error: " + problem.what + "\nhelp: " + problem.help;
      faults_.push_back(std::move(*placed));
    }
    return {};
  }

  bool empty() const { return faults_.empty(); }

  /// What the agent sees of the observation of a step. Valid until the next call.
  Observation seen(Seq step, const Observation& observation) {
    Observation result = observation;
    std::size_t field = 0;
    Graph::for_each_observation(result, [&](const char*, const auto& window, const auto&) {
      using Observed = std::remove_cvref_t<decltype(window)>;
      auto* const messages = messages_of<typename Observed::value_type>(field);
      if (!is_silent(field, step)) {
        sizes_[field] = window.size();
        for (std::uint32_t w = 0; w < window.size(); ++w)
          put(field, w * size_of<typename Observed::value_type>, step, window[w], messages[w]);
      }
      // `result` is no constant, only what for_each_observation() shows of it.
      std::construct_at(const_cast<Observed*>(&window), messages, Seq{sizes_[field]});
      ++field;
    });
    return result;
  }

  /// What comes of the agent's action.
  Action given(Seq step, Action action) {
    std::size_t field = observations_;
    Graph::for_each_action(action, [&](const char*, auto& message, const auto&) {
      auto& kept = *messages_of<std::remove_cvref_t<decltype(message)>>(field);
      put(field++, 0, step, message, kept);
      message = kept;
    });
    return action;
  }

 private:
  using Place = std::max_align_t;

  void list_places() {
    static_assert(std::is_trivially_copyable_v<Observation>);
    // Nobody looks into its windows.
    const auto any = std::bit_cast<Observation>(std::array<std::byte, sizeof(Observation)>{});
    Graph::for_each_observation(any, [&](const char* name, const auto& window, const auto&) {
      using Observed = std::remove_cvref_t<decltype(window)>;
      add<typename Observed::value_type>(name, false, most_of<Observed>());
    });
    observations_ = places_.size();
    Action action = Graph::zero();
    Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&) {
      add<std::remove_cvref_t<decltype(message)>>(name, true, 1);
    });
  }

  /// Messages of an observation that there can be.
  template <class Observed>
  static constexpr std::uint32_t most_of() {
    if constexpr (requires { Observed::kMaxSize; }) {
      return Observed::kMaxSize;
    } else {
      return Observed::size();
    }
  }

  template <class Message>
  void add(const char* name, bool is_action, std::uint32_t messages) {
    static_assert(alignof(Message) <= alignof(Place) && std::is_trivially_copyable_v<Message>);
    places_.push_back({name, is_action, messages * size_of<Message>,
                       std::is_floating_point_v<ScalarOf<Message>>});
    sizes_.push_back(messages);
    kept_.emplace_back((messages * sizeof(Message) + sizeof(Place) - 1) / sizeof(Place));
    for (std::uint32_t i = 0; i < messages; ++i)
      std::construct_at(messages_of<Message>(places_.size() - 1) + i);
  }
  template <class Message>
  Message* messages_of(std::size_t field) {
    return reinterpret_cast<Message*>(kept_[field].data());
  }

  /// Whether nothing of an observation comes, so that its window stays as long as it was.
  bool is_silent(std::size_t field, Seq step) const {
    return step > 0 && std::ranges::any_of(faults_, [&](const target::PlacedFault& each) {
             return each.fault.kind == target::Fault::Kind::silent &&
                    each.size == places_[field].size && each.acts(field, 0, step);
           });
  }

  /// `now` with the faults of its numbers, which are those from `first` on of the field.
  template <class Message>
  void put(std::size_t field, std::size_t first, Seq step, const Message& now, Message& kept) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      auto& place = element(kept, i);
      place = target::with_faults(faults_, field, first + i, step, element(now, i), place);
    }
  }

  std::vector<target::FaultPlace> places_;  // observations, then actions
  std::size_t observations_ = 0;
  std::vector<target::PlacedFault> faults_;
  std::vector<std::vector<Place>> kept_;  // [places] what the agent saw and gave last
  std::vector<std::uint32_t> sizes_;      // [places] messages of it
};

}  // namespace eagerx::linux_sim
