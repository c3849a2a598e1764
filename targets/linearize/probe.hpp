// Observes and changes the messages of a program that is linearized.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/number.hpp>
#include <eagerx/rate.hpp>
#include <optional>
#include <set>
#include <targets/linearize/step_response.hpp>
#include <targets/linearize/ticks.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::linearize {

using Derivatives = std::array<double, kSeeds>;

/// A message that was sent: its elements, those that have derivatives.
struct Sent {
  std::vector<double> values;
  std::vector<Derivatives> derivatives;
};

/// A derivative of 1 of an element of messages of a channel.
struct Seed {
  static constexpr std::size_t kEach = ~std::size_t{0};
  std::uint32_t channel;
  std::size_t element;
  std::size_t message = kEach;  // which one of the run, or each
};

/// A fixed value for an element of all messages of a channel.
struct Held {
  std::uint32_t channel = 0;
  std::size_t element = 0;
  double value = 0.0;
};

/// A value as an element of a message.
template <class Scalar>
Scalar scalar(double value) {
  if constexpr (std::is_same_v<Scalar, Number>)
    return Number(value);
  else
    return static_cast<Scalar>(value);
}

/// All messages of a run.
struct Record {
  std::vector<std::vector<Sent>> channels;  // by channel
  std::optional<std::uint32_t> opened;  // a channel: readers get what is sent without derivatives
  std::size_t opened_element = 0;
  std::vector<const Seed*> seeds;             // by derivative; null: none
  std::set<std::uint32_t> losing, smoothing;  // channels of nodes that do that to derivatives
};

/// The hooks of the program.
struct Probe {
  Record* record = nullptr;
  const std::vector<Held>* held = nullptr;
  NodeTicks* ticks = nullptr;
  AddedStep* added = nullptr;

  static constexpr bool kSeesInputs = true;
  void on_reset_phase(bool /*begins*/) {}
  template <class Rate, class Inputs>
  void on_inputs(const char* node, Rate /*rate*/, Seq /*tick*/, const Inputs& inputs) {
    if (ticks != nullptr && ticks->node == node) ticks->on_inputs(inputs);
  }
  template <class Message>
  void on_message(std::uint32_t channel, Seq /*seq*/, Message& message) {
    if (record == nullptr) {
      for (std::size_t i = 0; i < size_of<Message>; ++i) hold(channel, i, element(message, i));
      if (added != nullptr) added->on_message(channel, message);
      if (ticks != nullptr) ticks->on_message(channel, message);
      return;
    }
    std::vector<Sent>& all = record->channels[channel];
    Sent sent;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      auto& x = element(message, i);
      if constexpr (std::is_same_v<std::remove_reference_t<decltype(x)>, Number>) {
        sent.values.push_back(x.value);
        Derivatives& derivatives = sent.derivatives.emplace_back();
        for (std::size_t k = 0; k < kSeeds; ++k) derivatives[k] = x.derivative[k];
        if (record->opened == channel && record->opened_element == i) x = Number(x.value);
        hold(channel, i, x);
        move(channel, i, all.size(), x);
      } else {
        hold(channel, i, x);
      }
    }
    if (doings.lost) record->losing.insert(channel);
    if (doings.smoothed) record->smoothing.insert(channel);
    doings = {};
    all.push_back(std::move(sent));
  }

 private:
  /// Replaces element `i` of a held channel for its readers.
  template <class Scalar>
  void hold(std::uint32_t channel, std::size_t i, Scalar& x) const {
    if (held == nullptr) return;
    for (const Held& each : *held) {
      if (each.channel == channel && each.element == i) x = scalar<Scalar>(each.value);
    }
  }
  /// Adds the seeds of element `i` of message `n` of a channel.
  void move(std::uint32_t channel, std::size_t i, std::size_t n, Number& x) const {
    for (std::size_t k = 0; k < record->seeds.size(); ++k) {
      const Seed* const seed = record->seeds[k];
      if (seed != nullptr && seed->channel == channel && seed->element == i &&
          (seed->message == Seed::kEach || seed->message == n))
        x.derivative[k] += 1.0;
    }
  }
};

}  // namespace eagerx::linearize
