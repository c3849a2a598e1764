// Destination of published messages, as programs name it.
#pragma once

#include <runtime/host/publish/sink.hpp>

namespace eagerx::linux_sim {

using publish::PublishedChannels;
using publish::PublishedMessage;
using publish::PublishedScene;
using publish::PublishedStep;
using publish::PublishSink;

}  // namespace eagerx::linux_sim
