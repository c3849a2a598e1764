// Records a node from one tick to the next, with the messages of one channel as the input.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/number.hpp>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace eagerx::linearize {

/// An input of a node, as its class sees it.
struct NodeInput {
  std::string name;
  std::size_t elements = 0;
};

/// One run, from tick `begin_tick` of a node to its next one. Readers of channel `cut` receive its
/// messages without derivatives, except that an element of the first message in between has one.
struct NodeTicks {
  using Derivatives = std::array<double, kSeeds>;
  static constexpr std::size_t kNever = ~std::size_t{0} / 2;

  std::string_view node;
  std::optional<std::uint32_t> cut;
  std::vector<std::uint32_t> seen;                // further channels whose messages are recorded
  std::size_t begin_tick = kNever;                // which of the run
  std::vector<std::optional<std::size_t>> seeds;  // elements of `cut`, by derivative
  std::function<void()> begin, end;               // called at both ticks, before the callback

  std::size_t ticks = 0;              // of the node so far
  std::size_t cut_messages = 0;       // between the ticks
  std::size_t cut_elements = 0;       // of each
  std::vector<NodeInput> inputs;      // of the node
  std::vector<Derivatives> received;  // by element of all inputs, at the first tick
  std::vector<std::vector<std::vector<Derivatives>>> sent;  // by `seen`, message and element
  std::set<std::uint32_t> losing, smoothing;  // channels of nodes that do that to derivatives

  [[nodiscard]] bool is_over() const { return begin_tick < ticks && !is_between(); }

  template <class Inputs>
  void on_inputs(const Inputs& all) {
    if (ticks == begin_tick) {
      if (begin) begin();
      all.for_each([&](const char* name, const auto& window) { receive(name, window); });
      sent.resize(seen.size());
    } else if (is_between() && end) {
      end();
    }
    ++ticks;
  }
  template <class Message>
  void on_message(std::uint32_t channel, Message& message) {
    if (doings.lost) losing.insert(channel);
    if (doings.smoothed) smoothing.insert(channel);
    doings = {};
    const auto found = std::find(seen.begin(), seen.end(), channel);
    if (is_between() && found != seen.end())
      sent[static_cast<std::size_t>(found - seen.begin())].push_back(derivatives_of(message));
    if (channel == cut) cut_off(message);
  }

 private:
  [[nodiscard]] bool is_between() const { return ticks == begin_tick + 1; }

  template <class Window>
  void receive(const char* name, const Window& window) {
    using Message = typename Window::value_type;
    inputs.push_back({name, size_of<Message>});
    if constexpr (requires { window.empty(); }) {
      if (window.empty()) {
        received.resize(received.size() + size_of<Message>);
        return;
      }
    }
    const auto newest = derivatives_of(window.back());
    received.insert(received.end(), newest.begin(), newest.end());
  }
  template <class Message>
  static std::vector<Derivatives> derivatives_of(const Message& message) {
    std::vector<Derivatives> all(size_of<Message>);
    if constexpr (std::is_same_v<ScalarOf<Message>, Number>) {
      for (std::size_t i = 0; i < all.size(); ++i)
        std::copy_n(element(message, i).derivative, kSeeds, all[i].begin());
    }
    return all;
  }
  template <class Message>
  void cut_off(Message& message) {
    cut_elements = size_of<Message>;
    if constexpr (std::is_same_v<ScalarOf<Message>, Number>) {
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        Number& x = element(message, i);
        x = Number(x.value);
        if (!is_between() || cut_messages > 0) continue;
        for (std::size_t k = 0; k < seeds.size(); ++k) {
          if (seeds[k] == i) x.derivative[k] = 1.0;
        }
      }
    }
    if (is_between()) ++cut_messages;
  }
};

}  // namespace eagerx::linearize
