// The trace: hash and, if wanted, every message in a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <eagerx/version.hpp>
#include <string>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

/// A trace for generated programs that folds messages into the hash and writes them to a file.
/// The format is described in targets/linux-sim/README.md, "The trace file".
template <class Graph>
class TraceRecorder {
 public:
  /// Without a file only the hash is made.
  void write_to(TextFile* file) { file_ = file; }
  std::uint64_t hash() const { return hash_.hash(); }

  void episode(std::uint32_t index) {
    episode_ = index;
    hash_.episode(index);
  }

  /// Never inlined: a program has a call for each of its messages, and a thousand nodes take 15 %
  /// (g++) to 29 % (clang++) more text when all of them are expanded.
  template <class Message>
  [[gnu::noinline]] void operator()(std::uint32_t channel, Seq seq, const Message& message) {
    hash_(channel, seq, message);
    if (file_ != nullptr) write(channel, seq, message);
  }

  static void write_head(TextFile& file, std::uint64_t seed, std::string_view agent) {
    file.text("# eagerx trace 1\n# graph ");
    file.text(Graph::kName);
    file.text("\n# engine ");
    file.text(Graph::kEngine);
    file.text("\n# rate ");
    file.number(Graph::Rate::num);
    file.text("/");
    file.number(Graph::Rate::den);
    file.text("\n# seed ");
    file.number(seed);
    file.text("\n# agent ");
    file.text(agent);
    file.text("\n# runtime ");
    file.number(kVersionMajor);
    file.text(".");
    file.number(kVersionMinor);
    file.text("\nepisode,channel,seq,values\n");
  }

 private:
  template <class Message>
  void write(std::uint32_t channel, Seq seq, const Message& message) {
    file_->number(episode_);
    file_->text(",");
    file_->text(Graph::kChannels[channel]);
    file_->text(",");
    file_->number(seq);
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      file_->text(",");
      file_->number(element(message, i));
    }
    file_->text("\n");
  }

  HashTrace hash_;
  TextFile* file_ = nullptr;
  std::uint32_t episode_ = 0;
};

}  // namespace eagerx::linux_sim
