#include "generator/tools/commands/trim_question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <runtime/host/base/nearest.hpp>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

WrittenCondition written(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  WrittenCondition result{option, text.substr(0, equals), equals != std::string::npos, {}};
  for (std::size_t begin = equals + 1; result.has_numbers && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    char* rest = nullptr;
    const double number = std::strtod(item.c_str(), &rest);
    if (item.empty() || *rest != '\0' || std::isnan(number)) {
      result.numbers.clear();
      break;
    }
    result.numbers.push_back(number);
    begin = end + 1;
  }
  return result;
}

void wrong(Diagnostics& diagnostics, const std::string& message, const Help& help) {
  diagnostics.usage_error("E0521", message).help = help;
}

/// Whether a state, a port, or the owner of a number of the program has this name.
bool may_be_known(const std::string& name, const Plan& plan) {
  const auto states = states_of(*plan.graph);
  if (std::ranges::any_of(states, [&](const NamedState& state) {
        return state.name == name || state.name == without_index(name);
      }))
    return true;
  if (port_named(name, plan)) return true;
  return std::ranges::any_of(plan.graph->nodes,
                             [&](const GraphNode& node) {
                               return name.starts_with(node.name + ".number[") ||
                                      name.starts_with(node.name + ".state[");
                             }) ||
         std::ranges::any_of(plan.graph->objects, [&](const Object& object) {
           return name.starts_with(object.name + ".state[") ||
                  name.starts_with(object.name + ".number[");
         });
}

std::vector<std::string> known_names(const Plan& plan) {
  std::vector<std::string> names;
  for (const NamedState& state : states_of(*plan.graph)) names.push_back(state.name);
  for (const NamedChannel& port : port_names(plan)) names.push_back(port.name);
  return names;
}

/// What a name stands for.
struct NamedNumber {
  enum class Kind { word, input, output } kind;
  std::string name;   // of the number: "pendulum.model_state[1]"
  std::string whole;  // of all that are set at once: "pendulum.model_state"
  std::size_t index;
};

std::vector<NamedNumber> numbers_of(const Hyperperiod& there) {
  std::vector<NamedNumber> all;
  for (const ResetElement& each : there.states) {
    if (each.word != ResetElement::kNone)
      all.push_back({NamedNumber::Kind::word, fmt::format("{}[{}]", each.state, each.element),
                     each.state, each.word});
  }
  const auto add_ports = [&](const std::vector<SampledPort>& ports, NamedNumber::Kind kind) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const std::string whole = without_index(ports[i].name);
      all.push_back({kind, fmt::format("{}[{}]", whole, ports[i].element), whole, i});
    }
  };
  add_ports(there.system.inputs, NamedNumber::Kind::input);
  add_ports(there.system.outputs, NamedNumber::Kind::output);
  for (std::size_t i = 0; i < there.system.state.size(); ++i)
    all.push_back({NamedNumber::Kind::word, there.system.state[i].name, "", i});
  return all;
}

/// The question from the options, for the program as it is after its first steps.
class TrimAsker {
 public:
  TrimAsker(const Hyperperiod& there, const Plan& plan, Diagnostics& diagnostics)
      : there_(there), plan_(plan), diagnostics_(diagnostics), all_(numbers_of(there)) {
    for (const StateWord& word : there.system.state) question_.words.push_back({word.value});
    for (const ResetElement& each : there.states) {
      if (each.word == ResetElement::kNone) continue;
      TrimNumber& number = question_.words[each.word];
      number.value = each.value;
      if (each.low == each.high) continue;  // not sampled, but no number that it has to keep
      if (each.low) number.low = *each.low;
      if (each.high) number.high = *each.high;
    }
    for (const std::size_t word : there.settled) {
      question_.words[word].value = there.system.state[word].value;
      question_.words[word].settled = true;
    }
    for (const SampledPort& port : there.system.inputs) {
      const Space& space = space_of(plan, port.channel);
      TrimNumber number;
      if (port.element < space.low.size()) number.low = space.low[port.element];
      if (port.element < space.high.size()) number.high = space.high[port.element];
      question_.inputs.push_back(number);
    }
  }

  TrimQuestion ask(const std::vector<WrittenCondition>& options) {
    for (const WrittenCondition& each : options) {
      // A bound first: a beginning is compared with it.
      if (each.option == "--bounds") take_bounds(each);
    }
    for (const WrittenCondition& each : options) {
      if (each.option == "--at") take_beginning(each);
      if (each.option == "--fix") take_fixed(each);
      if (each.option == "--moving")
        for (const NamedNumber* number : named(each))
          choose(number_at(*number, each)).moving = true;
    }
    return std::move(question_);
  }

 private:
  /// What the command line names, it asks for.
  static TrimNumber& choose(TrimNumber& number) {
    number.settled = false;
    return number;
  }
  bool is_state(const std::string& name) const {
    const auto states = states_of(*plan_.graph);
    return std::ranges::find(states, name, &NamedState::name) != states.end();
  }
  bool is_known(const std::string& name) const {
    return std::ranges::find(all_, name, &NamedNumber::whole) != all_.end();
  }
  std::vector<const NamedNumber*> named(const WrittenCondition& option) {
    std::vector<const NamedNumber*> found;
    for (const NamedNumber& each : all_) {
      if (each.name == option.name || each.whole == option.name) found.push_back(&each);
    }
    // A port that is an input is not also what is to be observed.
    const auto kind_of_first = found.empty() ? NamedNumber::Kind::word : found.front()->kind;
    std::erase_if(found, [&](const NamedNumber* each) { return each->kind != kind_of_first; });
    if (!found.empty()) return found;
    std::vector<std::string> names;
    for (const NamedNumber& each : all_) names.push_back(each.name);
    wrong(diagnostics_,
          fmt::format("`{} {}`: neither a state nor a port has this name", option.option,
                      option.name),
          suggestion(option.name, names));
    return found;
  }
  TrimNumber& number_at(const NamedNumber& number, const WrittenCondition& option) {
    if (number.kind == NamedNumber::Kind::input) return question_.inputs[number.index];
    if (number.kind == NamedNumber::Kind::word) return question_.words[number.index];
    wrong(diagnostics_, fmt::format("`{} {}`: this port is an output", option.option, option.name),
          "`--fix` gives it a value; `--from` makes it an input");
    return ignored_;
  }
  /// The value for number `i` of `count`; nothing with a problem.
  std::optional<double> value_for(const WrittenCondition& option, std::size_t i,
                                  std::size_t count) {
    if (option.numbers.size() == count) return option.numbers[i];
    if (i == 0)
      wrong(diagnostics_,
            fmt::format("`{} {}`: not one number for each element", option.option, option.name),
            fmt::format("it takes {}", counted(count, "number")));
    return std::nullopt;
  }
  void take_bounds(const WrittenCondition& option) {
    const auto& numbers = option.numbers;
    if (numbers.size() != 2 || numbers[0] > numbers[1]) {
      wrong(diagnostics_, fmt::format("`--bounds {}`: no lower and upper bound", option.name),
            "write `--bounds NAME=LOW,HIGH`; `-inf` and `inf` are none");
      return;
    }
    for (const NamedNumber* each : named(option)) {
      number_at(*each, option).low = numbers[0];
      number_at(*each, option).high = numbers[1];
    }
  }
  void take_beginning(const WrittenCondition& option) {
    if (is_state(option.name) && !is_known(option.name)) return;  // a seed: the reset has set it
    const auto found = named(option);
    for (std::size_t i = 0; i < found.size(); ++i) {
      TrimNumber& number = number_at(*found[i], option);
      const auto value = value_for(option, i, found.size());
      if (!value) return;
      choose(number).value = *value;
      if (*value >= number.low && *value <= number.high) continue;
      wrong(diagnostics_,
            fmt::format("`--at {}`: {:.9g} is not from {:.9g} to {:.9g}", option.name, *value,
                        number.low, number.high),
            fmt::format("`--bounds {}=-inf,inf` removes the bounds of its space", found[i]->name));
    }
  }
  void take_fixed(const WrittenCondition& option) {
    const auto found = named(option);
    for (std::size_t i = 0; i < found.size(); ++i) {
      std::optional<double> value;
      if (option.has_numbers && !(value = value_for(option, i, found.size()))) return;
      if (found[i]->kind == NamedNumber::Kind::output) {
        question_.wanted.push_back(
            {found[i]->index, value.value_or(there_.observed[found[i]->index])});
        continue;
      }
      TrimNumber& number = number_at(*found[i], option);
      choose(number).fixed = true;
      if (value) number.value = *value;
    }
  }

  const Hyperperiod& there_;
  const Plan& plan_;
  Diagnostics& diagnostics_;
  std::vector<NamedNumber> all_;
  TrimQuestion question_;
  TrimNumber ignored_;
};

}  // namespace

std::vector<WrittenCondition> written_options(const TrimSettings& settings,
                                              const LinearOptions& options) {
  std::vector<WrittenCondition> all;
  for (const std::string& text : options.at) all.push_back(written("--at", text));
  for (const std::string& text : settings.fix) all.push_back(written("--fix", text));
  for (const std::string& text : settings.moving) all.push_back(written("--moving", text));
  for (const std::string& text : settings.bounds) all.push_back(written("--bounds", text));
  return all;
}

std::string without_index(const std::string& name) {
  return name.ends_with(']') ? name.substr(0, name.rfind('[')) : name;
}

std::optional<std::size_t> port_named(const std::string& name, const Plan& plan) {
  const auto all = port_names(plan);
  for (const std::string& each : {name, without_index(name)}) {
    const auto found = std::ranges::find(all, each, &NamedChannel::name);
    if (found != all.end()) return found->channel;
  }
  return std::nullopt;
}

bool check_trim(const TrimSettings& settings, const LinearOptions& options, const Plan& plan,
                Diagnostics& diagnostics) {
  for (const std::string& port : settings.from) channel_of(port, "--from", plan, diagnostics);
  for (const WrittenCondition& each : written_options(settings, options)) {
    if ((each.has_numbers || each.option == "--at" || each.option == "--bounds") &&
        each.numbers.empty())
      wrong(diagnostics, fmt::format("`{} {}`: no numbers follow the name", each.option, each.name),
            fmt::format("write `{} NAME=NUMBER,NUMBER`", each.option));
    if (!may_be_known(each.name, plan))
      wrong(
          diagnostics,
          fmt::format("`{} {}`: neither a state nor a port has this name", each.option, each.name),
          suggestion(each.name, known_names(plan)));
  }
  return !diagnostics.has_errors();
}

TrimQuestion trim_question(const Hyperperiod& there, const std::vector<WrittenCondition>& options,
                           const Plan& plan, Diagnostics& diagnostics) {
  return TrimAsker(there, plan, diagnostics).ask(options);
}

}  // namespace eagerx::gen
