// Datagrams for programs that plot: PlotJuggler's UDP server with its parser for JSON, and
// Teleplot.
#pragma once

#include <memory>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/sink.hpp>

namespace eagerx::linux_sim {

/// One object of JSON a step: `{"timestamp":0.1,"episode":0,"step":3,"node/output":1.5,…}`, with
/// the channels that have had a message since the step before, each with its last one.
std::unique_ptr<PublishSink> udp_sink(const Destination& to, const PublishedChannels& channels);
/// Lines `node/output:MILLISECONDS:VALUE` for each number that is finite, at each step.
std::unique_ptr<PublishSink> teleplot_sink(const Destination& to,
                                           const PublishedChannels& channels);

}  // namespace eagerx::linux_sim
