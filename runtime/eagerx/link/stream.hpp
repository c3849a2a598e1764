// Messages and commands as bytes, on top of a byte stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>
#include <type_traits>

namespace eagerx::link {

/// The host's next command to the board; one byte among the messages.
enum class Command : std::uint8_t {
  step = 1,  // with a byte: instants in a row that the host was late, at most 255
  reset = 2,
  finish = 3,
  safe_step = 4,  // as `step`, with the safe action instead of the agent's
};

/// The data of a reset: both programs sample the same states from the key.
struct Episode {
  EpisodeKey key{};
  std::uint8_t agent = 0;  // where the board decides: which of its agents

  template <class Link>
  void put(Link& link) const {
    link.put(key.seed);
    link.put(key.environment);
    link.put(key.episode);
    link.put(agent);
  }
  template <class Link>
  bool get(Link& link) {
    return link.get(key.seed) && link.get(key.environment) && link.get(key.episode) &&
           link.get(agent);
  }
};
/// Size of the longest command, the one with an episode.
inline constexpr std::size_t kCommandBytes = 18;

/// The board's report at the end of a run; a list of counts by name follows, with an empty name at
/// its end.
struct Report {
  std::uint32_t stack_bytes = 0;  // the deepest use; 0: not measured
  std::uint32_t damaged = 0;      // frames that it dropped

  template <class Link>
  void put(Link& link) const {
    link.put(stack_bytes);
    link.put(damaged);
  }
  template <class Link>
  bool get(Link& link) {
    return link.get(stack_bytes) && link.get(damaged);
  }
};

/// Writes an entry of that list: at most 255 characters of the name, without its 0.
template <class Link>
[[gnu::noinline]] void put_count(Link& link, const char* name, std::uint64_t count) {
  constexpr std::uint8_t kLongest = 255;
  std::uint8_t length = 0;
  while (length < kLongest && name[length] != '\0') ++length;
  link.put(length);
  link.put_bytes(reinterpret_cast<const std::uint8_t*>(name), length);
  link.put(count);
}
template <class Link>
void end_counts(Link& link) {
  link.put(std::uint8_t{0});
}
/// Calls f(name, count) for each entry; false if the connection has ended, or if there are too
/// many.
template <class Link, class F>
bool get_counts(Link& link, F&& f) {
  constexpr int kMost = 10'000;
  constexpr std::size_t kLongest = 255;
  for (int i = 0; i < kMost; ++i) {
    std::uint8_t length = 0;
    if (!link.get(length)) return false;
    if (length == 0) return true;
    char name[kLongest + 1];
    std::uint64_t count = 0;
    if (!link.get_bytes(reinterpret_cast<std::uint8_t*>(name), length) || !link.get(count))
      return false;
    name[length] = '\0';
    // Replaces characters that could control a terminal.
    for (std::size_t k = 0; k < length; ++k)
      name[k] = name[k] >= ' ' && name[k] <= '~' ? name[k] : '?';
    f(static_cast<const char*>(name), count);
  }
  return false;
}

/// Adds messages to a class `Link` with put_bytes(bytes, size) and get_bytes(bytes, size), which
/// returns false if the connection has ended.
template <class Link>
class Stream {
 public:
  /// Sends numbers as in memory, and a bool as 0 or 1.
  template <class Message>
  void put(const Message& message) {
    self().put_bytes(reinterpret_cast<const std::uint8_t*>(&message), sizeof message);
  }
  /// False if the connection has ended; the message may then be partly overwritten.
  template <class Message>
  bool get(Message& message) {
    static_assert(std::is_trivially_copyable_v<Message>);
    auto* const bytes = reinterpret_cast<std::uint8_t*>(&message);
    if (!self().get_bytes(bytes, sizeof message)) return false;
    if constexpr (std::is_same_v<ScalarOf<Message>, bool>) {
      // Any other byte would not be a valid bool.
      for (std::size_t i = 0; i < sizeof message; ++i) bytes[i] = bytes[i] != 0 ? 1 : 0;
    }
    return true;
  }

 private:
  Link& self() { return static_cast<Link&>(*this); }
};

}  // namespace eagerx::link
