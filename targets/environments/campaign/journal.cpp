#include "targets/environments/campaign/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <runtime/host/base/files.hpp>
#include <string_view>
#include <thread>

#include "targets/environments/campaign/record.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

using client::kInputOutput;
using client::Problem;

constexpr std::string_view kTitle = "eagerx-gen campaign 1 ";

/// The file is claimed, so another program has its lock only for as long as it takes to see that.
bool is_locked(int file) {
  using namespace std::chrono_literals;
  constexpr int kTries = 200;
  for (int i = 0; i < kTries; ++i) {
    // Some file systems have no locks.
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

}  // namespace

void refuse_full(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return;
  throw Problem(client::kUsage, "there is already something in `" + path + "`",
                "continue it: `--resume " + path + "`, or name another file");
}

void put(const Plan& plan, std::uint32_t chunk, const Results& part, Results& all) {
  const std::size_t first = plan.first_of(chunk);
  const auto copy = [&](const auto& from, auto& to, std::size_t width) {
    std::ranges::copy(from, to.begin() + static_cast<std::ptrdiff_t>(first * width));
  };
  copy(part.returns, all.returns, 1);
  copy(part.steps, all.steps, 1);
  copy(part.flags, all.flags, 1);
  copy(part.states, all.states, part.width);
  for (const auto& [name, count] : part.counts) all.counts[name] += count;
}

Journal::Journal(std::string path, std::string identity)
    : path_(std::move(path)), header_(std::string(kTitle) + std::move(identity) + "\n") {}

Journal::~Journal() {
  if (file_ >= 0) close(file_);
}

/// Opens the file for this program alone, at its end.
void Journal::open(int flags) {
  constexpr mode_t kForAll = 0666;
  const auto refuse = [&](int error) {
    throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + host::problem_of_writing(error));
  };
  if (file_ >= 0) close(file_);
  // Without O_NONBLOCK, opening a FIFO without a writer would block.
  file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK | flags, kForAll);
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0) refuse(errno);
  if (!host::takes_output(status)) refuse(S_ISREG(status.st_mode) ? EACCES : EINVAL);
  if (S_ISREG(status.st_mode) && !is_locked(file_)) refuse(EWOULDBLOCK);
  if (fcntl(file_, F_SETFL, 0) != 0) refuse(errno);
}

void Journal::begin() {
  open(O_CREAT);
  refuse_full(path_);
  write(header_);
}

Journal::Found Journal::resume(const Plan& plan, Results& results) {
  open(0);
  const std::string bytes = client::read_file(path_);
  if (!bytes.starts_with(kTitle)) {
    throw Problem(kInputOutput, "`" + path_ + "` is not a checkpoint of a campaign",
                  "name the file that an earlier campaign had as `--checkpoint`");
  }
  if (!bytes.starts_with(header_)) {
    throw Problem(kInputOutput,
                  "`" + path_ +
                      "` is of another campaign: it has other options, or "
                      "its graph was another",
                  "say the same options as then, or begin anew with `--checkpoint`");
  }
  Found found;
  found.done.resize(plan.chunks());
  std::string good = header_;
  constexpr std::size_t kTimes = 4;
  std::size_t work = kTimes * bytes.size();  // after damage by accident, a few records
  for (std::size_t at = header_.size(); at < bytes.size();) {
    std::string_view left = std::string_view(bytes).substr(at);
    const auto record = take_record(left, plan);
    const std::size_t next =
        record ? bytes.size() - left.size() : find_record(bytes, at + 1, plan, work);
    const std::size_t end = std::min(next, bytes.size());
    if (record && !found.done[record->chunk]) {
      put(plan, record->chunk, record->results, results);
      found.done[record->chunk] = true;
      good.append(bytes, at, end - at);
    } else {
      if (found.damaged_bytes == 0) found.first_damaged = at;
      found.damaged_bytes += end - at;
      found.is_cut_off = !record && found.damaged_bytes == bytes.size() - found.first_damaged;
    }
    at = end;
  }
  // As a whole or not at all: a kill must not cost what is good.
  if (found.damaged_bytes != 0 && !found.is_cut_off) {
    client::write_file(path_, good);
    open(0);
  }
  if (ftruncate(file_, static_cast<off_t>(good.size())) != 0 || lseek(file_, 0, SEEK_END) < 0)
    throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + std::strerror(errno));
  return found;
}

void Journal::add(const std::string& record) {
  write(record);
}

void Journal::write(const std::string& bytes) const {
  std::string_view left = bytes;
  while (!left.empty()) {
    const ssize_t written = ::write(file_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + std::strerror(errno));
    left.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace eagerx::campaign
