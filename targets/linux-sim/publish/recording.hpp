// A recording that grows during the run.
#pragma once

#include <memory>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/sink.hpp>

namespace eagerx::linux_sim {

/// The messages as `eagerx-gen trace convert` writes them. A chunk goes into the file when it is
/// large, or a second after it was begun: a program that is killed leaves all chunks before.
std::unique_ptr<PublishSink> mcap_sink(const Destination& to, const PublishedChannels& channels);

}  // namespace eagerx::linux_sim
