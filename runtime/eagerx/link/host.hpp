// The host's end of the link. The host is the master: it sends a request when it needs messages of
// the board (or its frame is full), and repeats it until the answer with its number arrives. So a
// line that drops, duplicates, delays, reorders or corrupts frames changes only the duration of a
// run, or the run stops with a reason. A host that knows its next requests can submit() them before
// it waits for the first answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/link/board.hpp>
#include <eagerx/link/frame.hpp>
#include <eagerx/link/stream.hpp>

namespace eagerx::link {

/// The reason why a connection has ended.
enum class Problem : std::uint8_t {
  none,
  no_answer,       // within the time limit
  closed,          // the line
  other_protocol,  // of the link: another eagerx-gen
  other_runtime,   // version
  other_graph,     // or the same, generated at another time from other sources
  refused,         // the board's status says why
  out_of_step,     // an answer without the messages that are due
};

struct Statistics {
  std::uint64_t exchanges = 0;  // requests that were answered
  std::uint64_t repeated = 0;   // requests that were sent again
  std::uint64_t ignored = 0;    // frames that were damaged, late or twice there
  std::uint64_t bytes_out = 0, bytes_in = 0;
  std::uint64_t slowest_ns = 0;  // from a request to its answer
};

/// `Port` has put(byte), flush() and get(until_ns), which returns a byte, kNothing after a
/// time-out, or kClosed; and now_ns(), a monotonic clock. It may have write_until(ns), after which
/// unwritten bytes are dropped, and is_interrupted(), which ends the wait for a late answer because
/// the run is interrupted. `Depth`: maximum number of unanswered requests, the same as in the
/// board's BoardLink.
template <class Port, std::size_t ToBoard, std::size_t ToHost, std::size_t Depth = 1>
class HostLink : public Stream<HostLink<Port, ToBoard, ToHost, Depth>> {
  static_assert(ToBoard >= Greeting::kBytes && ToHost >= Greeting::kBytes && Depth >= 1);
  static constexpr std::uint64_t kFirstRepeatNs = 200'000'000;
  static constexpr std::uint64_t kLeastRepeatNs = 20'000'000;
  static constexpr std::uint64_t kMostRepeatNs = 4'000'000'000;
  static constexpr std::uint64_t kLookNs = 20'000'000;    // for a request to end
  static constexpr std::uint64_t kHurryNs = 250'000'000;  // an answer then takes at most

 public:
  Port port;

  void set_time_limit(std::uint64_t ns) { limit_ns_ = ns; }
  /// Sets a function `f(context)` to call once in every exchange that takes longer than `ns`, while
  /// it continues to wait; nullptr: none.
  void on_silence(std::uint64_t ns, void (*f)(void*), void* context) {
    silence_ns_ = ns;
    silent_ = f;
    silent_context_ = context;
  }
  /// Begins a session; `session` is a new number. False: see problem().
  bool open(Identity identity, std::uint32_t session) {
    Greeting hello;
    hello.runtime = identity.runtime;
    hello.graph = identity.graph;
    hello.session = session;
    std::uint8_t bytes[Greeting::kBytes];
    hello.write(bytes);
    waiting_ = 0;
    out().clear();
    out().append(bytes, sizeof bytes);
    number_ = 0;
    read_ = received_ = 0;
    repeat_ns_ = kFirstRepeatNs;
    session_ = session;
    problem_ = Problem::none;
    const std::uint64_t begun = port.now_ns();
    send_next(Kind::hello, 0, begun);
    if (!answer_comes(Kind::welcome, 0, 0, begun)) return false;
    other_ = Greeting::read(in_.payload());
    received_ = 0;
    crc_start_ = hello.crc_start();
    problem_ = other_.protocol != kProtocol         ? Problem::other_protocol
               : other_.runtime != identity.runtime ? Problem::other_runtime
               : other_.graph != identity.graph     ? Problem::other_graph
               : other_.status != 0                 ? Problem::refused
                                                    : Problem::none;
    open_ = ok();
    return open_;
  }
  bool ok() const { return problem_ == Problem::none; }
  Problem problem() const { return problem_; }
  /// The board's description of itself, after open().
  const Greeting& board() const { return other_; }
  const Statistics& statistics() const { return statistics_; }

  /// Sets the lateness that the next begin_step() sends.
  void set_late(std::uint64_t in_a_row) {
    constexpr std::uint64_t kMost = 255;
    late_ = static_cast<std::uint8_t>(in_a_row < kMost ? in_a_row : kMost);
  }
  void make_safe() { step_ = Command::safe_step; }
  void begin_step() {
    command(step_);
    this->put(late_);
  }
  void begin_episode(const Episode& episode) {
    command(Command::reset);
    episode.put(*this);
  }
  /// Ends a run: sends everything, reads the board's report, and calls f(name, count) for each of
  /// its counts.
  template <class F>
  bool finish(Report& report, F&& f) {
    command(Command::finish);
    return report.get(*this) && get_counts(*this, f);
  }

  void put_bytes(const std::uint8_t* bytes, std::size_t size) {
    while (size > 0 && ok()) {
      const std::size_t taken = out().append(bytes, size);
      bytes += taken;
      size -= taken;
      // A host that submits requests has frames large enough for all their contents.
      if (size > 0 && waiting_ > 0) problem_ = Problem::out_of_step;
      if (size > 0) request();
    }
  }
  bool get_bytes(std::uint8_t* bytes, std::size_t size) {
    while (size > 0 && ok()) {
      if (read_ == received_) {
        request();
        if (ok() && received_ == 0) problem_ = Problem::out_of_step;
        continue;
      }
      *bytes++ = in_.payload()[read_++];
      --size;
    }
    return ok();
  }

  /// Sends the messages that the board needs for its next ones, if there are any, without waiting
  /// for the answer. Before that, get() the answers to the oldest requests until is_full() is
  /// false.
  void submit() {
    if (!open_ || !ok() || out().empty()) return;
    send_request(port.now_ns());
  }
  bool is_full() const { return waiting_ == Depth && !out_[filled_].empty(); }

 private:
  static constexpr std::size_t kFrames = Depth + 1;  // one is being filled

  void command(Command what) { this->put(static_cast<std::uint8_t>(what)); }
  OutFrame<ToBoard>& out() { return out_[filled_]; }
  /// The frame sent `back` frames before the one that is being filled.
  OutFrame<ToBoard>& sent(std::size_t back) { return out_[place_of(back)]; }
  std::size_t place_of(std::size_t back) const { return (filled_ + kFrames - back) % kFrames; }

  void request() {
    // Programs of the same graph never send a request before they have read everything.
    if (!open_) problem_ = Problem::closed;
    if (ok() && read_ != received_) problem_ = Problem::out_of_step;
    if (!ok()) return;
    const std::uint64_t begun = port.now_ns();
    if (waiting_ == 0) send_request(begun);
    answered_ = next_number(answered_);
    if (answer_comes(Kind::answer, answered_, crc_start_, begun)) ++statistics_.exchanges;
  }
  void send_request(std::uint64_t now_ns) {
    if (waiting_ == 0) answered_ = number_;
    number_ = next_number(number_);
    send_next(Kind::request, crc_start_, now_ns);
  }

  void send_next(Kind kind, std::uint32_t crc_start, std::uint64_t now_ns) {
    out().seal(kind, number_, crc_start);
    sent_ns_[filled_] = now_ns;
    ++waiting_;
    filled_ = (filled_ + 1) % kFrames;
    out().clear();
    const std::uint64_t until = now_ns + repeat_ns_;
    const std::uint64_t silence = silent_ != nullptr ? now_ns + silence_ns_ : UINT64_MAX;
    send(sent(1), silence < until ? silence : until);
  }

  /// Waits for the answer to the oldest unanswered request, and resends all unanswered requests if
  /// it does not arrive. The answer is then in in_. The time starts at `begun`.
  bool answer_comes(Kind wanted, std::uint32_t number, std::uint32_t crc_start,
                    std::uint64_t begun) {
    awaited_ = number;
    end_ns_ = begun + limit_ns_;
    hurries_ = false;
    look(begun);
    std::uint64_t silence = silent_ != nullptr ? begun + silence_ns_ : UINT64_MAX;
    std::uint64_t patience = repeat_ns_;
    for (bool again = false;; again = true) {
      const std::uint64_t now = port.now_ns();
      if (now >= end_ns_) return problem_ = Problem::no_answer, false;
      const std::uint64_t until = now + patience < end_ns_ ? now + patience : end_ns_;
      const std::uint64_t first = silence < until ? silence : until;
      if (again) send_again(first);
      bool answered = wait_for(wanted, crc_start, first);
      if (!answered && ok() && port.now_ns() >= silence) {
        silence = UINT64_MAX;
        silent_(silent_context_);
        answered = wait_for(wanted, crc_start, until);
      }
      if (answered) {
        note_time(port.now_ns() - sent_ns_[place_of(waiting_)], again);
        break;
      }
      if (!ok()) return false;
      patience = patience < kMostRepeatNs / 2 ? patience * 2 : kMostRepeatNs;
    }
    --waiting_;
    read_ = 0;
    received_ = in_.size();
    return true;
  }
  void send_again(std::uint64_t until_ns) {
    for (std::size_t back = waiting_; back > 0; --back) send(sent(back), until_ns);
    statistics_.repeated += waiting_;
  }

  bool wait_for(Kind wanted, std::uint32_t crc_start, std::uint64_t until_ns) {
    std::uint64_t next_ns = next_look(port.now_ns(), until_ns);
    for (;;) {
      const int byte = port.get(next_ns);
      if (byte == kNothing) {
        const std::uint64_t now = port.now_ns();
        look(now);
        if (now >= until_ns || now >= end_ns_) return false;
        next_ns = next_look(now, until_ns);
        continue;
      }
      if (byte == kClosed) return problem_ = Problem::closed, false;
      ++statistics_.bytes_in;
      const std::uint32_t damaged = in_.damaged();
      if (!in_.take(static_cast<std::uint8_t>(byte))) {
        statistics_.ignored += in_.damaged() - damaged;
      } else if (in_.kind() == wanted && in_.number() == awaited_ && in_.intact(crc_start) &&
                 (wanted != Kind::welcome || is_our_welcome())) {
        return true;
      } else {
        ++statistics_.ignored;
      }
    }
  }
  /// An interrupted run does not wait for a board that may be silent.
  void look(std::uint64_t now_ns) {
    if constexpr (requires { port.is_interrupted(); }) {
      if (hurries_ || !port.is_interrupted()) return;
      hurries_ = true;
      const std::uint64_t soon_ns = now_ns + kHurryNs + 4 * typical_ns_;
      if (soon_ns < end_ns_) end_ns_ = soon_ns;
    }
  }
  std::uint64_t next_look(std::uint64_t now_ns, std::uint64_t until_ns) const {
    if constexpr (requires { port.is_interrupted(); })
      return now_ns + kLookNs < until_ns ? now_ns + kLookNs : until_ns;
    return until_ns;
  }
  bool is_our_welcome() const {
    return in_.size() == Greeting::kBytes && Greeting::read(in_.payload()).session == session_;
  }

  void send(const OutFrame<ToBoard>& frame, [[maybe_unused]] std::uint64_t until_ns) {
    if constexpr (requires { port.write_until(until_ns); }) port.write_until(until_ns);
    frame.send([this](std::uint8_t byte) {
      ++statistics_.bytes_out;
      port.put(byte);
    });
    port.flush();
  }

  /// The time-out adapts to the time that answers take, and doubles after each time-out, so that a
  /// slow board is not overloaded (Karn, Partridge, 1987).
  void note_time(std::uint64_t ns, bool repeated) {
    if (ns > statistics_.slowest_ns) statistics_.slowest_ns = ns;
    if (repeated) {
      repeat_ns_ = repeat_ns_ < kMostRepeatNs / 2 ? repeat_ns_ * 2 : kMostRepeatNs;
      return;
    }
    typical_ns_ = typical_ns_ == 0 ? ns : typical_ns_ - typical_ns_ / 8 + ns / 8;
    const std::uint64_t patience = 4 * typical_ns_ + kLeastRepeatNs;
    repeat_ns_ = patience < kMostRepeatNs ? patience : kMostRepeatNs;
  }

  InFrame<ToHost> in_;
  OutFrame<ToBoard> out_[kFrames];
  std::uint64_t sent_ns_[kFrames] = {};
  std::size_t filled_ = 0;   // of out_
  std::size_t waiting_ = 0;  // for their answers, those before it
  Statistics statistics_;
  Greeting other_;
  std::size_t read_ = 0, received_ = 0;
  std::uint64_t limit_ns_ = 5'000'000'000;
  std::uint64_t end_ns_ = 0;  // of the exchange
  std::uint64_t silence_ns_ = 0;
  void (*silent_)(void*) = nullptr;
  void* silent_context_ = nullptr;
  std::uint64_t repeat_ns_ = kFirstRepeatNs;
  std::uint64_t typical_ns_ = 0;
  std::uint32_t number_ = 0;    // of the last request
  std::uint32_t answered_ = 0;  // of the last answer, or of one that is waited for
  std::uint32_t awaited_ = 0;   // in the frame that is waited for
  std::uint32_t session_ = 0;
  std::uint32_t crc_start_ = 0;
  Problem problem_ = Problem::closed;
  Command step_ = Command::step;
  std::uint8_t late_ = 0;
  bool open_ = false;
  bool hurries_ = false;
};

/// A dummy link, for programs that only describe themselves.
struct NoLink {
  static constexpr bool ok() { return false; }
  static void begin_step() {}
  static void begin_episode(const Episode& /*episode*/) {}
  template <class... Message>
  static void put(const Message&... /*message*/) {}
  template <class... Message>
  static bool get(Message&&... /*message*/) {
    return false;
  }
  static bool is_pipelined() { return false; }
  template <class Part>
  static bool is_full(Part /*part*/) {
    return false;
  }
  template <class Part>
  static void submit(Part /*part*/) {}
};

}  // namespace eagerx::link
