// Files that grow during a stream: they contain everything up to the last second, even if the
// monitor is killed. Inside monitor/ only.
#pragma once

#include <memory>
#include <runtime/host/publish/sink.hpp>
#include <string>

#include "generator/tools/monitor/stream.hpp"

namespace eagerx::gen {

/// MCAP, as `eagerx-gen trace convert` writes it.
std::unique_ptr<publish::PublishSink> mcap_file(const std::string& path,
                                                const publish::PublishedChannels& channels);
/// A trace of one run, without its last line. `facts` must outlive it.
std::unique_ptr<publish::PublishSink> trace_file(const std::string& path, const StreamFacts& facts,
                                                 const publish::PublishedChannels& channels);

}  // namespace eagerx::gen
