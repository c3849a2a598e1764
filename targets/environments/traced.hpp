// An environment whose messages are hashed and written to a file.
#pragma once

#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <eagerx/trace_text.hpp>
#include <memory>
#include <runtime/host/base/text_file.hpp>
#include <string>
#include <targets/common/run.hpp>
#include <targets/environments/base/trace_file.hpp>
#include <targets/environments/pictures.hpp>
#include <type_traits>
#include <utility>

namespace eagerx::environments {

/// Hooks for generated programs: hash of all messages and, with a file, their text.
template <class Graph>
class Recorder : public LastShown<Graph> {
 public:
  using Text = TraceText<host::TextFile>;

  void write_to(host::TextFile* file) { file_ = file; }
  std::uint64_t hash() const { return hash_.hash(); }

  void on_episode(std::uint32_t index) {
    episode_ = index;
    hash_.on_episode(index);
  }
  /// Never inlined: a program has a call for each of its messages.
  template <class Message>
  [[gnu::noinline]] void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    hash_.on_message(channel, seq, message);
    if (file_ == nullptr) return;
    ++messages_;
    Text::begin_message(*file_, episode_, Graph::kChannels[channel], seq);
    Text::values(*file_, message);
  }
  void write_end() const {
    if (file_ != nullptr) Text::end(*file_, messages_, hash());
  }

 private:
  HashTrace hash_;
  host::TextFile* file_ = nullptr;
  std::uint64_t messages_ = 0;  // in the file
  std::uint32_t episode_ = 0;
};

/// Takes the place of an environment's program from a reset on.
template <class Graph>
class Traced {
 public:
  typename Graph::template Program<Recorder<Graph>> program{};

  /// Throws Problem if `path` cannot be written, or is written as another trace. Empty: only the
  /// hash.
  Traced(const std::string& path, bool draws) : file_(path) {
    if (draws) program.hooks.draw_from_now_on();
    target::warm_up(program);
    if (file_.is_open()) program.hooks.write_to(&file_.text());
  }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;
  /// A file keeps its contents if no episode follows.
  ~Traced() {
    if (!has_begun()) file_.discard();
  }

  /// Whether its messages go to the file `path`, by any name.
  bool writes_to(const std::string& path) const { return file_.is(path); }

  typename Graph::Observation reset(EpisodeKey key, const typename Graph::States& states) {
    if (file_.is_open() && episode_ == 0)
      file_.begin(traced_graph<Graph>(), key.seed, key.environment);
    if (file_.is_open()) write(states, episode_, nullptr);
    program.hooks.on_episode(episode_++);
    program.hooks.forget();
    return program.reset(states);
  }

  /// Parameters are set before step `step` (from 0) of its episode.
  void tune(std::uint64_t step, const typename Graph::States& states) {
    if (file_.is_open()) write(states, episode_ - 1, &step);
    target::tune(program, states);
  }

  bool has_begun() const { return episode_ > 0; }
  /// The file ends; throws Problem if something of it is lost. The hash continues.
  void end_file() {
    if (!file_.is_open()) return;
    if (has_begun()) {
      program.hooks.write_end();
    } else {
      file_.discard();
    }
    program.hooks.write_to(nullptr);
    file_.close();
  }
  /// Behind each step: rows are in the file after half a second. Throws Problem.
  void hand_on() {
    if (!file_.is_open()) return;
    if (file_.text().failed()) program.hooks.write_to(nullptr);
    file_.hand_on();
  }

 private:
  /// `step`: before which they are set; null: at a reset.
  void write(const typename Graph::States& states, std::uint32_t episode,
             const std::uint64_t* step) {
    Graph::for_each_state([&](const char* name, const char*, auto member, const auto&) {
      using Message = typename std::remove_cvref_t<decltype(states.*member)>::value_type;
      if (!(states.*member)) return;
      file_.begin_state(episode, step, name);
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        file_.text().text(i == 0 ? " " : ",");
        file_.text().number(element(*(states.*member), i));
      }
      file_.text().text("\n");
    });
  }

  TraceFile file_;
  std::uint32_t episode_ = 0;  // since the trace began
};

/// An environment's trace, and the one that begins with its next reset.
template <class Graph>
struct Traces {
  std::unique_ptr<Traced<Graph>> now;
  std::unique_ptr<Traced<Graph>> next;

  /// A trace that cannot be written leaves the old one. Throws Problem.
  void begin(const std::string& path, bool draws) {
    if (next && next->writes_to(path)) return;
    if (now && now->writes_to(path)) now->end_file();
    auto wanted = std::make_unique<Traced<Graph>>(path, draws);
    if (now) now->end_file();
    next = std::move(wanted);
  }
  void end() {
    next.reset();
    if (now) now->end_file();
  }
  /// At a reset: the running trace, null if there is none.
  Traced<Graph>* take() {
    if (next) now = std::move(next);
    return now.get();
  }
};

}  // namespace eagerx::environments
