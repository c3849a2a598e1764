#include "targets/environments/campaign/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <type_traits>

#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

using client::kInputOutput;
using client::Problem;

constexpr std::string_view kTitle = "eagerx-gen campaign 1 ";

/// FNV-1a, 64 bits.
std::uint64_t check_sum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

/// Takes numbers from the front of some bytes; all are 0 once there are too few.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void take(T* values, std::size_t count) {
    is_complete_ = is_complete_ && bytes_.size() >= count * sizeof(T);
    if (!is_complete_ || count == 0) return;
    std::memcpy(values, bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
  }
  template <class T>
  T take() {
    T value{};
    take(&value, 1);
    return value;
  }
  std::string_view take_bytes(std::size_t count) {
    is_complete_ = is_complete_ && bytes_.size() >= count;
    if (!is_complete_) return {};
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  bool is_complete() const { return is_complete_; }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool is_complete_ = true;
};

std::string record_of(std::uint32_t chunk, const Results& results) {
  std::string body;
  append(body, &chunk, 1);
  append(body, results.returns.data(), results.size());
  append(body, results.steps.data(), results.size());
  append(body, results.flags.data(), results.size());
  append(body, results.states.data(), results.states.size());
  body += nlohmann::json(results.faults).dump();
  std::string record;
  const auto size = static_cast<std::uint32_t>(body.size());
  const std::uint64_t sum = check_sum(body);
  append(record, &size, 1);
  append(record, &sum, 1);
  return record + body;
}

/// Reads one record; false if it is cut off or damaged.
bool read_record(Reader& reader, const Plan& plan, std::vector<bool>& done, Results& results) {
  const auto size = reader.take<std::uint32_t>();
  const auto sum = reader.take<std::uint64_t>();
  const std::string_view body = reader.take_bytes(size);
  if (!reader.is_complete() || check_sum(body) != sum) return false;
  Reader in(body);
  const auto chunk = in.take<std::uint32_t>();
  if (chunk >= plan.chunks() || done[chunk]) return false;
  Results part(plan.size_of(chunk), plan.columns.size());
  in.take(part.returns.data(), part.size());
  in.take(part.steps.data(), part.size());
  in.take(part.flags.data(), part.size());
  in.take(part.states.data(), part.states.size());
  const auto faults = nlohmann::json::parse(in.take_bytes(in.left()), nullptr, false);
  if (!in.is_complete() || !faults.is_object()) return false;
  part.faults = faults.get<Faults>();
  put(plan, chunk, part, results);
  done[chunk] = true;
  return true;
}

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
  for (const auto& [name, count] : part.faults) all.faults[name] += count;
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
  Reader reader(std::string_view(bytes).substr(header_.size()));
  std::size_t good = bytes.size() - reader.left();
  while (reader.left() != 0 && read_record(reader, plan, done, results))
    good = bytes.size() - reader.left();
  open(0);
  // What a kill has cut off.
  if (ftruncate(file_, static_cast<off_t>(good)) != 0 || lseek(file_, 0, SEEK_END) < 0)
    throw Problem(kInputOutput, "cannot write `" + path_ + "`: " + std::strerror(errno));
  return done;
}

void Journal::add(std::uint32_t chunk, const Results& results) {
  write(record_of(chunk, results));
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
