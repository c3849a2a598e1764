// The derivatives of a program between two instants at which all of its rates are due, as JSON.
//
// Every number that the program remembers is a state, whatever node, window, delay or filter it
// belongs to; runs with a derivative of 1 in one of them after the other give the columns of A.
// Integers (counters, cursors, seeds of noise) have no derivative and run as they always do.
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
#include <targets/linearize/probe.hpp>
#include <targets/linearize/words.hpp>
#include <vector>

namespace eagerx::linearize {

/// What the command line says: channels by their numbers in the graph.
struct Request {
  std::uint64_t steps = 0, seed = 0;
  std::vector<std::string> at;  // NAME=VALUE,…
  std::vector<std::uint32_t> from, to;
  std::optional<std::uint32_t> open;  // what readers get of it has no derivative of what is sent
  std::size_t element = 0;            // of its messages
};

/// Nothing with a message where the command line is not as eagerx-gen writes it.
inline std::optional<Request> read_request(int argc, char** argv) {
  Request request;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const auto number = [&] { return std::strtoull(argv[i + 1], nullptr, 10); };
    const auto channel = [&] { return static_cast<std::uint32_t>(number()); };
    if (name == "--steps") {
      request.steps = number();
    } else if (name == "--seed") {
      request.seed = number();
    } else if (name == "--at") {
      request.at.emplace_back(argv[i + 1]);
    } else if (name == "--from") {
      request.from.push_back(channel());
    } else if (name == "--to") {
      request.to.push_back(channel());
    } else if (name == "--open") {
      request.open = channel();
    } else if (name == "--element") {
      request.element = number();
    } else {
      std::fprintf(stderr, "error: there is no option `%s`\n", argv[i]);
      return std::nullopt;
    }
  }
  return request;
}

/// Sets a state as `--at` says; false with a message.
template <class Graph>
bool set_state(const std::string& text, typename Graph::States& states) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  bool is_known = false, fits = true;
  Graph::for_each_state([&](const char* state, const char*, auto member, const auto& space) {
    if (name != state) return;
    is_known = true;
    auto message = space.low;
    const char* rest = text.c_str() + equals + 1;
    for (std::size_t i = 0; i < size_of<decltype(message)>; ++i) {
      char* end = nullptr;
      const double value = std::strtod(rest, &end);
      fits = fits && end != rest && (*end == ',' || *end == '\0') && eagerx::isfinite(value);
      element(message, i) = static_cast<ScalarOf<decltype(message)>>(value);
      rest = *end == ',' ? end + 1 : end;
    }
    fits = fits && *rest == '\0';
    states.*member = message;
  });
  if (equals != std::string::npos && is_known && fits) return true;
  std::fprintf(
      stderr, "error: `--at %s`: %s\nhelp: states are", text.c_str(),
      is_known ? "not one finite number for each element of the state" : "there is no such state");
  const char* separator = " ";
  Graph::for_each_state([&](const char* state, const char*, auto, const auto& space) {
    std::fprintf(stderr, "%s`%s` (%zu)", separator, state, size_of<decltype(space.low)>);
    separator = ", ";
  });
  std::fprintf(stderr, "\n");
  return false;
}

/// The states of the program for plain numbers, in numbers with derivatives.
template <class States, class PlainStates>
States with_derivatives(PlainStates plain) {
  std::vector<std::optional<std::vector<long double>>> values;
  plain.for_each([&](const char*, const auto& message) {
    auto& value = values.emplace_back();
    if (!message) return;
    value.emplace();
    for (std::size_t i = 0; i < size_of<std::remove_reference_t<decltype(*message)>>; ++i)
      value->push_back(static_cast<long double>(element(*message, i)));
  });
  States states;
  std::size_t next = 0;
  states.for_each([&](const char*, auto& message) {
    const auto& value = values[next++];
    if (!value) return;
    auto& set = message.emplace();
    using Scalar = ScalarOf<std::remove_reference_t<decltype(set)>>;
    using Plain = std::conditional_t<std::is_same_v<Scalar, Number>, double, Scalar>;
    for (std::size_t i = 0; i < value->size(); ++i)
      element(set, i) = Scalar(static_cast<Plain>((*value)[i]));
  });
  return states;
}

/// Numbers in rows of JSON.
using Matrix = std::vector<std::vector<double>>;
inline void print_matrix(const char* name, const Matrix& matrix) {
  std::printf(",\n\"%s\": [", name);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    std::printf(i == 0 ? "\n[" : ",\n[");
    for (std::size_t k = 0; k < matrix[i].size(); ++k)
      std::printf(k == 0 ? "%.17g" : ", %.17g", matrix[i][k]);
    std::printf("]");
  }
  std::printf("]");
}

inline bool are_finite(const Matrix& matrix) {
  return std::all_of(matrix.begin(), matrix.end(), [](const std::vector<double>& row) {
    return std::all_of(row.begin(), row.end(), [](double x) { return eagerx::isfinite(x); });
  });
}

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

  /// False with a message: a derivative is not finite.
  bool run(const typename Graph::States& states) {
    States begin = with_derivatives<States>(states);
    program_->reset(begin);
    for (std::uint64_t i = 0; i < request_.steps; ++i) program_->step(Action{});
    find_ports();
    Matrix a, b, c, d, later, later_c;
    fill_state(a, c);
    fill_inputs(b, d);
    const std::vector<double> values = state_values();
    next();
    fill_state(later, later_c);
    for (const Matrix* const each : {&a, &b, &c, &d, &later}) {
      if (!are_finite(*each)) return refuse(a, c);
    }
    print(values, a, b, c, d);
    print_matrix("later", later);
    std::printf("}\n");
    return true;
  }

 private:
  static constexpr std::size_t kChannels = std::size(Graph::kChannels);

  /// One hyperperiod with these derivatives, from where the program is; the program as it is then.
  /// `seeds`: of the messages, by derivative; `words`: of the state.
  std::unique_ptr<Program> go(const std::vector<const Seed*>& seeds,
                              const std::vector<const Word*>& words) {
    auto copy = std::make_unique<Program>(*program_);
    record_ = {};
    record_.channels.resize(kChannels);
    record_.opened = request_.open;
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
    for (std::uint32_t i = 0; i < Program::kPhases; ++i) copy->step(action(seeds, i));
    copy->hooks.record = nullptr;
    losing_.insert(record_.losing.begin(), record_.losing.end());
    smoothing_.insert(record_.smoothing.begin(), record_.smoothing.end());
    return copy;
  }

  /// What readers of actions get is not what the trace sees, but a copy of it.
  Action action(const std::vector<const Seed*>& seeds, std::size_t message) const {
    Action result{};
    std::uint32_t channel = 0;
    result.for_each([&](const char* name, const auto& each) {
      while (channel < kChannels && !is_action(channel, name)) ++channel;
      using Message = std::remove_cvref_t<decltype(each)>;
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

  /// The columns that runs give, kSeeds at a time.
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

  void next() {
    const auto end = go({}, {});
    *program_ = *end;
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

  static void print_channels(const char* name, const std::set<std::uint32_t>& channels) {
    std::printf(",\n\"%s\": [", name);
    const char* separator = "";
    for (const std::uint32_t channel : channels) {
      std::printf("%s%" PRIu32, separator, channel);
      separator = ", ";
    }
    std::printf("]");
  }

  void print(const std::vector<double>& values, const Matrix& a, const Matrix& b, const Matrix& c,
             const Matrix& d) {
    using Rate = typename Graph::Rate;
    std::printf("{\"period_s\": %.17g,\n\"steps\": %" PRIu32 ",\n\"state\": [",
                Rate::period_s * Program::kPhases, Program::kPhases);
    for (std::size_t i = 0; i < words_.size(); ++i)
      std::printf("%s\n[\"%s\", %.17g]", i == 0 ? "" : ",", words_[i].name.c_str(), values[i]);
    std::printf("]");
    print_ports("inputs", inputs_);
    print_ports("outputs", outputs_);
    std::printf(",\n\"opened\": %zu", request_.open ? opened_ : outputs_.size());
    print_channels("losing", losing_);
    print_channels("smoothing", smoothing_);
    print_matrix("A", a);
    print_matrix("B", b);
    print_matrix("C", c);
    print_matrix("D", d);
  }

  const Request& request_;
  unsigned char* memory_;
  Program* program_ = nullptr;
  std::vector<Word> words_;
  std::vector<Port> inputs_, outputs_;
  std::size_t opened_ = 0;
  std::set<std::uint32_t> losing_, smoothing_;
  Record record_;
};

/// The exit code.
template <class Graph, class Program, class Action, class States>
int run(int argc, char** argv) {
  constexpr int kProblems = 1, kWrongUsage = 2;
  const auto request = read_request(argc, argv);
  if (!request) return kWrongUsage;
  typename Graph::States states = Graph::draw(EpisodeKey{request->seed, 0, 0});
  for (const std::string& text : request->at) {
    if (!set_state<Graph>(text, states)) return kWrongUsage;
  }
  Linearization<Graph, Program, Action, States> linearization(*request);
  return linearization.run(states) ? 0 : kProblems;
}

}  // namespace eagerx::linearize
