// Messages as topics of ROS 2.
#pragma once

#include <memory>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/sink.hpp>
#include <vector>

namespace eagerx::linux_sim::dds {

/// `chosen`: [channels] which of them are topics.
std::unique_ptr<PublishSink> topic_sink(const Destination& to, const PublishedChannels& channels,
                                        const GraphFacts& facts, std::vector<bool> chosen);

}  // namespace eagerx::linux_sim::dds
