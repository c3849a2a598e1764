// The trace as text, which `--trace` writes on every target. targets/README.md, "The trace file",
// describes its format; runtime/host/trace reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/version.hpp>
#include <string_view>

namespace eagerx {

inline constexpr std::string_view kTraceFirstLine = "# eagerx trace 1";

/// The description of the graph in the first lines.
struct TracedGraph {
  std::string_view name, engine;
  std::uint64_t rate_num, rate_den;  // of the environment [Hz]
  const Channel* channels;
  std::size_t channel_count;
};
template <class Graph>
constexpr TracedGraph traced_graph() {
  return {Graph::kName,     Graph::kEngine,   Graph::Rate::num,
          Graph::Rate::den, Graph::kChannels, sizeof(Graph::kChannels) / sizeof(Channel)};
}

/// `Writer` has text(std::string_view) and number(value).
template <class Writer>
class TraceText {
 public:
  static void head(Writer& out, const TracedGraph& graph, std::uint64_t seed,
                   std::uint32_t environment, std::string_view agent, bool timed) {
    out.text(kTraceFirstLine);
    line(out, "graph", graph.name);
    line(out, "engine", graph.engine);
    begin(out, "rate");
    fraction(out, graph.rate_num, graph.rate_den);
    begin(out, "seed");
    out.number(seed);
    begin(out, "environment");
    out.number(environment);
    line(out, "agent", agent);
    begin(out, "runtime");
    out.number(kVersionMajor);
    out.text(".");
    out.number(kVersionMinor);
    for (std::size_t i = 0; i < graph.channel_count; ++i) {
      const Channel& channel = graph.channels[i];
      line(out, "channel", channel.name);
      out.text(" ");
      out.text(channel.dtype);
      out.text(" ");
      out.number(channel.size);
      out.text(" ");
      fraction(out, channel.rate_num, channel.rate_den);
    }
    out.text(timed ? "\nepisode,channel,seq,time_ns,values\n" : "\nepisode,channel,seq,values\n");
  }

  /// The text before the values of a message.
  static void begin_message(Writer& out, std::uint32_t episode, const Channel& channel, Seq seq) {
    out.number(episode);
    out.text(",");
    out.text(channel.name);
    out.text(",");
    out.number(seq);
  }
  static void time(Writer& out, std::int64_t ns) {
    out.text(",");
    out.number(ns);
  }
  template <class Message>
  static void values(Writer& out, const Message& message) {
    values(out, &element(message, 0), size_of<Message>);
  }
  template <class Scalar>
  static void values(Writer& out, const Scalar* elements, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      out.text(",");
      out.number(elements[i]);
    }
    out.text("\n");
  }

  /// The last line: the number of messages, and their hash. A file without it is incomplete.
  static void end(Writer& out, std::uint64_t messages, std::uint64_t hash) {
    constexpr unsigned kBitsPerDigit = 4;
    constexpr unsigned kBits = 64;
    out.text("# end ");
    out.number(messages);
    out.text(" 0x");
    for (unsigned shift = kBits; shift > 0;) {
      shift -= kBitsPerDigit;
      out.text({&"0123456789abcdef"[(hash >> shift) & 0xfU], 1});
    }
    out.text("\n");
  }

 private:
  static void begin(Writer& out, std::string_view name) {
    out.text("\n# ");
    out.text(name);
    out.text(" ");
  }
  static void line(Writer& out, std::string_view name, std::string_view value) {
    begin(out, name);
    out.text(value);
  }
  static void fraction(Writer& out, std::uint64_t num, std::uint64_t den) {
    out.number(num);
    out.text("/");
    out.number(den);
  }
};

}  // namespace eagerx
