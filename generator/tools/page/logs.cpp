// Traces on the page: minimum and maximum of each time interval, so that a long trace keeps its
// peaks.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <runtime/host/trace/log_file.hpp>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/json/base64.hpp"
#include "generator/tools/page/page.hpp"
#include "generator/tools/page/scenes.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;
using trace_log::RecordedChannel;
using trace_log::Row;

constexpr std::size_t kMostPoints = 2000, kFewPoints = 200, kLeastPoints = 16;
constexpr std::size_t kEpisodes = 12;         // of a trace
constexpr std::size_t kElements = 16;         // of a channel
constexpr std::size_t kBytes = 3'000'000;     // of all plots in the page
constexpr std::size_t kSceneBytes = 900'000;  // of all films in the page
constexpr std::size_t kBytesOfPoint = 11;     // two float32 in Base64
constexpr std::size_t kStamps = 40'000;       // of a trace, for the timetable
constexpr double kNsPerSecond = 1e9;

/// How much of the traces is shown.
struct Amount {
  std::size_t points = kMostPoints, episodes = kEpisodes;
  std::size_t scene_bytes = kSceneBytes;  // of the film of an episode
};

std::size_t shown_elements(const RecordedChannel& channel) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(channel.size, kElements));
}

Amount amount_of(const std::vector<Log>& logs, std::size_t wanted) {
  Amount amount;
  for (; amount.episodes >= 1; --amount.episodes) {
    std::size_t series = 1;
    for (const Log& log : logs) {
      const auto episodes = std::min<std::size_t>(log.episodes(), amount.episodes);
      for (const RecordedChannel& channel : log.channels)
        series += episodes * (shown_elements(channel) + (log.timed ? 1 : 0));
    }
    amount.points = kBytes / kBytesOfPoint / series;
    if (amount.points >= kFewPoints || amount.episodes == 1) break;
  }
  std::size_t drawn = 0;
  for (const Log& log : logs) {
    if (!log.scenes.empty()) drawn += std::min<std::size_t>(log.episodes(), amount.episodes);
  }
  amount.scene_bytes = kSceneBytes / std::max<std::size_t>(drawn, 1);
  amount.points = std::clamp(amount.points, kLeastPoints, kMostPoints);
  if (wanted > 0) amount.points = wanted;
  return amount;
}

/// In Base64, little endian.
std::string float32s(const std::vector<double>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(float));
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>((bits >> shift) & 0xffU);
  }
  return base64(bytes);
}

/// A number for each message, thinned.
class Series {
 public:
  Series(std::uint64_t messages, std::size_t points)
      : per_(messages <= 2 * points ? 1 : (messages + points - 1) / points),
        low_(static_cast<std::size_t>((messages + per_ - 1) / per_),
             std::numeric_limits<double>::quiet_NaN()),
        high_(low_) {}

  /// `at`: since the first message.
  void add(std::uint64_t at, double value) {
    if (!std::isfinite(value)) {
      ++not_finite_;
      return;
    }
    const auto place = static_cast<std::size_t>(at / per_);
    if (place >= low_.size()) return;
    low_[place] = std::isnan(low_[place]) ? value : std::min(low_[place], value);
    high_[place] = std::isnan(high_[place]) ? value : std::max(high_[place], value);
  }

  [[nodiscard]] std::uint64_t per() const { return per_; }
  [[nodiscard]] Json json() const {
    Json json{{"low", float32s(low_)}};
    if (per_ > 1) json["high"] = float32s(high_);
    if (not_finite_ > 0) json["not_finite"] = not_finite_;
    return json;
  }

 private:
  std::uint64_t per_;
  std::vector<double> low_, high_;
  std::uint64_t not_finite_ = 0;
};

double rate_of(const RecordedChannel& channel) {
  return static_cast<double>(channel.rate_num) / static_cast<double>(channel.rate_den);
}

/// The messages of one channel in one episode.
class Messages {
 public:
  Messages(const Log& log, std::uint32_t channel, std::vector<const Row*> rows)
      : log_(log), channel_(log.channels[channel]), number_(channel), rows_(std::move(rows)) {}

  [[nodiscard]] std::uint64_t span() const {
    return rows_.empty() ? 0 : rows_.back()->seq - rows_.front()->seq + 1;
  }

  [[nodiscard]] Json json(std::size_t points) const {
    std::vector<Series> elements(shown_elements(channel_), Series(span(), points));
    for (const Row* row : rows_) {
      for (std::size_t e = 0; e < elements.size(); ++e)
        elements[e].add(row->seq - rows_.front()->seq,
                        trace_log::number_of(channel_.dtype, log_.values_of(*row)[e]));
    }
    Json json{{"channel", number_},
              {"first", rows_.empty() ? 0 : rows_.front()->seq},
              {"messages", rows_.size()},
              {"per", elements.front().per()},
              {"elements", Json::list()}};
    for (const Series& series : elements) json["elements"].push_back(series.json());
    return json;
  }

  /// In seconds, since the time at which its episode would have begun.
  [[nodiscard]] double lateness_s(const Row& row, double begin_ns) const {
    return (static_cast<double>(row.time_ns) - begin_ns) / kNsPerSecond -
           static_cast<double>(row.seq) / rate_of(channel_);
  }

  void add_times(Json& json, double begin_ns, std::size_t points, std::size_t stamps) const {
    Series series(span(), points);
    std::vector<double> all, first;
    for (const Row* row : rows_) {
      const double late_s = lateness_s(*row, begin_ns);
      series.add(row->seq - rows_.front()->seq, late_s);
      all.push_back(late_s);
      if (first.size() < stamps) first.push_back(late_s);
    }
    if (all.empty()) return;
    std::ranges::sort(all);
    double sum = 0;
    for (const double late_s : all) sum += late_s;
    constexpr std::size_t kPercent = 99;
    json["lateness"] = series.json();
    json["late"] = Json{{"least", all.front()},
                        {"mean", sum / static_cast<double>(all.size())},
                        {"p99", all[(all.size() - 1) * kPercent / 100]},
                        {"most", all.back()}};
    if (stamps > 0) json["stamps"] = float32s(first);
  }

  [[nodiscard]] const std::vector<const Row*>& rows() const { return rows_; }

 private:
  const Log& log_;
  const RecordedChannel& channel_;
  std::uint32_t number_;
  std::vector<const Row*> rows_;
};

using Episode = std::vector<Messages>;  // by channel

std::vector<Episode> episodes_of(const Log& log, std::size_t most) {
  const std::size_t count = std::min<std::size_t>(log.episodes(), most);
  std::vector<std::vector<std::vector<const Row*>>> rows(
      count, std::vector<std::vector<const Row*>>(log.channels.size()));
  for (const Row& row : log.rows) {
    if (row.episode < count) rows[row.episode][row.channel].push_back(&row);
  }
  std::vector<Episode> episodes(count);
  for (std::size_t e = 0; e < count; ++e) {
    for (std::uint32_t c = 0; c < log.channels.size(); ++c)
      episodes[e].emplace_back(log, c, std::move(rows[e][c]));
  }
  return episodes;
}

/// When the first message was sent, less its place in the episode.
double begin_ns_of(const Log& log, const Episode& episode) {
  double begin = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < episode.size(); ++c) {
    if (episode[c].rows().empty()) continue;
    const Row& row = *episode[c].rows().front();
    begin =
        std::min(begin, static_cast<double>(row.time_ns) -
                            kNsPerSecond * static_cast<double>(row.seq) / rate_of(log.channels[c]));
  }
  return std::isfinite(begin) ? begin : 0.0;
}

/// Whether time went by as planned: a run that was not paced is done long before.
bool is_paced(const Episode& episode, double begin_ns) {
  constexpr double kFarOff = 0.2;
  for (const Messages& messages : episode) {
    if (messages.rows().size() < 2) continue;
    const Row& row = *messages.rows().back();
    const double measured_s = (static_cast<double>(row.time_ns) - begin_ns) / kNsPerSecond;
    const double planned_s = measured_s - messages.lateness_s(row, begin_ns);
    if (std::abs(measured_s - planned_s) > kFarOff * planned_s) return false;
  }
  return true;
}

Json states_json(const Log& log, std::uint32_t episode) {
  Json states = Json::list();
  for (const auto& state : log.states) {
    if (state.episode == episode)
      states.push_back(Json{{"name", state.name}, {"values", Json(state.values)}});
  }
  return states;
}

Json head_json(const Log& log) {
  Json json{{"name", log.path},
            {"agent", log.agent},
            {"engine", log.engine},
            {"seed", std::to_string(log.seed)},  // numbers of JSON are doubles
            {"environment", log.environment},
            {"messages", log.rows.size()},
            {"all_episodes", log.episodes()},
            {"complete", log.complete},
            {"hash", log.complete ? fmt::format("0x{:016x}", log.hash) : std::string()},
            {"channels", Json::list()}};
  for (const RecordedChannel& channel : log.channels)
    json["channels"].push_back(Json{{"name", channel.name},
                                    {"dtype", std::string(trace_log::name_of(channel.dtype))},
                                    {"size", channel.size},
                                    {"rate_hz", rate_of(channel)}});
  return json;
}

Json log_json(const Log& log, const Amount& amount) {
  Json json = head_json(log);
  const std::vector<Episode> episodes = episodes_of(log, amount.episodes);
  const bool timed = log.timed && !episodes.empty() &&
                     is_paced(episodes.front(), begin_ns_of(log, episodes.front()));
  json["timed"] = log.timed;
  json["paced"] = timed;
  json["episodes"] = Json::list();
  for (std::uint32_t e = 0; e < episodes.size(); ++e) {
    Json channels = Json::list();
    const double begin_ns = begin_ns_of(log, episodes[e]);
    for (const Messages& messages : episodes[e]) {
      Json channel = messages.json(amount.points);
      if (timed)
        messages.add_times(channel, begin_ns, amount.points,
                           e == 0 ? kStamps / log.channels.size() : 0);
      channels.push_back(std::move(channel));
    }
    json["episodes"].push_back(Json{{"number", e},
                                    {"states", states_json(log, e)},
                                    {"channels", std::move(channels)},
                                    {"film", scenes_json(log, e, amount.scene_bytes)}});
  }
  return json;
}

/// The difference between a channel in `log` and in the graph; empty if they agree.
std::string difference(const RecordedChannel& recorded, const Plan& plan) {
  const auto channel = ranges::find(plan.channels, recorded.name, &Channel::name);
  if (channel == plan.channels.end())
    return fmt::format("the graph has no channel `{}`", recorded.name);
  const GraphNode& node = plan.graph->nodes[channel->node];
  const Space& space = node.outputs[channel->output].space;
  const auto text = [](const auto& dtype, std::uint64_t size, const std::string& rate) {
    return fmt::format("{} [{}] at {} Hz", dtype, size, rate);
  };
  const std::string there = text(trace_log::name_of(recorded.dtype), recorded.size,
                                 Rational(static_cast<std::int64_t>(recorded.rate_num),
                                          static_cast<std::int64_t>(recorded.rate_den))
                                     .to_string());
  const std::string here = text(to_string(space.dtype), space.size(), node.rate_hz.to_string());
  return there == here
             ? std::string()
             : fmt::format("`{}` is {} in the trace, {} in the graph", recorded.name, there, here);
}

void check_log(const Log& log, const Plan& plan, Diagnostics& diagnostics) {
  std::string why;
  if (log.graph != plan.graph->name)
    why = fmt::format("it is of `{}`, this graph is `{}`", log.graph, plan.graph->name);
  for (const RecordedChannel& channel : log.channels) {
    if (why.empty()) why = difference(channel, plan);
  }
  if (why.empty()) return;
  diagnostics.error("E0361", {}, fmt::format("`{}` is a trace of another graph: {}", log.path, why))
      .help = "give a trace that a program of this graph wrote, with the same engine and rates";
}

}  // namespace

Json read_logs(const std::vector<std::string>& paths, const Plan& plan, std::size_t points,
               Diagnostics& diagnostics) {
  std::vector<Log> logs;
  for (const std::string& path : paths) {
    std::string problem;
    if (auto log = trace_log::read_log_file(path, problem)) {
      check_log(*log, plan, diagnostics);
      logs.push_back(std::move(*log));
      continue;
    }
    constexpr std::string_view kError = "error: ";
    const std::size_t error = problem.find(kError);
    if (error != std::string::npos) problem.erase(error, kError.size());
    diagnostics.io_error("E0362", {}, problem).help = "give what a run wrote with `--trace`";
  }
  Json list = Json::list();
  if (diagnostics.has_errors()) return list;
  const Amount amount = amount_of(logs, points);
  for (const Log& log : logs) list.push_back(log_json(log, amount));
  return list;
}

}  // namespace eagerx::gen
