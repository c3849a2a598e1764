#include "generator/tools/trace/pil_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <runtime/host/trace/log_file.hpp>
#include <vector>

namespace eagerx::gen {
namespace {

using trace_log::Log;
using trace_log::Row;

constexpr unsigned kWordBits = 32;

void append_word(std::string& words, std::uint64_t word) {
  for (unsigned shift = 0; shift < kWordBits; shift += 8)
    words += static_cast<char>(static_cast<unsigned char>(word >> shift));
}

/// The messages of one port in the episodes of a log.
class Recorded {
 public:
  Recorded(const Log& log, std::uint32_t channel, const Rational& steps_a_message)
      : log_(log), channel_(log.channels[channel]), steps_(steps_a_message.num()) {
    rows_.resize(log.episodes());
    for (const Row& row : log.rows)
      if (row.channel == channel && row.seq == rows_[row.episode].size())
        rows_[row.episode].push_back(&row);
  }

  /// Steps of an episode whose message is there.
  [[nodiscard]] std::uint64_t steps(std::uint32_t episode) const {
    return rows_[episode].size() * static_cast<std::uint64_t>(steps_);
  }
  /// That of a step: the newest that was sent by then.
  void append_to(std::string& words, std::uint32_t episode, std::uint64_t step) const {
    const std::uint64_t* values =
        log_.values_of(*rows_[episode][step / static_cast<std::uint64_t>(steps_)]);
    for (std::uint64_t i = 0; i < channel_.size; ++i) {
      append_word(words, values[i]);
      if (has_two_words()) append_word(words, values[i] >> kWordBits);
    }
  }

 private:
  [[nodiscard]] bool has_two_words() const {
    using trace_log::Dtype;
    return channel_.dtype == Dtype::float64 || channel_.dtype == Dtype::int64 ||
           channel_.dtype == Dtype::uint64;
  }

  const Log& log_;
  const trace_log::RecordedChannel& channel_;
  std::int64_t steps_;  // of the library, for each message
  std::vector<std::vector<const Row*>> rows_;
};

}  // namespace

std::optional<PilRecording> recording_of(const std::string& path, const Graph& graph,
                                         std::string& problem) {
  const auto log = trace_log::read_log_file(path, problem);
  if (!log) return std::nullopt;
  std::vector<Recorded> ports;
  for (const auto* list : {&graph.cut->actions, &graph.cut->observations}) {
    for (const CutPort& port : *list) {
      const auto channel = log->channel(port.channel);
      if (!channel) {
        problem = fmt::format("{}: there is no channel `{}`", path, port.channel);
        return std::nullopt;
      }
      ports.emplace_back(*log, *channel, graph.environment().rate_hz / port.rate_hz);
    }
  }
  PilRecording result;
  result.episodes = log->episodes();
  append_word(result.words, log->seed);
  append_word(result.words, log->seed >> kWordBits);
  append_word(result.words, result.episodes);
  for (std::uint32_t episode = 0; episode < result.episodes; ++episode) {
    std::uint64_t steps = ~std::uint64_t{0};
    for (const Recorded& port : ports) steps = std::min(steps, port.steps(episode));
    append_word(result.words, steps);
    for (std::uint64_t step = 0; step < steps; ++step)
      for (const Recorded& port : ports) port.append_to(result.words, episode, step);
    result.steps += steps;
  }
  return result;
}

}  // namespace eagerx::gen
