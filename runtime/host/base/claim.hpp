// Claims a file for one program: two writers would mix or overwrite each other's results.
#pragma once

#include <string>

namespace eagerx::host {

/// Claims a file that Drafts replace until this process exits or is killed. Returns EWOULDBLOCK if
/// another process has claimed the file under any of its names, or a TextFile has reserved it.
/// Returns 0 otherwise: also for a file that this process has already claimed, for a device or
/// FIFO, and on a system without such claims. Leaves nothing on the disk: a claim is the name of an
/// abstract socket (Linux), which the kernel removes.
[[nodiscard]] int claim_output(const std::string& path);

/// Whether another process has claimed the file.
[[nodiscard]] bool is_claimed(const std::string& path);

}  // namespace eagerx::host
