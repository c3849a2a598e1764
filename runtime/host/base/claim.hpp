// Which program writes a file: two that write one would mix or replace each other's results.
#pragma once

#include <string>

namespace eagerx::host {

/// Claims a file that Drafts replace, until this process ends, however it ends: EWOULDBLOCK if
/// another process has claimed it, by whatever name, or a TextFile has reserved it. 0: nobody has;
/// also for what this process has claimed before, for a device or FIFO, and where the system has no
/// such claims. Nothing is made on the disk: a claim is a name of Linux' abstract sockets, which
/// the kernel removes.
[[nodiscard]] int claim_output(const std::string& path);

/// Whether another process has claimed it.
[[nodiscard]] bool is_claimed(const std::string& path);

}  // namespace eagerx::host
