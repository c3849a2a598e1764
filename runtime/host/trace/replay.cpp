#include <algorithm>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/trace/replay.hpp>

namespace eagerx::trace_log {
namespace {

std::string quoted(std::string_view text) {
  return "`" + std::string(text) + "`";
}

/// "float32 [2] at 30/1 Hz"
std::string described(std::string_view dtype, std::uint64_t size, std::uint64_t num,
                      std::uint64_t den) {
  return std::string(dtype) + " [" + std::to_string(size) + "] at " + std::to_string(num) + "/" +
         std::to_string(den) + " Hz";
}

}  // namespace

std::string count_text(std::uint64_t count, std::string_view what) {
  return host::counted(count, what);
}

Replay::Replay(const Log& log, std::span<const Channel> channels)
    : log_(log), facts_(channels), channels_(channels.size()) {
  std::vector<std::optional<std::uint32_t>> here(log.channels.size());
  for (std::uint32_t i = 0; i < channels.size(); ++i) {
    channels_[i].in_log = log.channel(channels[i].name);
    if (is_another_engine(i)) channels_[i].in_log = std::nullopt;
    if (channels_[i].in_log) here[*channels_[i].in_log] = i;
  }
  for (std::size_t row = 0; row < log.rows.size(); ++row) {
    const auto& channel = here[log.rows[row].channel];
    if (channel) channels_[*channel].rows.push_back(row);
  }
}

/// One that ticks at another rate: its ticks are not the program's.
bool Replay::is_another_engine(std::uint32_t channel) const {
  if (facts_[channel].publisher != Publisher::engine || !channels_[channel].in_log) return false;
  const RecordedChannel& recorded = log_.channels[*channels_[channel].in_log];
  return recorded.rate_num != facts_[channel].rate_num ||
         recorded.rate_den != facts_[channel].rate_den;
}

bool Replay::prepare(std::string_view given, bool engine_is_real, std::string& problem) {
  if (!fits(problem)) return false;
  choose(given);
  runs_engine_ = !engine_is_real;
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    const bool of_engine = facts_[i].publisher == Publisher::engine_node;
    if (engine_is_real && of_engine && !channels_[i].given) {
      problem =
          "error: real hardware cannot be asked for " + quoted(facts_[i].name) +
          " again\nhelp: let the log give `sensors`, or replay in the program of a simulation";
      return false;
    }
    const bool is_action = facts_[i].publisher == Publisher::environment;
    if (!steps_ && is_action && !channels_[i].rows.empty()) steps_ = i;
  }
  const bool has_actions = std::ranges::any_of(
      facts_, [](const Channel& channel) { return channel.publisher == Publisher::environment; });
  if (has_actions && !steps_) {
    problem = log_.path +
              ": error: the log has no actions (`environment/…` of this program), so "
              "nothing says how many steps there were";
  }
  return problem.empty();
}

bool Replay::fits(std::string& problem) const {
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    if (!channels_[i].in_log) continue;
    const RecordedChannel& recorded = log_.channels[*channels_[i].in_log];
    const Channel& here = facts_[i];
    if (name_of(recorded.dtype) == here.dtype && recorded.size == here.size &&
        recorded.rate_num == here.rate_num && recorded.rate_den == here.rate_den)
      continue;
    problem =
        log_.path + ": error: " + quoted(here.name) + " is " +
        described(name_of(recorded.dtype), recorded.size, recorded.rate_num, recorded.rate_den) +
        " in the log, " + described(here.dtype, here.size, here.rate_num, here.rate_den) +
        " in this program";
    return false;
  }
  return true;
}

void Replay::choose(std::string_view given) {
  while (!given.empty()) {
    const std::size_t comma = std::min(given.find(','), given.size());
    const std::string_view word = given.substr(0, comma);
    given.remove_prefix(std::min(comma + 1, given.size()));
    for (std::uint32_t i = 0; i < facts_.size(); ++i) {
      const Publisher publisher = facts_[i].publisher;
      if (word == facts_[i].name || (word == "actions" && publisher == Publisher::environment) ||
          (word == "sensors" && publisher == Publisher::engine_node))
        channels_[i].given = true;
    }
  }
}

const Row* Replay::next_row(std::uint32_t channel) const {
  const ChannelState& state = channels_[channel];
  return state.next < state.rows.size() ? &log_.rows[state.rows[state.next]] : nullptr;
}

bool Replay::has_step(std::uint32_t episode) const {
  const auto continues = [&](std::uint32_t channel) {
    const Row* const row = next_row(channel);
    return row != nullptr && row->episode == episode;
  };
  if (steps_) return continues(*steps_);
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    if (continues(i)) return true;
  }
  return false;
}

const std::uint64_t* Replay::peek(std::uint32_t channel, std::uint32_t episode) const {
  const Row* const row = channels_[channel].given ? next_row(channel) : nullptr;
  return row != nullptr && row->episode == episode ? log_.values_of(*row) : nullptr;
}

const std::uint64_t* Replay::expect(std::uint32_t channel, std::uint32_t episode, Seq seq) {
  ChannelState& state = channels_[channel];
  if (!go_on() || state.rows.empty()) return nullptr;
  const Row* const row = next_row(channel);
  if (row == nullptr && !log_.complete) {
    ended_early_ = true;
    return nullptr;
  }
  if (row == nullptr || row->episode != episode || row->seq != seq) {
    divergence_ = Divergence{channel, episode, seq, std::nullopt, 0, 0, row ? row->line : 0};
    return nullptr;
  }
  ++state.next;
  given_ += state.given;
  return log_.values_of(*row);
}

void Replay::compare(std::uint32_t channel, std::uint32_t episode, Seq seq,
                     const std::uint64_t* bits) {
  const std::uint64_t* const recorded = expect(channel, episode, seq);
  if (recorded == nullptr) return;
  for (std::size_t i = 0; i < facts_[channel].size; ++i) {
    if (bits[i] != recorded[i]) return differ(channel, i, bits[i], recorded[i]);
  }
  ++equal_;
}

void Replay::differ(std::uint32_t channel, std::size_t element, std::uint64_t here,
                    std::uint64_t recorded) {
  const ChannelState& state = channels_[channel];
  const Row& row = log_.rows[state.rows[state.next - 1]];
  divergence_ = Divergence{channel, row.episode, row.seq, element, here, recorded, row.line};
}

void Replay::end_episode(std::uint32_t episode) {
  for (std::uint32_t i = 0; i < channels_.size() && go_on(); ++i) {
    const Row* const row = next_row(i);
    if (row != nullptr && row->episode <= episode)
      divergence_ = Divergence{i, row->episode, row->seq, std::nullopt, 0, 0, row->line};
  }
}

void Replay::end_all() {
  end_episode(std::numeric_limits<std::uint32_t>::max());
}

std::string divergence_text(const Divergence& divergence, const Channel& channel,
                            const std::string& recorded, const std::string& here) {
  const std::string_view name = channel.name;
  const std::size_t slash = std::min(name.rfind('/'), name.size());
  const double time_s = static_cast<double>(divergence.seq) *
                        static_cast<double>(channel.rate_den) /
                        static_cast<double>(channel.rate_num);
  const std::string field(name.substr(std::min(slash + 1, name.size())));
  std::string text = "diverged: episode " + std::to_string(divergence.episode) + ", tick " +
                     std::to_string(divergence.seq) + " (" + std::to_string(time_s) + " s), node " +
                     quoted(name.substr(0, slash)) + ", field " + quoted(field);
  const std::string line = ", line " + std::to_string(divergence.line);
  if (!divergence.element) {
    const bool none = divergence.line == 0;
    return text + ": " +
           (none ? "no such message in " + recorded : "another message in " + recorded + line);
  }
  const Dtype dtype = *dtype_of(channel.dtype);
  return text + ", element " + std::to_string(*divergence.element) + ": " +
         text_of(dtype, divergence.recorded) + " in " + recorded + line + ", " +
         text_of(dtype, divergence.here) + " " + here + ", " +
         distance_text(dtype, divergence.recorded, divergence.here);
}

/// Channels of both that are given, or compared.
std::string Replay::names(bool given) const {
  std::string text;
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    if (channels_[i].rows.empty() || channels_[i].given != given) continue;
    text += std::string(text.empty() ? "" : " ") + facts_[i].name;
  }
  return text.empty() ? "nothing" : text;
}

std::string Replay::report(std::string_view graph, std::string_view engine) const {
  std::string text = "log " + log_.path + ": graph " + log_.graph + " on " + log_.engine +
                     ", seed " + std::to_string(log_.seed) + "\n";
  text += "program: graph " + std::string(graph) + " on " + std::string(engine) + "\n";
  text += "given by the log: " + names(true) + "\n";
  text += "compared: " + names(false) + "\n";
  if (divergence_) {
    const Channel& channel = facts_[divergence_->channel];
    text += divergence_text(*divergence_, channel, "the log", "here") + "\n";
    text += count_text(equal_, "message") + " compared before, all equal; " +
            count_text(given_, "message") + " given\n";
    return text;
  }
  if (!log_.complete) text += "the log ends early, in line " + std::to_string(log_.lines) + "\n";
  text += "equal: " + count_text(equal_, "message") + " compared, " +
          count_text(given_, "message") + " given\n";
  return text;
}

}  // namespace eagerx::trace_log
