#include "generator/tools/training/record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/renamed.hpp>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/training/curves.hpp"
#include "generator/tools/training/settings.hpp"

namespace eagerx::gen {
namespace {

constexpr double kMostWhole = 9007199254740992.0;  // exact as a double
constexpr std::size_t kMostTerms = 1000;

/// An object of a line. What is missing or of another kind is the line's problem.
class Fields {
 public:
  Fields(const Json& json, TrainingLines& lines) : json_(json), lines_(lines) {}

  double number(std::string_view name) {
    const auto value = number_of(member(&json_, name));
    if (value && std::isfinite(*value)) return *value;
    lines_.fail(fmt::format("`{}` is not a number", name));
    return 0.0;
  }
  double whole(std::string_view name, double most = kMostWhole) {
    const double value = number(name);
    if (value >= 0.0 && value <= most && value == std::floor(value)) return value;
    lines_.fail(fmt::format("`{}` is not a whole number from 0 to {:.0f}", name, most));
    return 0.0;
  }
  std::string text(std::string_view name) {
    const Json* const value = member(&json_, name);
    if (value == nullptr || !value->is<std::string>())
      lines_.fail(fmt::format("`{}` is not text", name));
    return text_of(value);
  }
  std::vector<std::string> texts(std::string_view name, std::size_t most) {
    const Json* const value = member(&json_, name);
    const auto* items = value == nullptr ? nullptr : value->as<Json::List>();
    std::vector<std::string> all;
    if (items != nullptr && items->size() <= most) {
      for (const Json& item : *items) {
        if (item.is<std::string>()) all.push_back(text_of(&item));
      }
    }
    if (items == nullptr || all.size() != items->size())
      lines_.fail(fmt::format("`{}` is not a list of texts", name));
    return all;
  }
  [[nodiscard]] const Json* find(std::string_view name) const { return member(&json_, name); }
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }

 private:
  const Json& json_;
  TrainingLines& lines_;
};

/// A training of a record, and how it ended.
struct Training {
  LearningCurve curve;
  Json end = nullptr;  // {ended, …} as the page has it; null: it is running, or was killed
  std::vector<TrainingEpisode> episodes;
  std::string policy, policy_hash;
  double successes = 0.0, mean_return = 0.0;

  [[nodiscard]] bool is_better_than(const Training& other) const {
    if (policy.empty() != other.policy.empty()) return other.policy.empty();
    return successes != other.successes ? successes > other.successes
                                        : mean_return > other.mean_return;
  }
};

class RecordReader {
 public:
  explicit RecordReader(TrainingLines& lines) : lines_(lines) {}

  std::optional<TrainingRecord> read() {
    const auto first = lines_.next();
    if (!first || !read_head(*first)) return std::nullopt;
    while (const auto line = lines_.next()) {
      if (!read_line(*line)) return std::nullopt;
    }
    if (lines_.has_failed()) return std::nullopt;
    return result();
  }

 private:
  std::optional<Json> object(std::string_view line) {
    auto json = parse_json(line);
    if (json && json->is<Json::Object>()) return json;
    lines_.fail("it is not a JSON object");
    return std::nullopt;
  }

  bool read_head(std::string_view line) {
    const auto json = object(line);
    if (!json) return false;
    Fields head(*json, lines_);
    if (!head.has("eagerx_training")) return lines_.fail("no record of a training begins so");
    if (head.whole("eagerx_training") != 1.0)
      return lines_.fail("another version of eagerx-gen has written it");
    graph_ = head.text("graph");
    terms_ = head.texts("terms", kMostTerms);
    const std::string algorithm = head.text("algorithm");
    page_ = Json{{"kind", "record"},
                 {"graph", graph_},
                 {"algorithm", algorithm},
                 {"settings", settings_json(head.text("settings"), algorithm)},
                 {"rate", head.number("rate")},
                 {"seed", head.whole("seed")},
                 {"seeds", head.whole("seeds")},
                 {"steps", head.whole("steps")},
                 {"has_success", truth_of(head.find("has_success")).value_or(false)},
                 {"terms", Json(terms_)}};
    if (head.has("until_return")) page_["until_return"] = head.number("until_return");
    for (const char* name : {"resume", "from", "failure_replay"}) {
      if (head.has(name)) page_[name] = head.text(name);
    }
    if (head.has("hard_starts")) page_["failure_replay"] = head.text("hard_starts");  // former name
    if (head.has("stages")) page_["stages"] = Json(head.texts("stages", kMostTerms));
    if (head.has("replay")) page_["replay"] = Json(head.texts("replay", kMostTerms));
    return !lines_.has_failed();
  }

  bool read_line(std::string_view line) {
    const auto json = object(line);
    if (!json) return false;
    Fields fields(*json, lines_);
    const double seed = fields.whole("seed", 0x1p62);
    if (lines_.has_failed()) return false;
    Training* const training = training_of(static_cast<std::uint64_t>(seed));
    if (training == nullptr) return lines_.fail("there are more trainings than may be");
    if (!training->end.is<std::monostate>()) return lines_.fail("this training had ended before");
    return fields.has("ended") ? read_end(fields, *training) : read_row(fields, *training);
  }

  Training* training_of(std::uint64_t seed) {
    const auto is_it = [&](const Training& one) { return one.curve.seed == seed; };
    const auto found = ranges::find_if(trainings_, is_it);
    if (found != trainings_.end()) return &*found;
    if (trainings_.size() >= kMostTrainings) return nullptr;
    trainings_.emplace_back();
    trainings_.back().curve.seed = seed;
    trainings_.back().curve.terms.resize(terms_.size());
    return &trainings_.back();
  }

  bool read_row(Fields& fields, Training& training) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    LearningCurve& curve = training.curve;
    const double steps = fields.whole("steps");
    if (!curve.steps.empty() && steps <= curve.steps.back())
      return lines_.fail("its steps are not more than those before");
    numbers_ += 1 + curve.columns.size() + curve.terms.size();
    if (numbers_ > kMostNumbers) return lines_.fail("there are more numbers than may be");
    curve.steps.push_back(steps);
    for (std::size_t i = 0; i < kCurveColumns.size(); ++i) {
      const std::string_view now = kCurveColumns.at(i);
      const std::string_view before = host::former_name(host::kCurveColumns, now);
      const std::string_view name = fields.has(now) || before.empty() ? now : before;
      curve.columns.at(i).push_back(fields.has(name) ? fields.number(name) : kNothing);
    }
    for (auto& term : curve.terms) term.push_back(kNothing);
    if (!fields.has("terms")) return !lines_.has_failed();
    const auto terms = numbers(fields, "terms");
    if (terms.size() != terms_.size())
      return lines_.fail(fmt::format("`terms` are not {} numbers", terms_.size()));
    for (std::size_t i = 0; i < terms.size(); ++i) curve.terms[i].back() = terms[i];
    return !lines_.has_failed();
  }

  /// Null is NaN.
  std::vector<double> numbers(Fields& fields, std::string_view name) {
    std::vector<double> all;
    const Json* const value = fields.find(name);
    const auto* items = value == nullptr ? nullptr : value->as<Json::List>();
    if (items == nullptr) {
      lines_.fail(fmt::format("`{}` is not a list of numbers", name));
      return all;
    }
    for (const Json& item : *items) {
      const auto number = number_of(&item);
      if (!number && !item.is<std::monostate>())
        lines_.fail(fmt::format("`{}` is not a list of numbers", name));
      all.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return all;
  }

  bool read_end(Fields& fields, Training& training) {
    const std::string ended = fields.text("ended");
    training.end = Json{{"ended", ended}};
    if (ended == "failed") {
      training.end["problem"] = fields.text("problem");
      training.end["help"] = fields.text("help");
      return !lines_.has_failed();
    }
    constexpr std::array kEnds = {"success", "steps", "interrupted"};
    if (!ranges::contains(kEnds, ended)) return lines_.fail("no training ends so: `ended`");
    training.policy = fields.text("policy");
    training.policy_hash = fields.text("policy_hash");
    training.end["steps"] = fields.whole("steps");
    training.end["seconds"] = fields.number("seconds");
    training.end["kernels"] = fields.text("kernels");
    if (fields.has("time")) training.end["time"] = time(fields);
    training.end["policy"] = training.policy;
    training.end["signs"] = Json(fields.texts("signs", kMostTerms));
    return read_evaluation(fields, training) && read_episodes(fields, training);
  }

  /// Where the time went. Older records do not have it.
  Json time(Fields& fields) {
    const Json* const value = fields.find("time");
    if (!value->is<Json::Object>()) {
      lines_.fail("`time` is not an object");
      return {};
    }
    Fields time(*value, lines_);
    Json json{{"threads", time.whole("threads")},
              {"steps", time.whole("steps")},
              {"samples", time.whole("samples")}};
    for (const char* name : {"simulation_s", "inference_s", "learning_s", "evaluation_s",
                             "waiting_s", "inference_gflop", "learning_gflop"})
      json[name] = time.number(name);
    return json;
  }

  bool read_evaluation(Fields& fields, Training& training) {
    const Json* const value = fields.find("evaluation");
    if (value == nullptr || !value->is<Json::Object>())
      return lines_.fail("`evaluation` is not an object");
    Fields evaluation(*value, lines_);
    training.successes = evaluation.whole("successes");
    training.mean_return = evaluation.number("return");
    Json json{{"episodes", evaluation.whole("episodes")},
              {"successes", training.successes},
              {"return", training.mean_return},
              {"lowest", evaluation.number("lowest")},
              {"highest", evaluation.number("highest")},
              {"steps", evaluation.number("steps")},
              {"saturated", evaluation.number("saturated")},
              {"terms", Json::list()}};
    const std::vector<double> terms = numbers(evaluation, "terms");
    if (terms.size() != terms_.size())
      return lines_.fail(fmt::format("`terms` are not {} numbers", terms_.size()));
    for (const double term : terms) json["terms"].push_back(term);
    training.end["evaluation"] = std::move(json);
    return !lines_.has_failed();
  }

  bool read_episodes(Fields& fields, Training& training) {
    const Json* const value = fields.find("episodes");
    const auto* items = value == nullptr ? nullptr : value->as<Json::List>();
    if (items == nullptr) return lines_.fail("`episodes` is not a list");
    for (const Json& item : *items) {
      const auto episode = episode_of(item);
      if (!episode)
        return lines_.fail("an episode is not [seed, environment, return, steps, success]");
      training.episodes.push_back(*episode);
    }
    return true;
  }

  static std::optional<TrainingEpisode> episode_of(const Json& item) {
    constexpr std::size_t kNumbers = 5;
    constexpr double kMostSteps = 1e12;
    const auto* parts = item.as<Json::List>();
    if (parts == nullptr || parts->size() != kNumbers) return std::nullopt;
    const auto whole = [&](std::size_t i, double low, double most) -> std::optional<double> {
      const auto number = number_of(&(*parts)[i]);
      const bool is_one = number && *number >= low && *number <= most;
      return is_one && *number == std::floor(*number) ? number : std::nullopt;
    };
    TrainingEpisode episode;
    const auto environment = whole(1, 0.0, std::numeric_limits<std::uint32_t>::max());
    const auto sum = number_of(&(*parts)[2]);
    const auto steps = whole(3, 1.0, kMostSteps), success = whole(4, 0.0, 1.0);
    if (!host::read_number(text_of(&(*parts)[0]), episode.seed) || !environment || !sum ||
        !std::isfinite(*sum) || !steps || !success)
      return std::nullopt;
    episode.environment = static_cast<std::uint32_t>(*environment);
    episode.sum = *sum;
    episode.steps = static_cast<std::uint64_t>(*steps);
    episode.success = *success == 1.0;
    return episode;
  }

  TrainingRecord result() {
    TrainingRecord record;
    std::vector<LearningCurve> curves;
    page_["trainings"] = Json::list();
    const Training* best = nullptr;
    std::size_t place = 0;
    for (std::size_t i = 0; i < trainings_.size(); ++i) {
      Training& one = trainings_[i];
      Json json = one.end.is<std::monostate>() ? Json{{"ended", nullptr}} : one.end;
      json["seed"] = one.curve.seed;
      if (member(&json, "steps") == nullptr)
        json["steps"] = one.curve.steps.empty() ? 0.0 : one.curve.steps.back();
      page_["trainings"].push_back(std::move(json));
      curves.push_back(std::move(one.curve));
      if (best != nullptr && !one.is_better_than(*best)) continue;
      best = &one;
      place = i;
    }
    page_["charts"] = curve_charts(curves, terms_);
    page_["best"] = place;
    record.graph = graph_;
    if (best != nullptr) {
      record.policy = best->policy;
      record.policy_hash = best->policy_hash;
      record.episodes = best->episodes;
    }
    record.page = std::move(page_);
    return record;
  }

  TrainingLines& lines_;
  Json page_;
  std::string graph_;
  std::vector<std::string> terms_;
  std::vector<Training> trainings_;  // in the order in which they appear
  std::size_t numbers_ = 0;          // of all curves
};

}  // namespace

std::optional<TrainingRecord> read_record(TrainingLines& lines) {
  return RecordReader(lines).read();
}

}  // namespace eagerx::gen
