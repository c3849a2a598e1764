#include "generator/tools/linear/trim_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostShown = 20;  // of nodes, on a screen

bool is_state(const Hyperperiod& hyperperiod, std::size_t word) {
  return std::ranges::any_of(hyperperiod.states,
                             [word](const ResetElement& each) { return each.word == word; });
}

bool is_parameter(const TrimReport& report, std::size_t word) {
  return is_constant(report.answer.there.system, word) && report.answer.residual[word] == 0.0;
}
/// A number of a node that matters: no parameter, and no message in flight.
bool is_shown(const TrimReport& report, std::size_t word) {
  const SampledSystem& system = report.answer.there.system;
  if (system.state[word].is_message || is_state(report.answer.there, word)) return false;
  const auto is_read = [word](const std::vector<double>& row) { return row[word] != 0.0; };
  return std::ranges::any_of(system.a, is_read) && !is_parameter(report, word);
}

std::string how(const TrimReport& report, const TrimNumber& number, double value) {
  std::string text;
  if (number.fixed) text += ", fixed";
  if (number.moving) text += ", may move";
  const bool is_outside = value < number.low || value > number.high;
  if (is_outside) text += fmt::format(", outside of {:.6g} to {:.6g}", number.low, number.high);
  for (const ReachedBound& bound : report.answer.bounds) {
    const auto& numbers = bound.is_input ? report.question.inputs : report.question.words;
    if (&numbers[bound.index] == &number) text += ", at its bound";
  }
  return text.empty() ? text : text.substr(2);
}

std::string line(const std::string& name, double value, double per_s, const std::string& remark) {
  std::string text = fmt::format("  {:<34} {:>16.10g} {:>12.3g}/s  {}", name, value, per_s, remark);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

std::string port_name(const SampledPort& port) {
  return port.unit.empty() ? port.name : fmt::format("{} [{}]", port.name, port.unit);
}

double per_second(const TrimReport& report, std::size_t word) {
  const TrimAnswer& answer = report.answer;
  return (answer.there.next[word] - answer.words[word]) / answer.there.system.period_s;
}

std::string states_text(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  std::string text;
  for (const ResetElement& each : answer.there.states) {
    if (each.word == ResetElement::kNone || is_parameter(report, each.word)) continue;
    const TrimNumber& number = report.question.words[each.word];
    text += line(name_of_word(answer.there, each.word), answer.words[each.word],
                 per_second(report, each.word), how(report, number, answer.words[each.word]));
  }
  std::size_t shown = 0, more = 0;
  for (std::size_t word = 0; word < answer.words.size(); ++word) {
    if (!is_shown(report, word)) continue;
    if (++shown > kMostShown) {
      ++more;
      continue;
    }
    text += line(name_of_word(answer.there, word), answer.words[word], per_second(report, word),
                 how(report, report.question.words[word], answer.words[word]));
  }
  if (more > 0) text += fmt::format("  and {} more: `--format json` has them\n", more);
  return text.empty() ? text
                      : fmt::format("\n  {:<34} {:>16} {:>14}\n", "state", "value", "rate") + text;
}

std::string ports_text(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  const SampledSystem& system = answer.there.system;
  std::string text;
  for (std::size_t i = 0; i < system.inputs.size(); ++i) {
    if (i == 0) text += "\n  input\n";
    std::string row =
        fmt::format("  {:<34} {:>16.10g}  {}", port_name(system.inputs[i]), answer.inputs[i],
                    how(report, report.question.inputs[i], answer.inputs[i]));
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  for (std::size_t i = 0; i < system.outputs.size(); ++i) {
    if (i == 0) text += "\n  output\n";
    text += fmt::format("  {:<34} {:>16.10g}\n", port_name(system.outputs[i]),
                        answer.there.observed[i]);
  }
  return text;
}

std::vector<std::string> free_names(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  std::vector<std::string> names, others;
  for (const std::size_t input : answer.free_inputs)
    names.push_back(answer.there.system.inputs[input].name);
  for (const std::size_t word : answer.free_words)
    (is_state(answer.there, word) ? names : others).push_back(name_of_word(answer.there, word));
  return names.empty() ? others : names;
}

Json number_json(const TrimNumber& number) {
  const auto bound = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  return Json{{"fixed", number.fixed},
              {"moving", number.moving},
              {"low", bound(number.low)},
              {"high", bound(number.high)}};
}

}  // namespace

std::string name_of_word(const Hyperperiod& hyperperiod, std::size_t word) {
  std::size_t size = 0;
  const ResetElement* found = nullptr;
  for (const ResetElement& each : hyperperiod.states) {
    if (each.word == word) found = &each;
  }
  if (found == nullptr) return hyperperiod.system.state[word].name;
  for (const ResetElement& each : hyperperiod.states) size += each.state == found->state ? 1 : 0;
  return size == 1 ? found->state : fmt::format("{}[{}]", found->state, found->element);
}

std::vector<std::string> bounds_text(const TrimReport& report) {
  std::vector<std::string> texts;
  for (const ReachedBound& each : report.answer.bounds) {
    const auto& numbers = each.is_input ? report.question.inputs : report.question.words;
    const bool is_low = each.bound <= numbers[each.index].low;
    texts.push_back(fmt::format("`{}` {} {:.9g}",
                                each.is_input ? report.answer.there.system.inputs[each.index].name
                                              : name_of_word(report.answer.there, each.index),
                                is_low ? ">=" : "<=", each.bound));
  }
  return texts;
}

std::vector<std::string> residuals_text(const TrimReport& report, std::size_t most) {
  const TrimAnswer& answer = report.answer;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < answer.residual.size(); ++i) {
    if (std::abs(answer.residual[i]) > 1e-9) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    // Messages repeat what states do.
    const bool a_is = answer.there.system.state[a].is_message;
    const bool b_is = answer.there.system.state[b].is_message;
    return a_is != b_is ? b_is : std::abs(answer.residual[a]) > std::abs(answer.residual[b]);
  });
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < order.size() && k < most; ++k)
    texts.push_back(fmt::format("`{}` changes by {:.3g}/s", name_of_word(answer.there, order[k]),
                                answer.residual[order[k]] / answer.there.system.period_s));
  for (const WantedOutput& wanted : report.question.wanted) {
    const double error = answer.there.observed[wanted.output] - wanted.value;
    if (std::abs(error) > 1e-9 * std::max(1.0, std::abs(wanted.value)))
      texts.push_back(fmt::format("`{}` is {:.9g}, not {:.9g}",
                                  answer.there.system.outputs[wanted.output].name,
                                  answer.there.observed[wanted.output], wanted.value));
  }
  return texts;
}

std::vector<std::string> clocks_in(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < answer.residual.size(); ++i) {
    if (is_constant(answer.there.system, i) && std::abs(answer.residual[i]) > 1e-9)
      names.push_back("`" + name_of_word(answer.there, i) + "`");
  }
  return names;
}

std::string trim_text(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  std::string text = fmt::format(
      "{} of {}, over {:.9g} s ({}), after {} evaluations\n",
      answer.found ? "operating point" : "nearest point to an operating point", report.graph,
      answer.there.system.period_s, counted(answer.there.system.steps, "step"), answer.evaluations);
  text += states_text(report) + ports_text(report);
  const std::vector<std::string> free = free_names(report);
  if (answer.found && answer.freedoms > 0)
    text += fmt::format("\none of many points: {} more can be fixed, of {}\n",
                        counted(answer.freedoms, "number"), join(free, ", "));
  if (!answer.there.system.smoothing.empty())
    text += fmt::format("\nthese nodes count without their quantization: {}\n",
                        join(answer.there.system.smoothing, ", "));
  if (!answer.found) return text;
  text += fmt::format("\nlinearize it:  {}\n", report.command);
  if (!report.program_options.empty())
    text += fmt::format("begin there:   {}\n", report.program_options);
  return text;
}

Json trim_json(const TrimReport& report) {
  const TrimAnswer& answer = report.answer;
  const SampledSystem& system = answer.there.system;
  Json states = Json::list(), numbers = Json::list(), inputs = Json::list(), outputs = Json::list();
  for (std::size_t word = 0; word < answer.words.size(); ++word) {
    Json item{{"name", name_of_word(answer.there, word)},
              {"value", answer.words[word]},
              {"rate", per_second(report, word)}};
    Json about = number_json(report.question.words[word]);
    for (const JsonMember& each : *about.as<Json::Object>()) item[each.name] = each.value;
    item["moving"] = static_cast<bool>(answer.moves[word]);
    const bool state = is_state(answer.there, word) && !is_parameter(report, word);
    if (state)
      states.push_back(std::move(item));
    else if (is_shown(report, word))
      numbers.push_back(std::move(item));
  }
  for (std::size_t i = 0; i < system.inputs.size(); ++i) {
    Json item{{"name", system.inputs[i].name},
              {"unit", system.inputs[i].unit},
              {"value", answer.inputs[i]}};
    Json about = number_json(report.question.inputs[i]);
    for (const JsonMember& each : *about.as<Json::Object>()) item[each.name] = each.value;
    inputs.push_back(std::move(item));
  }
  for (std::size_t i = 0; i < system.outputs.size(); ++i)
    outputs.push_back(Json{{"name", system.outputs[i].name},
                           {"unit", system.outputs[i].unit},
                           {"value", answer.there.observed[i]}});
  return Json{{"found", answer.found},
              {"evaluations", answer.evaluations},
              {"period_s", system.period_s},
              {"states", std::move(states)},
              {"numbers", std::move(numbers)},
              {"inputs", std::move(inputs)},
              {"outputs", std::move(outputs)},
              {"bounds", bounds_text(report)},
              {"residuals", residuals_text(report, answer.residual.size())},
              {"freedoms", answer.freedoms},
              {"free", free_names(report)},
              {"without_steps", system.smoothing},
              {"linearize", report.command},
              {"set", report.program_options}};
}

}  // namespace eagerx::gen
