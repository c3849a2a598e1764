#include "generator/tools/commands/trim_point.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/driver/commands/arguments.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// Channels that are inputs.
std::vector<std::size_t> inputs_of(const TrimSettings& settings, const Plan& plan) {
  std::vector<std::size_t> channels;
  for (const std::string& port : settings.from) {
    if (const auto channel = port_named(port, plan)) channels.push_back(*channel);
  }
  const GraphNode& environment = plan.graph->environment();
  for (std::size_t a = 0; settings.from.empty() && a < environment.outputs.size(); ++a)
    channels.push_back(channel_at(plan, Graph::kEnvironment, a));
  std::erase_if(channels, [&](std::size_t channel) {
    return channel >= plan.channels.size() || !is_floating(space_of(plan, channel).dtype);
  });
  return channels;
}

std::vector<std::string> with_point(std::vector<std::string> words, const SampledSystem& system,
                                    const std::vector<double>& numbers,
                                    const std::vector<double>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i)
    words.insert(words.end(), {"--hold", fmt::format("{}:{}={:.17g}", system.inputs[i].channel,
                                                     system.inputs[i].element, inputs[i])});
  std::string all;
  for (const double x : numbers) all += fmt::format("{}{:.17g}", all.empty() ? "" : ",", x);
  if (!all.empty()) words.insert(words.end(), {"--words", all});
  return words;
}

/// NAME=VALUE,… of each state that a reset sets, where it is no parameter.
std::vector<std::string> settings_of(const TrimAnswer& answer) {
  std::vector<std::string> settings;
  const auto& states = answer.there.states;
  for (std::size_t i = 0; i < states.size();) {
    std::string text = states[i].state + "=";
    bool is_known = true, changes = false;
    std::size_t k = i;
    for (; k < states.size() && states[k].state == states[i].state; ++k) {
      const std::size_t word = states[k].word;
      is_known = is_known && word != ResetElement::kNone;
      if (!is_known) continue;
      changes = changes || !is_constant(answer.there.system, word);
      text += fmt::format("{}{}", k == i ? "" : ",", answer.words[word]);
    }
    if (is_known && changes) settings.push_back(text);
    i = k;
  }
  return settings;
}

/// The command that finds this point again, with what was asked: it begins there.
std::string command_for(const TrimReport& report, const TrimSettings& settings,
                        const LinearOptions& options) {
  std::string text = "eagerx-gen linearize " + shell_word(options.graph) + " --trim";
  const auto add = [&](const char* option, const std::string& value) {
    text += fmt::format(" {} {}", option, shell_word(value));
  };
  std::vector<std::string> begun = settings_of(report.answer);
  const auto& inputs = report.answer.there.system.inputs;
  for (std::size_t i = 0; settings.from.empty() && i < inputs.size(); ++i)
    begun.push_back(fmt::format("{}={}", inputs[i].name, report.answer.inputs[i]));
  // Parameters keep what they were given.
  for (const std::string& each : options.at) {
    const std::string name = without_index(each.substr(0, each.find('=')));
    if (std::ranges::none_of(begun, [&](const std::string& one) { return one.starts_with(name); }))
      add("--at", each);
  }
  for (const std::string& each : begun) add("--at", each);
  for (const std::string& each : settings.fix) add("--fix", each);
  for (const std::string& each : settings.moving) add("--moving", each);
  for (const std::string& each : settings.bounds) add("--bounds", each);
  if (!options.variant.empty()) add("--variant", options.variant);
  if (!options.engine.empty()) add("--engine", options.engine);
  return text;
}

/// Says what keeps the graph from resting.
void explain_failure(const TrimReport& report, const Plan& plan, Diagnostics& diagnostics) {
  const auto residuals = residuals_text(report, 5), bounds = bounds_text(report);
  auto& error = diagnostics.error(
      "E0521", plan.graph->span,
      fmt::format("no operating point found: {}",
                  residuals.empty()
                      ? std::string("nothing moves, but a fixed number is not reached")
                      : join(residuals, ", ")));
  const auto clocks = clocks_in(report);
  if (!bounds.empty()) error.notes.push_back({"stopped by " + join(bounds, ", "), {}, ""});
  if (report.answer.depends_on_time)
    error.help =
        "a signal changes with the time: give its source a constant value, or linearize "
        "without `--trim`";
  else if (!clocks.empty())
    error.help = fmt::format("{} {} by itself: `--moving {}` lets it", join(clocks, ", "),
                             clocks.size() == 1 ? "moves" : "move",
                             clocks.front().substr(1, clocks.front().size() - 2));
  else if (!bounds.empty())
    error.help = "`--bounds NAME=LOW,HIGH` widens a bound; or fix less, or another number";
  else
    error.help = "begin elsewhere with `--at`, fix less, or let a position move with `--moving`";
}

/// What moves though it has to rest.
bool check_moving(const TrimReport& report, const Plan& plan, Diagnostics& diagnostics) {
  const TrimAnswer& answer = report.answer;
  for (const ResetElement& each : answer.there.states) {
    if (each.word == ResetElement::kNone || !answer.moves[each.word] ||
        report.question.words[each.word].moving)
      continue;
    diagnostics
        .error("E0521", plan.graph->span,
               fmt::format("`{}` moves, because it depends on a moving state",
                           name_of_word(answer.there, each.word)))
        .help = fmt::format("add `--moving {}`, or remove `--moving`",
                            name_of_word(answer.there, each.word));
    return false;
  }
  return true;
}

}  // namespace

std::vector<Argument> trim_arguments(TrimSettings& settings) {
  return {texts("--fix", settings.fix, "hold this state or action, or require this value of a port",
                "NAME[=VALUE]"),
          texts("--moving", settings.moving,
                "state that may move, such as a position; all others rest", "STATE"),
          texts("--bounds", settings.bounds,
                "bounds of a state or an action (default: those of its space)", "NAME=LOW,HIGH")};
}

std::optional<TrimReport> trim_point(Run& run, const std::string& image,
                                     const TrimSettings& settings, const LinearOptions& options,
                                     int& code) {
  const Plan& plan = *run.plan;
  std::vector<std::string> words = first_words(options, plan, true);
  words.insert(words.end(), {"--compares", "0"});
  // A point at which all quantized numbers rest on a step is rare, so they count without steps.
  std::vector<std::string> reset = {"--quantizes", "0"};
  for (const std::string& text : options.at) {
    const auto states = states_of(*plan.graph);
    if (std::ranges::find(states, text.substr(0, text.find('=')), &NamedState::name) !=
        states.end())
      reset.insert(reset.end(), {"--at", text});
  }
  words.insert(words.end(), reset.begin(), reset.end());
  const auto all = written_options(settings, options);
  const auto inputs = inputs_of(settings, plan);
  for (const std::size_t channel : inputs)
    words.insert(words.end(), {"--from", fmt::format("{}", channel)});
  std::vector<std::size_t> outputs;
  for (const Input& input : plan.graph->environment().inputs)
    outputs.push_back(channel_at(plan, input.source_node, input.source_output));
  for (const WrittenCondition& each : all) {
    if (const auto channel = each.option == "--fix" ? port_named(each.name, plan) : std::nullopt;
        channel && std::ranges::count(inputs, *channel) == 0)
      outputs.push_back(*channel);
  }
  std::ranges::sort(outputs);
  // Clang 14 does not know std::ranges::unique of libstdc++ 12.
  outputs.erase(std::unique(outputs.begin(), outputs.end()), outputs.end());
  for (const std::size_t channel : outputs) {
    if (channel < plan.channels.size())
      words.insert(words.end(), {"--to", fmt::format("{}", channel)});
  }

  const auto there = hyperperiod_of(run, image, words, code);
  if (!there) return std::nullopt;
  TrimReport report;
  report.question = trim_question(*there, all, plan, run.diagnostics);
  if (run.diagnostics.has_errors()) return std::nullopt;
  std::string failure;
  int ignored = kDone;
  const Evaluate evaluate = [&](const std::vector<double>& numbers,
                                const std::vector<double>& values) -> std::optional<Hyperperiod> {
    const auto text =
        printed_by(image, with_point(words, there->system, numbers, values), failure, ignored);
    return text ? read_hyperperiod(*text, plan) : std::nullopt;
  };
  auto answer = find_operating_point(report.question, evaluate);
  if (!answer) {
    complain_text(failure);
    code = kProblems;
    return std::nullopt;
  }
  report.answer = std::move(*answer);
  report.graph = plan.graph->name;
  report.reset = std::move(reset);
  report.command = command_for(report, settings, options);
  for (const std::string& each : settings_of(report.answer)) {
    if (!report.program_options.empty()) report.program_options += ' ';
    report.program_options += "--set " + each;
  }
  if (!report.answer.found)
    explain_failure(report, plan, run.diagnostics);
  else
    check_moving(report, plan, run.diagnostics);
  return report;
}

std::vector<std::string> words_at(const TrimReport& report) {
  return with_point(report.reset, report.answer.there.system, report.answer.words,
                    report.answer.inputs);
}

}  // namespace eagerx::gen
