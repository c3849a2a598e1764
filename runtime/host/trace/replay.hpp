// Repeats a run with a log: takes the given messages from the log, and compares the others with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <optional>
#include <runtime/host/trace/log_file.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::trace_log {

/// Where a program and a log part.
struct Divergence {
  std::uint32_t channel = 0;  // of the program
  std::uint32_t episode = 0;
  Seq seq = 0;
  std::optional<std::size_t> element;    // without: one of the two has no such message
  std::uint64_t here = 0, recorded = 0;  // bits
  std::size_t line = 0;                  // of the log; 0: nowhere
};

/// Goes through a log message by message as the program sends its own. Channels that the log or the
/// program does not have are left alone.
class Replay {
 public:
  Replay(const Log& log, std::span<const Channel> channels);

  /// `given` lists what is taken from the log, separated by commas: channels, `actions` or
  /// `sensors` (messages of engine nodes). False if log and program do not fit; see `problem`.
  bool prepare(std::string_view given, bool engine_is_real, std::string& problem);

  bool runs_engine() const { return runs_engine_; }
  bool go_on() const { return !divergence_ && !ended_early_; }
  /// Whether the log has another step of this episode.
  bool has_step(std::uint32_t episode) const;
  /// After the last step: messages that only the log has are a divergence.
  void end_episode(std::uint32_t episode);
  /// The same after the last episode, for messages of all later ones.
  void end_all();

  /// The next message of `channel`, of `size` elements, if the log supplies it, without advancing.
  template <class Scalar>
  void copy(std::uint32_t channel, std::uint32_t episode, Scalar* elements,
            std::size_t size) const {
    const std::uint64_t* const recorded = peek(channel, episode);
    if (recorded != nullptr) assign(elements, size, recorded);
  }

  /// Compares a message of the program, of `size` elements, or replaces it with that of the log.
  template <class Scalar>
  void message(std::uint32_t channel, std::uint32_t episode, Seq seq, Scalar* elements,
               std::size_t size) {
    const std::uint64_t* const recorded = expect(channel, episode, seq);
    if (recorded == nullptr) return;
    if (channels_[channel].given) return assign(elements, size, recorded);
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t bits = canonical_bits(elements[i]);
      if (bits != recorded[i]) return differ(channel, i, bits, recorded[i]);
    }
    ++equal_;
  }
  /// The same for a message in bits, which is always compared.
  void compare(std::uint32_t channel, std::uint32_t episode, Seq seq, const std::uint64_t* bits);

  /// False if a common channel has another type, size or rate; see `problem`.
  bool fits(std::string& problem) const;

  const std::optional<Divergence>& divergence() const { return divergence_; }
  std::uint64_t equal() const { return equal_; }
  std::uint64_t given() const { return given_; }
  /// The result, in lines of text.
  std::string report(std::string_view graph, std::string_view engine) const;

 private:
  struct ChannelState {
    std::optional<std::uint32_t> in_log;
    bool given = false;
    std::vector<std::size_t> rows;  // of the log
    std::size_t next = 0;
  };

  template <class Scalar>
  static void assign(Scalar* elements, std::size_t size, const std::uint64_t* recorded) {
    for (std::size_t i = 0; i < size; ++i) elements[i] = value_of<Scalar>(recorded[i]);
  }

  const std::uint64_t* peek(std::uint32_t channel, std::uint32_t episode) const;
  const Row* next_row(std::uint32_t channel) const;
  const std::uint64_t* expect(std::uint32_t channel, std::uint32_t episode, Seq seq);
  void differ(std::uint32_t channel, std::size_t element, std::uint64_t here,
              std::uint64_t recorded);
  bool is_another_engine(std::uint32_t channel) const;
  void choose(std::string_view given);
  std::string names(bool given) const;

  const Log& log_;
  std::span<const Channel> facts_;
  std::vector<ChannelState> channels_;
  // The channel of an action, which every step has once. Without one, steps continue as long as
  // there are messages.
  std::optional<std::uint32_t> steps_;
  bool runs_engine_ = true;
  bool ended_early_ = false;
  std::uint64_t equal_ = 0, given_ = 0;
  std::optional<Divergence> divergence_;
};

/// One line with the place, both values and their distance. `recorded` and `here` name the two
/// sides.
std::string divergence_text(const Divergence& divergence, const Channel& channel,
                            const std::string& recorded, const std::string& here);
/// "1 message", "2 messages"
std::string count_text(std::uint64_t count, std::string_view what);

}  // namespace eagerx::trace_log
