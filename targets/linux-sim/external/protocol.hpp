// Protocol between a program and an external agent: datagrams over a socket that both inherit. Both
// run on one machine, so numbers have the machine's native format.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::linux_sim {

/// Version of this protocol, which an agent checks first.
inline constexpr std::uint32_t kExternalVersion = 3;

/// The requests of an agent; each is answered once.
enum class Ask : std::uint32_t {
  describe = 1,  // piece of the description, JSON
  reset = 2,     // an episode; behind it a row of states, NaN for what is sampled
  step = 3,      // behind it a row of actions
  counts = 4,    // piece of what was counted, JSON
  hash = 5,      // of all messages; in Answer::step
  picture = 6,   // piece of what `render:` showed last, RGB
  close = 7,     // the end of the run; not answered
  tune = 8       // parameters before the next step; behind it a row of states, NaN: as it is
};

/// A request of an agent, followed by a row of float32.
struct Request {
  Ask ask;
  std::uint32_t number;  // first byte of a piece; of a reset whether there is a seed
  std::uint64_t seed;    // episode 0 of it begins; without one the next episode
  std::uint64_t asked;   // any number; its answer has the same
};
static_assert(sizeof(Request) == 24);

enum class AnswerKind : std::uint32_t { problem = 1, piece = 2, number = 3, observation = 4 };

/// An answer of a program. Behind it a text, a piece, or float32: terms of the reward, action,
/// observation.
struct Answer {
  AnswerKind said;
  std::uint32_t episode;
  std::uint64_t asked;   // what the request had: an agent that was interrupted skips older answers
  std::uint64_t step;    // of the episode; of a piece: bytes of all
  std::int64_t time_ns;  // when the observation was there, CLOCK_MONOTONIC
  double reward;         // of all steps since the answer before, as the terms
  std::uint32_t flags;   // kTerminated, …
  std::uint32_t late;    // steps since the answer before that had no action in time
};
static_assert(sizeof(Answer) == 48);

inline constexpr std::uint32_t kTerminated = 1, kTruncated = 2, kSuccess = 4;

/// Maximum bytes after a request or an answer, which fit into a socket with default settings.
inline constexpr std::size_t kLongestRow = std::size_t{1} << 17U;
inline constexpr std::size_t kLongestPiece = std::size_t{1} << 16U;

/// The problem of a datagram of `bytes`, or null. `request` is its beginning.
constexpr const char* problem_of_request(const Request& request, std::size_t bytes,
                                         std::size_t action_numbers, std::size_t state_numbers) {
  if (bytes < sizeof(Request)) return "it is shorter than a request";
  const std::size_t row = bytes - sizeof(Request);
  switch (request.ask) {
    case Ask::reset:
    case Ask::tune:
      return row == state_numbers * sizeof(float) ? nullptr : "its row of states has another size";
    case Ask::step:
      return row == action_numbers * sizeof(float) ? nullptr
                                                   : "its row of actions has another size";
    case Ask::describe:
    case Ask::counts:
    case Ask::hash:
    case Ask::picture:
    case Ask::close:
      return row == 0 ? nullptr : "there is something behind it";
  }
  return "it asks for something that does not exist";
}

}  // namespace eagerx::linux_sim
