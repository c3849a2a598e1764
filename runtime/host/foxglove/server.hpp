// A server of Foxglove's WebSocket protocol: channels, the drawing, time, parameters, services.
#pragma once

#include <memory>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/remote.hpp>
#include <runtime/host/publish/sink.hpp>
#include <vector>

namespace eagerx::foxglove {

struct FoxgloveRun {
  const GraphFacts& facts;
  const Fields& fields;
  const PublishedChannels& channels;
  std::vector<bool> chosen;  // [channels]
  bool is_real;
  Remote* remote;        // null: nothing can be changed
  std::string key_file;  // empty: none
};

std::unique_ptr<PublishSink> foxglove_sink(const Destination& to, const FoxgloveRun& run);

}  // namespace eagerx::foxglove
