// What looks at the messages of a program that is linearized, and moves them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/number.hpp>
#include <eagerx/rate.hpp>
#include <optional>
#include <set>
#include <type_traits>
#include <vector>

namespace eagerx::linearize {

using Derivatives = std::array<double, kSeeds>;

/// A message that was sent: the derivatives of its elements.
struct Sent {
  std::vector<Derivatives> derivatives;
};

/// A derivative of 1 of an element of messages of a channel.
struct Seed {
  static constexpr std::size_t kEach = ~std::size_t{0};
  std::uint32_t channel;
  std::size_t element;
  std::size_t message = kEach;  // which one of the run, or each
};

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

  template <class Message>
  void on_message(std::uint32_t channel, Seq /*seq*/, Message& message) {
    if (record == nullptr) return;
    std::vector<Sent>& all = record->channels[channel];
    Sent sent;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      auto& x = element(message, i);
      if constexpr (std::is_same_v<std::remove_reference_t<decltype(x)>, Number>) {
        Derivatives& derivatives = sent.derivatives.emplace_back();
        for (std::size_t k = 0; k < kSeeds; ++k) derivatives[k] = x.derivative[k];
        if (record->opened == channel && record->opened_element == i) x = Number(x.value);
        move(channel, i, all.size(), x);
      }
    }
    if (doings.lost) record->losing.insert(channel);
    if (doings.smoothed) record->smoothing.insert(channel);
    doings = {};
    all.push_back(std::move(sent));
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
