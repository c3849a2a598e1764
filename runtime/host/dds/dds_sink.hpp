// Messages as topics of ROS 2.
#pragma once

#include <memory>
#include <runtime/host/dds/network.hpp>
#include <runtime/host/dds/topics.hpp>
#include <runtime/host/publish/sink.hpp>
#include <string>
#include <vector>

namespace eagerx::dds {

/// In a program built without Cyclone DDS, open() reports that. `said`: the user's text. `chosen`:
/// [channels] which of them are topics.
std::unique_ptr<publish::PublishSink> topic_sink(const Network& to, std::string said,
                                                 const publish::PublishedChannels& channels,
                                                 const Graph& graph, std::vector<bool> chosen);

}  // namespace eagerx::dds
