// Datagrams for plotting programs: PlotJuggler's UDP server with its JSON parser, and Teleplot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <runtime/host/publish/address.hpp>
#include <runtime/host/publish/sink.hpp>

namespace eagerx::publish {

/// Most bytes of one.
inline constexpr std::size_t kMostDatagramBytes = 65'507;

/// One object of JSON a step: `{"timestamp":0.1,"episode":0,"step":3,"graph":"0x…",
/// "node/output":1.5,…}`, with the hash of the graph and the channels that have had a message since
/// the step before, each with its last one.
std::unique_ptr<PublishSink> udp_sink(const Address& to, const PublishedChannels& channels,
                                      std::uint64_t graph_hash);
/// Lines `node/output:MILLISECONDS:VALUE` for each number that is finite, at each step.
std::unique_ptr<PublishSink> teleplot_sink(const Address& to, const PublishedChannels& channels);

}  // namespace eagerx::publish
