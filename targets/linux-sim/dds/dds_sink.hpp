// Messages as topics of ROS 2.
#pragma once

#include <memory>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/sink.hpp>

namespace eagerx::linux_sim::dds {

std::unique_ptr<PublishSink> topic_sink(const Destination& to, const PublishedChannels& channels,
                                        const GraphFacts& facts);

}  // namespace eagerx::linux_sim::dds
