#include "targets/environments/train/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <runtime/host/base/hash.hpp>

#include "targets/environments/train/signs.hpp"
#include "targets/environments/train/start.hpp"

namespace eagerx::train {
namespace {

using nlohmann::ordered_json;

/// Names of files may be no UTF-8.
std::string line_of(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string head_of(const Options& options, const Description& description) {
  ordered_json head = {{"eagerx_training", 1},
                       {"graph", description.graph},
                       {"hash", description.hash},
                       {"rate", description.rate_hz},
                       {"algorithm", options.settings.algorithm},
                       {"settings", text_of(options.settings)},
                       {"seed", options.settings.seed},
                       {"seeds", options.seeds},
                       {"steps", options.steps},
                       {"has_success", description.has_success},
                       {"terms", description.terms}};
  for (const client::Stage& stage : description.stages) head["stages"].push_back(stage.name);
  const double wanted = options.settings.until_return;
  if (std::isfinite(wanted)) head["until_return"] = wanted;
  for (const auto& [name, path] : {std::pair("resume", &options.resume),
                                   {"from", &options.from},
                                   {"failure_replay", &options.failure_replay}}) {
    if (!path->empty()) head[name] = *path;
  }
  if (!options.replay.empty()) head["replay"] = options.replay;
  return line_of(head);
}

/// ,"name":value of a known number.
std::string member(const char* name, double value) {
  return std::isfinite(value) ? fmt::format(",\"{}\":{:.7g}", name, value) : std::string();
}

std::string row_of(std::uint64_t seed, const CurvePoint& point, const std::vector<double>& terms) {
  std::string text = fmt::format("{{\"seed\":{},\"steps\":{:.0f}", seed, point.steps);
  text += member("return", point.mean_return) + member("success_rate", point.success) +
          member("eval_return", point.evaluation_return) +
          member("eval_success_rate", point.evaluation_success) + member("std", point.deviation) +
          member("learning_rate", point.step_size) + member("approx_kl", point.divergence) +
          member("stage", point.stage) + member("stage_success_rate", point.stage_success) +
          member("stage_return", point.stage_return);
  if (terms.empty()) return text + "}\n";
  std::string values;
  for (const double term : terms) {
    if (!values.empty()) values += ',';
    values += std::isfinite(term) ? fmt::format("{:.7g}", term) : "null";
  }
  return text + ",\"terms\":[" + values + "]}\n";
}

ordered_json evaluation_of(const Evaluation& evaluation) {
  return {{"episodes", evaluation.episodes},
          {"successes", evaluation.successes},
          {"return", evaluation.mean_return},
          {"lowest", evaluation.lowest_return},
          {"highest", evaluation.highest_return},
          {"steps", evaluation.mean_steps},
          {"terms", evaluation.terms},
          {"saturated", evaluation.saturated}};
}

/// [seed, environment, return, steps, success] each. The seed is a text, because many readers of
/// JSON parse numbers as doubles.
ordered_json episodes_of(const Evaluation& evaluation) {
  ordered_json list = ordered_json::array();
  for (const Outcome& each : evaluation.outcomes)
    list.push_back(ordered_json::array(
        {std::to_string(each.seed), each.environment, each.sum, each.steps, each.success ? 1 : 0}));
  return list;
}

/// Processor time in seconds, and what was done in it.
ordered_json time_of(const Ended& ended) {
  const Spent& spent = ended.spent;
  const double all_s = std::max(ended.seconds * ended.threads, spent.total_s());
  return {{"threads", ended.threads},
          {"simulation_s", spent.simulation_s},
          {"inference_s", spent.inference_s},
          {"learning_s", spent.learning_s},
          {"evaluation_s", spent.evaluation_s},
          {"waiting_s", all_s - spent.total_s()},
          {"steps", ended.done.steps},
          {"samples", ended.done.samples},
          {"inference_gflop", ended.done.inference_gflop()},
          {"learning_gflop", ended.done.learning_gflop()}};
}

const char* name_of(Ending ending) {
  return ending == Ending::success ? "success" : ending == Ending::steps ? "steps" : "interrupted";
}

}  // namespace

Record::Record(const Options& options, const Description& description)
    : is_wanted_(!options.record.empty()), file_(options.record) {
  if (is_wanted_) head_ = head_of(options, description);
}

void Record::append(Training& training, std::uint64_t seed, const std::vector<CurvePoint>& curve,
                    const std::vector<double>& terms) const {
  for (; training.count < curve.size(); ++training.count) {
    const CurvePoint& point = curve[training.count];
    // Terms are those of the last point: checkpoints, from which older ones are, have none.
    const bool has_terms =
        training.count + 1 == curve.size() && !std::isnan(point.evaluation_return);
    training.rows += row_of(seed, point, has_terms ? terms : std::vector<double>());
  }
}

std::string Record::text() const {
  std::string all = head_;
  for (const auto& [seed, training] : trainings_) all += training.rows + training.end;
  return all;
}

std::string Record::grow(std::uint64_t seed, double now_s, const std::vector<CurvePoint>& curve,
                         const Evaluation& seen) {
  if (!is_wanted_) return {};
  const std::lock_guard lock(mutex_);
  append(trainings_[seed], seed, curve, seen.terms);
  return file_.grow(now_s, [&] { return text(); });
}

void Record::end(const Ended& ended, const Evaluation& evaluation) {
  if (!is_wanted_) return;
  const std::uint64_t seed = ended.options.settings.seed;
  const ordered_json line = {
      {"seed", seed},
      {"ended", name_of(ended.ending)},
      {"steps", ended.steps},
      {"seconds", ended.seconds},
      {"kernels", ended.kernels},
      {"time", time_of(ended)},
      {"policy", ended.options.output},
      {"policy_hash", host::hex_text(host::fnv1a(read_file(ended.options.output)))},
      {"evaluation", evaluation_of(evaluation)},
      {"signs", ended.ending == Ending::success
                    ? std::vector<std::string>()
                    : signs_of(ended.curve, evaluation, ended.description)},
      {"episodes", episodes_of(evaluation)}};
  const std::lock_guard lock(mutex_);
  Training& training = trainings_[seed];
  append(training, seed, ended.curve, {});
  training.end = line_of(line);
  file_.write([&] { return text(); });
}

void Record::fail(std::uint64_t seed, const std::vector<CurvePoint>& curve,
                  const Problem& problem) {
  if (!is_wanted_) return;
  const std::lock_guard lock(mutex_);
  Training& training = trainings_[seed];
  append(training, seed, curve, {});
  training.end = line_of(
      {{"seed", seed}, {"ended", "failed"}, {"problem", problem.what()}, {"help", problem.help}});
  try {
    file_.write([&] { return text(); });
  } catch (const Problem&) {  // NOLINT(bugprone-empty-catch): the first problem is what is reported
  }
}

}  // namespace eagerx::train
