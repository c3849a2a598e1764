#include "targets/environments/train/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "targets/environments/train/export.hpp"
#include "targets/environments/train/presets.hpp"
#include "targets/environments/train/signs.hpp"

namespace eagerx::train {
namespace {

std::string name_of(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

std::string speed(const char* name, std::uint64_t count, const char* unit, double seconds,
                  double gflop) {
  if (count == 0 || seconds <= 0.0) return {};
  std::string text =
      fmt::format("{} {} {}/s", name, rounded(static_cast<double>(count) / seconds), unit);
  if (gflop > 0.0) text += fmt::format(" ({:.3g} Gflop/s)", gflop / seconds);
  return text;
}

std::vector<std::string> without_empty(std::vector<std::string> texts) {
  std::erase(texts, std::string());
  return texts;
}

/// The rest of the threads' time is waiting, for each other or for a free core.
std::string where_time_went(const Ended& ended) {
  const Spent& spent = ended.spent;
  const double all_s = std::max(ended.seconds * ended.threads, spent.total_s());
  if (all_s <= 0.0) return {};
  std::string text =
      fmt::format("time of {} {}:", ended.threads, ended.threads == 1 ? "thread" : "threads");
  const char* comma = "";
  for (const auto& [name, seconds] : {std::pair("simulation", spent.simulation_s),
                                      {"inference", spent.inference_s},
                                      {"learning", spent.learning_s},
                                      {"evaluation", spent.evaluation_s},
                                      {"waiting", all_s - spent.total_s()}}) {
    text += fmt::format("{} {} {:.0f} %", comma, name, 100.0 * seconds / all_s);
    comma = ",";
  }
  const Done& done = ended.done;
  text += "\nspeed of a thread: ";
  text += fmt::format(
      "{}",
      fmt::join(without_empty({speed("simulation", done.steps, "steps", spent.simulation_s, 0.0),
                               speed("inference", done.steps, "steps", spent.inference_s,
                                     done.inference_gflop()),
                               speed("learning", done.samples, "samples", spent.learning_s,
                                     done.learning_gflop())}),
                ", "));
  return text + "\n";
}

std::string result(const Ended& ended, const Evaluation& evaluation) {
  const char* why = ended.ending == Ending::success       ? "the policy succeeds"
                    : ended.ending == Ending::interrupted ? "interrupted"
                                                          : "the steps are used up";
  std::string text =
      fmt::format("{} after {} steps, {:.1f} s ({:.1f} s of them to evaluate), with {} kernels\n",
                  why, rounded(static_cast<double>(ended.steps)), ended.seconds,
                  ended.evaluating_seconds, ended.kernels);
  text += where_time_went(ended);
  text += fmt::format("on {} seeds that neither trained nor chose it: ", evaluation.episodes);
  if (ended.description.has_success)
    text += fmt::format("success {} of {}, ", evaluation.successes, evaluation.episodes);
  text += fmt::format("return {:.4g} ({:.4g} to {:.4g}) in {:.4g} steps\n", evaluation.mean_return,
                      evaluation.lowest_return, evaluation.highest_return, evaluation.mean_steps);
  for (std::size_t i = 0; i < evaluation.terms.size(); ++i)
    text += fmt::format("  {:<20} {:.4g}\n", ended.description.terms[i], evaluation.terms[i]);
  return text;
}

/// The stage that a training has ended in, if it is not over.
std::string unfinished(const Ended& ended) {
  const auto& stages = ended.description.stages;
  if (ended.curve.empty() || stages.empty()) return {};
  const auto stage = static_cast<std::size_t>(ended.curve.back().stage) - 1;
  if (stage >= stages.size()) return {};
  return fmt::format(
      "note: stage `{}` ({} of {}) was not passed: most of the graph as it is written has not been "
      "practised\n",
      stages[stage].name, stage + 1, stages.size());
}

/// Hints that may help.
std::string notes(const Ended& ended, const Evaluation& evaluation) {
  if (!ended.has_aim)
    return unfinished(ended) +
           "note: the task has no `success:`, so it is unknown whether this policy is good\n";
  if (ended.ending == Ending::success) return {};
  std::string text = unfinished(ended);
  for (const std::string& sign : signs_of(ended.curve, evaluation, ended.description))
    text += "note: " + sign + "\n";
  const std::string advice = preset_advice(ended.options, ended.description, ended.curve);
  if (!advice.empty()) text += "note: " + advice + "\n";
  const double wanted = ended.options.settings.until_return;
  if (evaluation.mean_return < wanted)
    return text + fmt::format(
                      "note: the return is below --until-return {:g}; more --steps or another "
                      "--seed may\n",
                      wanted);
  return text +
         "note: the policy does not succeed; a task whose reward leads to its `success:` "
         "step by step, more --steps or another --seed may\n";
}

}  // namespace

std::string summary(const Ended& ended, const Evaluation& evaluation) {
  const std::string& output = ended.options.output;
  return result(ended, evaluation) +
         fmt::format("written: {}, {}\nin the graph: agent: {{policy: {}, golden: {}}}\n", output,
                     golden_path(output), name_of(output), name_of(golden_path(output))) +
         notes(ended, evaluation);
}

}  // namespace eagerx::train
