// The derivatives of a program between two instants at which all of its rates are due, as JSON.
//
// Every number that the program remembers is a state, in nodes, windows, delays and filters alike.
// Runs with a derivative of 1 in one state at a time give the columns of A. Integers (counters,
// cursors, seeds of noise) have no derivative and run as usual.
#pragma once

#include <algorithm>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <eagerx/channel.hpp>
#include <eagerx/number.hpp>
#include <eagerx/random.hpp>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <targets/linearize/node_system.hpp>
#include <targets/linearize/print.hpp>
#include <targets/linearize/probe.hpp>
#include <targets/linearize/request.hpp>
#include <targets/linearize/reset_states.hpp>
#include <targets/linearize/settling.hpp>
#include <targets/linearize/step_response.hpp>
#include <targets/linearize/words.hpp>
#include <vector>

namespace eagerx::linearize {

/// An input or output: element of the messages of a channel, each or one of a run.
struct Port {
  std::uint32_t channel;
  std::size_t element, message;
};

template <class Graph, class Program, class Action, class States>
class Linearization {
  static_assert(alignof(Program) <= alignof(std::max_align_t), "calloc() aligns no more");

 public:
  explicit Linearization(const Request& request)
      : request_(request), memory_(static_cast<unsigned char*>(std::calloc(1, sizeof(Program)))) {
    static std::vector<const void*> places;
    born = [](const void* number) { places.push_back(number); };
    program_ = new (memory_) Program();
    born = nullptr;
    WordList list(program_, sizeof(Program), places);
    program_->for_each_memory(list);
    words_ = std::move(list.words);
  }
  Linearization(const Linearization&) = delete;
  Linearization& operator=(const Linearization&) = delete;
  ~Linearization() { std::free(memory_); }

  /// False with a message: a derivative is not finite, or `--words` are those of another program.
  bool run(const typename Graph::States& states) {
    // An action has its value and its derivative already.
    for (const Held& held : request_.held) {
      if (Graph::kChannels[held.channel].publisher != Publisher::environment)
        held_ports_.push_back(held);
    }
    program_->hooks.held = &held_ports_;
    has_steps = request_.quantizes;
    States begin = with_derivatives<States>(states);
    Matrix reset;
    if (!request_.compares) fill_reset(begin, reset);
    program_->reset(begin);
    const std::vector<double> after_reset = state_values();
    for (std::uint64_t i = 0; i < request_.steps; ++i) program_->step(action({}, 0));
    if (!set_words()) return false;
    if (request_.words.empty() && !request_.settling.empty()) settle();
    if (!request_.node.node.empty()) return print_node();
    if (request_.step.hyperperiods > 0 && request_.open) return print_step();
    find_ports();
    Matrix a, b, c, d, later, later_c;
    fill_state(a, c);
    fill_inputs(b, d);
    const std::vector<double> values = state_values();
    const std::vector<double> observed = observations();
    next();
    const std::vector<double> next_values = state_values();
    if (request_.compares) fill_state(later, later_c);
    next();
    const std::vector<double> values_after = state_values();
    for (const Matrix* const each : {&a, &b, &c, &d, &later}) {
      if (!are_finite(*each)) return refuse(a, c);
    }
    print(values, a, b, c, d);
    if (request_.compares) {
      print_matrix("later", later);
    } else {
      print_matrix("values", {after_reset, next_values, observed, values_after});
      print_states<Graph>(states);
      print_matrix("reset", reset);
      print_list("settled", settled_);
    }
    std::printf("}\n");
    return true;
  }

 private:
  static constexpr std::size_t kChannels = std::size(Graph::kChannels);

  bool print_step() {
    has_steps = true;  // what the program does
    const auto step = [this](Program& program) { program.step(action({}, 0)); };
    print_step_response(*program_, request_.step, *request_.open, request_.element, step);
    return true;
  }
  /// Prints the system from each tick of a node to the next.
  bool print_node() {
    const auto step = [this](Program& program) { program.step(action({}, 0)); };
    return NodeSystem(request_.node, *program_, words_, step)
        .print(Graph::Rate::period_s * Program::kPhases);
  }

  /// Runs one hyperperiod with these derivatives from the program's current state; returns the
  /// program after it. `seeds`: of the messages, by derivative; `words`: of the state.
  std::unique_ptr<Program> go(const std::vector<const Seed*>& seeds,
                              const std::vector<const Word*>& words) {
    auto copy = std::make_unique<Program>(*program_);
    record_ = {};
    record_.channels.resize(kChannels);
    record_.opened = settles_ ? std::nullopt : request_.open;
    record_.opened_element = request_.element;
    record_.seeds = seeds;
    for (const Seed*& seed : record_.seeds) {  // an action has its derivative already
      if (seed != nullptr && Graph::kChannels[seed->channel].publisher == Publisher::environment)
        seed = nullptr;
    }
    for (std::size_t k = 0; k < words.size(); ++k) {
      if (words[k] != nullptr) at(*copy, *words[k]).derivative[k] = 1.0;
    }
    copy->hooks.record = &record_;
    doings = {};  // of runs without a record
    for (std::uint32_t i = 0; i < Program::kPhases; ++i) copy->step(action(seeds, i));
    copy->hooks.record = nullptr;
    losing_.insert(record_.losing.begin(), record_.losing.end());
    smoothing_.insert(record_.smoothing.begin(), record_.smoothing.end());
    return copy;
  }

  /// An action with its seeds. Readers of actions get a copy of the message that the trace sees, so
  /// probes cannot add derivatives there.
  Action action(const std::vector<const Seed*>& seeds, std::size_t message) const {
    Action result{};
    std::uint32_t channel = 0;
    result.for_each([&](const char* name, const auto& each) {
      while (channel < kChannels && !is_action(channel, name)) ++channel;
      using Message = std::remove_cvref_t<decltype(each)>;
      for (const Held& held : request_.held) {
        if (held.channel == channel && held.element < size_of<Message>)
          element(const_cast<Message&>(each), held.element) = scalar<ScalarOf<Message>>(held.value);
      }
      if constexpr (std::is_same_v<ScalarOf<Message>, Number>) {
        for (std::size_t k = 0; k < seeds.size(); ++k) {
          const Seed* const seed = seeds[k];
          if (seed != nullptr && seed->channel == channel &&
              (seed->message == Seed::kEach || seed->message == message))
            element(const_cast<Message&>(each), seed->element).derivative[k] += 1.0;
        }
      }
      channel = 0;
    });
    return result;
  }
  static bool is_action(std::uint32_t channel, std::string_view name) {
    return Graph::kChannels[channel].publisher == Publisher::environment &&
           std::string_view(Graph::kChannels[channel].name) == "environment/" + std::string(name);
  }

  void find_ports() {
    go({}, {});
    const auto each = [&](std::uint32_t channel, auto f) {
      const auto& sent = record_.channels[channel];
      if (sent.empty()) return;
      for (std::size_t i = 0; i < sent.front().derivatives.size(); ++i) f(i, sent.size());
    };
    for (const std::uint32_t channel : request_.from)
      each(channel, [&](std::size_t i, std::size_t) {
        inputs_.push_back({channel, i, Seed::kEach});
      });
    for (const std::uint32_t channel : request_.to)
      each(channel, [&](std::size_t i, std::size_t all) {
        outputs_.push_back({channel, i, all - 1});
      });
    if (!request_.open) return;
    opened_ = outputs_.size();
    each(*request_.open, [&](std::size_t i, std::size_t all) {
      if (i != request_.element) return;
      for (std::size_t n = 0; n < all; ++n) {
        inputs_.push_back({*request_.open, i, n});
        outputs_.push_back({*request_.open, i, n});
      }
    });
  }

  /// Fills the columns from runs, kSeeds at a time.
  void fill_state(Matrix& a, Matrix& c) {
    a.assign(words_.size(), std::vector<double>(words_.size()));
    c.assign(outputs_.size(), std::vector<double>(words_.size()));
    for (std::size_t first = 0; first < words_.size(); first += kSeeds) {
      std::vector<const Word*> words;
      for (std::size_t k = first; k < words_.size() && k < first + kSeeds; ++k)
        words.push_back(&words_[k]);
      const auto end = go({}, words);
      read(*end, first, words.size(), a, c);
    }
  }
  void fill_inputs(Matrix& b, Matrix& d) {
    b.assign(words_.size(), std::vector<double>(inputs_.size()));
    d.assign(outputs_.size(), std::vector<double>(inputs_.size()));
    for (std::size_t first = 0; first < inputs_.size(); first += kSeeds) {
      std::vector<Seed> seeds;
      for (std::size_t k = first; k < inputs_.size() && k < first + kSeeds; ++k)
        seeds.push_back({inputs_[k].channel, inputs_[k].element, inputs_[k].message});
      std::vector<const Seed*> pointers;
      for (const Seed& seed : seeds) pointers.push_back(&seed);
      const auto end = go(pointers, {});
      read(*end, first, seeds.size(), b, d);
    }
  }
  void read(Program& end, std::size_t first, std::size_t count, Matrix& state, Matrix& output) {
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < words_.size(); ++i)
        state[i][first + k] = at(end, words_[i]).derivative[k];
      for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const Port& port = outputs_[i];
        output[i][first + k] =
            record_.channels[port.channel][port.message].derivatives[port.element][k];
      }
    }
  }

  /// Numbers of nodes that no other number and no input has an effect on, and that do not rest:
  /// their values are those to which they settle while everything else stays. By node.
  void settle() {
    const std::vector<double> begin = state_values();
    const auto end = after_hyperperiod();
    std::vector<bool> moves;
    std::vector<std::ptrdiff_t> nodes;
    bool any = false;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      nodes.push_back(request_.settling_index(words_[i].owner));
      moves.push_back(at(*end, words_[i]).value != begin[i]);
      any = any || (nodes[i] >= 0 && moves[i]);
    }
    if (!any) return;
    settles_ = true;
    Matrix a, unused;
    fill_state(a, unused);
    for (const auto& own : independent_numbers(a, nodes, moves, independent_of_inputs()))
      settle(own);
    settles_ = false;
  }
  /// Those of one node.
  void settle(const std::vector<std::size_t>& own) {
    using Numbers = Settling::Numbers;
    const auto set = [&](const Numbers& x) {
      for (std::size_t i = 0; i < own.size(); ++i) at(*program_, words_[own[i]]) = Number(x[i]);
    };
    const auto map = [&](const Numbers& x) {
      set(x);
      const auto end = after_hyperperiod();
      Numbers next;
      for (const std::size_t i : own) next.push_back(at(*end, words_[i]).value);
      return next;
    };
    const auto slopes = [&](const Numbers& x) {
      set(x);
      Matrix columns(own.size(), Numbers(own.size()));
      for (std::size_t first = 0; first < own.size(); first += kSeeds) {
        std::vector<const Word*> words;
        for (std::size_t k = first; k < own.size() && k < first + kSeeds; ++k)
          words.push_back(&words_[own[k]]);
        const auto end = go({}, words);
        for (std::size_t i = 0; i < own.size(); ++i) {
          for (std::size_t k = 0; k < words.size(); ++k)
            columns[i][first + k] = at(*end, words_[own[i]]).derivative[k];
        }
      }
      return columns;
    };
    Numbers begin, x;
    for (const std::size_t i : own) begin.push_back(at(*program_, words_[i]).value);
    x = begin;
    const bool settles = Settling(map, slopes).run(x);
    set(settles ? x : begin);
    if (settles) settled_.insert(settled_.end(), own.begin(), own.end());
  }
  std::unique_ptr<Program> after_hyperperiod() const {
    auto copy = std::make_unique<Program>(*program_);
    for (std::uint32_t i = 0; i < Program::kPhases; ++i) copy->step(action({}, i));
    return copy;
  }
  /// By number of the program: neither an action nor a port of `--from` has an effect on it.
  std::vector<bool> independent_of_inputs() {
    go({}, {});
    for (std::uint32_t channel = 0; channel < kChannels; ++channel) {
      const auto& sent = record_.channels[channel];
      const bool is_input = Graph::kChannels[channel].publisher == Publisher::environment ||
                            std::count(request_.from.begin(), request_.from.end(), channel) > 0;
      for (std::size_t i = 0; is_input && !sent.empty() && i < sent.front().derivatives.size(); ++i)
        inputs_.push_back({channel, i, Seed::kEach});
    }
    Matrix b, unused;
    fill_inputs(b, unused);
    inputs_.clear();
    std::vector<bool> independent;
    for (const auto& row : b)
      independent.push_back(std::all_of(row.begin(), row.end(), [](double x) { return x == 0.0; }));
    return independent;
  }

  void next() {
    const auto end = go({}, {});
    *program_ = *end;
  }

  /// Derivatives of the numbers after a reset by the elements of the states that it sets.
  void fill_reset(const States& begin, Matrix& reset) {
    States counted = begin;
    const std::size_t elements = count_elements(counted);
    reset.assign(words_.size(), std::vector<double>(elements));
    for (std::size_t first = 0; first < elements; first += kSeeds) {
      auto copy = std::make_unique<Program>(*program_);
      States seeded = begin;
      seed_elements(seeded, first);
      copy->reset(seeded);
      for (std::size_t k = first; k < elements && k < first + kSeeds; ++k) {
        for (std::size_t i = 0; i < words_.size(); ++i)
          reset[i][k] = at(*copy, words_[i]).derivative[k - first];
      }
    }
  }

  /// The state that the command line has.
  bool set_words() {
    if (request_.words.empty()) return true;
    if (request_.words.size() != words_.size()) {
      std::fprintf(stderr, "error: `--words` has %zu numbers, and the program %zu\n",
                   request_.words.size(), words_.size());
      return false;
    }
    for (std::size_t i = 0; i < words_.size(); ++i)
      at(*program_, words_[i]) = Number(request_.words[i]);
    return true;
  }

  /// Values of the outputs in the hyperperiod that comes.
  std::vector<double> observations() {
    go({}, {});
    std::vector<double> values;
    for (const Port& port : outputs_)
      values.push_back(record_.channels[port.channel][port.message].values[port.element]);
    return values;
  }

  std::vector<double> state_values() const {
    std::vector<double> values;
    for (const Word& word : words_) {
      const double value = at(*program_, word).value;
      values.push_back(eagerx::isfinite(value) ? value : 0.0);
    }
    return values;
  }

  bool refuse(const Matrix& a, const Matrix& c) const {
    std::fprintf(stderr, "error: derivatives at this point are not finite");
    for (std::size_t k = 0; k < words_.size(); ++k) {
      const auto is_finite = [k](const std::vector<double>& row) {
        return eagerx::isfinite(row[k]);
      };
      if (std::all_of(a.begin(), a.end(), is_finite) && std::all_of(c.begin(), c.end(), is_finite))
        continue;
      std::fprintf(stderr, ": those by `%s`", words_[k].name.c_str());
      break;
    }
    std::fprintf(stderr,
                 "\nhelp: choose another point with `--at`, or fewer `--steps` if the graph "
                 "diverges; the root and the angle of 0 have no derivative\n");
    return false;
  }

  void print_ports(const char* name, const std::vector<Port>& ports) const {
    std::printf(",\n\"%s\": [", name);
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const Port& port = ports[i];
      std::printf(
          "%s\n[%" PRIu32 ", %zu, %" PRId64 "]", i == 0 ? "" : ",", port.channel, port.element,
          port.message == Seed::kEach ? std::int64_t{-1} : static_cast<std::int64_t>(port.message));
    }
    std::printf("]");
  }

  void print(const std::vector<double>& values, const Matrix& a, const Matrix& b, const Matrix& c,
             const Matrix& d) {
    using Rate = typename Graph::Rate;
    std::printf("{\"period_s\": %.17g,\n\"steps\": %" PRIu32 ",\n\"state\": [",
                Rate::period_s * Program::kPhases, Program::kPhases);
    for (std::size_t i = 0; i < words_.size(); ++i)
      std::printf("%s\n[\"%s\", %.17g, %d]", i == 0 ? "" : ",", words_[i].name.c_str(), values[i],
                  words_[i].clock >= 0 ? 1 : 0);
    std::printf("]");
    print_ports("inputs", inputs_);
    print_ports("outputs", outputs_);
    std::printf(",\n\"opened\": %zu", request_.open ? opened_ : outputs_.size());
    print_list("losing", losing_);
    print_list("smoothing", smoothing_);
    print_matrix("A", a);
    print_matrix("B", b);
    print_matrix("C", c);
    print_matrix("D", d);
  }

  const Request& request_;
  unsigned char* memory_;
  Program* program_ = nullptr;
  std::vector<Word> words_;
  std::vector<Held> held_ports_;  // of `--hold`, without the actions
  std::vector<Port> inputs_, outputs_;
  std::size_t opened_ = 0;
  std::set<std::uint32_t> losing_, smoothing_;
  bool settles_ = false;              // the loop is closed then, wherever it is to be opened
  std::vector<std::size_t> settled_;  // of words_
  Record record_;
};

/// The exit code.
template <class Graph, class Program, class Action, class States>
int run(int argc, char** argv) {
  constexpr int kProblems = 1, kWrongUsage = 2;
  const auto request = read_request(argc, argv);
  if (!request) return kWrongUsage;
  typename Graph::States states = Graph::sample(EpisodeKey{request->seed, 0, 0});
  for (const std::string& text : request->at) {
    if (!set_state<Graph>(text, states)) return kWrongUsage;
  }
  Linearization<Graph, Program, Action, States> linearization(*request);
  return linearization.run(states) ? 0 : kProblems;
}

}  // namespace eagerx::linearize
