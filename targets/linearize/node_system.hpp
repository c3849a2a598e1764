// The derivatives of a program from each tick of a node to the next, as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <eagerx/math.hpp>
#include <eagerx/number.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <targets/linearize/print.hpp>
#include <targets/linearize/ticks.hpp>
#include <targets/linearize/words.hpp>
#include <vector>

namespace eagerx::linearize {

/// Request for the system of a node, with channels by their numbers in the graph.
struct NodeRequest {
  std::string node;                  // its name; empty: no node
  std::optional<std::uint32_t> cut;  // the channel that is the input of the system
  std::vector<std::uint32_t> seen;   // further outputs
};

/// For each tick i of a hyperperiod, with x the state at it, u the message of the cut channel, s
/// the node's inputs and y the messages of further channels until the next tick: x[i+1] = A·x[i] +
/// B·u[i], s[i] = C·x[i], y[i] = E·x[i] + F·u[i].
template <class Program, class Step>
class NodeSystem {
 public:
  /// `start`: the program at an instant at which all rates are due; `step(program)` runs it.
  NodeSystem(const NodeRequest& request, const Program& start, const std::vector<Word>& words,
             Step step)
      : request_(request), start_(start), words_(words), step_(step) {}

  /// False with a message: the node does not run, or a derivative is not finite.
  bool print(double hyperperiod_s) {
    const std::size_t ticks = count_ticks();
    if (ticks == 0) {
      std::fprintf(stderr, "error: `%s` does not run\n", request_.node.c_str());
      return false;
    }
    std::vector<Phase> phases;
    for (std::size_t i = 0; i < ticks; ++i) {
      phases.push_back(phase(i));
      if (are_finite(phases.back())) continue;
      std::fprintf(stderr,
                   "error: derivatives at this point are not finite\nhelp: choose another point "
                   "with `--at`, or fewer `--steps` if the graph diverges\n");
      return false;
    }
    std::printf("{\"period_s\": %.17g,\n\"state\": [", hyperperiod_s / static_cast<double>(ticks));
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const double value = at(const_cast<Program&>(start_), words_[i]).value;
      std::printf("%s\n[\"%s\", %.17g]", i == 0 ? "" : ",", words_[i].name.c_str(),
                  eagerx::isfinite(value) ? value : 0.0);
    }
    std::printf("],\n\"received\": [");
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      std::printf("%s[\"%s\", %zu]", i == 0 ? "" : ", ", inputs_[i].name.c_str(),
                  inputs_[i].elements);
    std::printf("]");
    print_list("losing", losing_);
    print_list("smoothing", smoothing_);
    std::printf(",\n\"phases\": [");
    for (std::size_t i = 0; i < phases.size(); ++i) print_phase(phases[i], i == 0);
    std::printf("]}\n");
    return true;
  }

 private:
  using Rows = Matrix;
  struct Phase {
    Rows a, b, c, e, f;
    std::size_t cut_messages = 0;
    std::vector<std::size_t> messages;  // of each further channel
  };

  std::size_t count_ticks() {
    NodeTicks ticks;
    ticks.node = request_.node;
    ticks.cut = request_.cut;
    auto copy = std::make_unique<Program>(start_);
    copy->hooks.ticks = &ticks;
    doings = {};
    for (std::uint32_t i = 0; i < Program::kPhases; ++i) step_(*copy);
    copy->hooks.ticks = nullptr;
    cut_elements_ = ticks.cut_elements;
    return ticks.ticks;
  }

  /// From tick `i` to the next, with derivatives by `words` and by elements of the message.
  template <class End>
  NodeTicks go(std::size_t i, const std::vector<const Word*>& words,
               const std::vector<std::optional<std::size_t>>& elements, End end) {
    NodeTicks ticks;
    ticks.node = request_.node;
    ticks.cut = request_.cut;
    ticks.seen = request_.seen;
    ticks.begin_tick = i;
    ticks.seeds = elements;
    auto copy = std::make_unique<Program>(start_);
    ticks.begin = [&] {
      for (std::size_t k = 0; k < words.size(); ++k) at(*copy, *words[k]).derivative[k] = 1.0;
    };
    ticks.end = [&] { end(*copy); };
    copy->hooks.ticks = &ticks;
    doings = {};
    for (std::uint32_t s = 0; s < 2 * Program::kPhases && !ticks.is_over(); ++s) step_(*copy);
    copy->hooks.ticks = nullptr;
    losing_.insert(ticks.losing.begin(), ticks.losing.end());
    smoothing_.insert(ticks.smoothing.begin(), ticks.smoothing.end());
    inputs_ = ticks.inputs;
    return ticks;
  }

  Phase phase(std::size_t i) {
    Phase result;
    const auto columns = [&](Rows& state, std::size_t all, std::size_t first, std::size_t count) {
      if (first == 0) state.assign(words_.size(), std::vector<double>(all));
      return [&, first, count](Program& end) {
        for (std::size_t k = 0; k < count; ++k) {
          for (std::size_t row = 0; row < words_.size(); ++row)
            state[row][first + k] = at(end, words_[row]).derivative[k];
        }
      };
    };
    for (std::size_t first = 0; first < words_.size(); first += kSeeds) {
      const std::size_t count = std::min(kSeeds, words_.size() - first);
      std::vector<const Word*> words;
      for (std::size_t k = 0; k < count; ++k) words.push_back(&words_[first + k]);
      const NodeTicks ticks = go(i, words, {}, columns(result.a, words_.size(), first, count));
      take(ticks.received, words_.size(), first, count, result.c);
      take(messages_of(ticks), words_.size(), first, count, result.e);
      result.messages.clear();
      for (const auto& sent : ticks.sent) result.messages.push_back(sent.size());
      result.cut_messages = ticks.cut_messages;
    }
    for (std::size_t first = 0; first < cut_elements_; first += kSeeds) {
      const std::size_t count = std::min(kSeeds, cut_elements_ - first);
      std::vector<std::optional<std::size_t>> elements;
      for (std::size_t k = 0; k < count; ++k) elements.emplace_back(first + k);
      const NodeTicks ticks = go(i, {}, elements, columns(result.b, cut_elements_, first, count));
      take(messages_of(ticks), cut_elements_, first, count, result.f);
    }
    return result;
  }
  static std::vector<NodeTicks::Derivatives> messages_of(const NodeTicks& ticks) {
    std::vector<NodeTicks::Derivatives> all;
    for (const auto& sent : ticks.sent) {
      for (const auto& message : sent) all.insert(all.end(), message.begin(), message.end());
    }
    return all;
  }
  static void take(const std::vector<NodeTicks::Derivatives>& all, std::size_t columns,
                   std::size_t first, std::size_t count, Rows& to) {
    if (first == 0) to.assign(all.size(), std::vector<double>(columns));
    for (std::size_t row = 0; row < all.size() && row < to.size(); ++row)
      std::copy_n(all[row].begin(), count, to[row].begin() + static_cast<std::ptrdiff_t>(first));
  }

  static bool are_finite(const Phase& phase) {
    for (const Rows* const rows : {&phase.a, &phase.b, &phase.c, &phase.e, &phase.f}) {
      if (!linearize::are_finite(*rows)) return false;
    }
    return true;
  }
  static void print_phase(const Phase& phase, bool is_first) {
    std::printf("%s\n{\"cut\": %zu, \"messages\": [", is_first ? "" : ",", phase.cut_messages);
    for (std::size_t i = 0; i < phase.messages.size(); ++i)
      std::printf("%s%zu", i == 0 ? "" : ", ", phase.messages[i]);
    std::printf("]");
    print_matrix("A", phase.a);
    print_matrix("B", phase.b);
    print_matrix("C", phase.c);
    print_matrix("E", phase.e);
    print_matrix("F", phase.f);
    std::printf("}");
  }
  const NodeRequest& request_;
  const Program& start_;
  const std::vector<Word>& words_;
  Step step_;
  std::size_t cut_elements_ = 0;
  std::vector<NodeInput> inputs_;
  std::set<std::uint32_t> losing_, smoothing_;
};

}  // namespace eagerx::linearize
