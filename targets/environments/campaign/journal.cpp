#include "targets/environments/campaign/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "targets/environments/campaign/record.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

using client::kInputOutput;
using client::Problem;

constexpr std::string_view kTitle = "eagerx-gen campaign 1 ";

}  // namespace

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

void Journal::open(int flags) {
  constexpr mode_t kEverybodyReads = 0644;
  file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | flags, kEverybodyReads);
  if (file_ < 0)
    throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + std::strerror(errno));
}

void Journal::begin() {
  open(O_CREAT | O_TRUNC);
  write(header_);
}

std::vector<bool> Journal::resume(const Plan& plan, Results& results) {
  const std::string bytes = client::read_file(path_);
  if (!bytes.starts_with(kTitle)) {
    throw Problem(kInputOutput, "`" + path_ + "` is no checkpoint of a campaign",
                  "name the file that an earlier campaign had as `--checkpoint`");
  }
  if (!bytes.starts_with(header_)) {
    throw Problem(kInputOutput,
                  "`" + path_ +
                      "` is of another campaign: it has other options, or "
                      "its graph was another",
                  "say the same options as then, or begin anew with `--checkpoint`");
  }
  std::vector<bool> done(plan.chunks());
  std::string_view left = std::string_view(bytes).substr(header_.size());
  std::size_t good = header_.size();
  while (const auto record = take_record(left, plan)) {
    if (done[record->chunk]) break;
    put(plan, record->chunk, record->results, results);
    done[record->chunk] = true;
    good = bytes.size() - left.size();
  }
  open(0);
  // What a kill has cut off.
  if (ftruncate(file_, static_cast<off_t>(good)) != 0 || lseek(file_, 0, SEEK_END) < 0)
    throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + std::strerror(errno));
  return done;
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
