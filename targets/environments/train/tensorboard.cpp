#include "targets/environments/train/tensorboard.hpp"

#include <unistd.h>

#include <bit>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <eagerx/link/crc32c.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <runtime/host/base/claim.hpp>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

template <class T>
void append_little(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes.push_back(static_cast<char>(value >> (8U * i) & 0xffU));
}

std::uint32_t masked_crc(std::string_view bytes) {
  constexpr std::uint32_t kMask = 0xa282ead8U;
  const std::uint32_t crc =
      link::crc32c(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return (crc >> 15U | crc << 17U) + kMask;
}

// Protocol buffers: the number of a field with how its value is written.
constexpr std::uint64_t kVarint = 0, kDouble = 1, kBytes = 2, kFloat = 5;

void append_varint(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) bytes.push_back(static_cast<char>(value | 0x80U));
  bytes.push_back(static_cast<char>(value));
}
void append_key(std::string& bytes, std::uint64_t field, std::uint64_t how) {
  append_varint(bytes, field << 3U | how);
}
void append_bytes(std::string& bytes, std::uint64_t field, std::string_view value) {
  append_key(bytes, field, kBytes);
  append_varint(bytes, value.size());
  bytes += value;
}

std::string event(double wall_time_s, std::int64_t step) {
  std::string bytes;
  append_key(bytes, 1, kDouble);
  append_little(bytes, std::bit_cast<std::uint64_t>(wall_time_s));
  append_key(bytes, 2, kVarint);
  append_varint(bytes, static_cast<std::uint64_t>(step));
  return bytes;
}

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string tfrecord(std::string_view bytes) {
  std::string record;
  append_little(record, std::uint64_t{bytes.size()});
  append_little(record, masked_crc(record));
  record += bytes;
  append_little(record, masked_crc(bytes));
  return record;
}

std::string first_event(double wall_time_s) {
  std::string bytes = event(wall_time_s, 0);
  append_bytes(bytes, 3, "brain.Event:2");
  return tfrecord(bytes);
}

namespace {

std::string scalar_value(const std::pair<std::string, double>& scalar) {
  std::string value;
  append_bytes(value, 1, scalar.first);
  append_key(value, 2, kFloat);
  append_little(value, std::bit_cast<std::uint32_t>(static_cast<float>(scalar.second)));
  return value;
}

}  // namespace

std::string scalar_event(double wall_time_s, std::int64_t step, const Scalars& scalars) {
  std::string summary;
  for (const auto& scalar : scalars) append_bytes(summary, 1, scalar_value(scalar));
  std::string bytes = event(wall_time_s, step);
  append_bytes(bytes, 5, summary);
  return tfrecord(bytes);
}

Scalars scalars_of(const CurvePoint& point) {
  Scalars all = {{"rollout/ep_rew_mean", point.mean_return},
                 {"rollout/success_rate", point.success},
                 {"eval/mean_reward", point.evaluation_return},
                 {"eval/success_rate", point.evaluation_success},
                 {"train/std", point.deviation},
                 {"train/learning_rate", point.step_size},
                 {"train/approx_kl", point.divergence},
                 {"stage/number", point.stage},
                 {"stage/success_rate", point.stage_success},
                 {"stage/mean_reward", point.stage_return}};
  std::erase_if(all, [](const auto& scalar) { return std::isnan(scalar.second); });
  return all;
}

void check_folder(const std::string& folder) {
  std::error_code ignored;
  std::filesystem::path there = std::filesystem::absolute(folder, ignored);
  while (there.has_relative_path() && !std::filesystem::exists(there, ignored))
    there = there.parent_path();
  if (std::filesystem::is_directory(there, ignored) && access(there.c_str(), W_OK) == 0) return;
  throw Problem(kInputOutput, "cannot make `" + folder + "`: nothing can be written into `" +
                                  there.string() + "`");
}

namespace {

constexpr const char* kEvents = "events.out.tfevents.";

/// Whether an event file has points of `curve` only: the same training wrote it, before it was
/// resumed. Times may differ.
bool is_of(const std::filesystem::path& file, const std::vector<CurvePoint>& curve) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
  constexpr std::size_t kHead = sizeof(std::uint64_t) + sizeof(std::uint32_t);
  constexpr std::size_t kTime = 1 + sizeof(double);
  std::error_code error;
  if (std::filesystem::file_size(file, error) > kMostBytes || error) return false;
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const auto record = [&](std::size_t at) -> std::string_view {
    std::uint64_t length = 0;
    if (bytes.size() < at + kHead) return {};
    std::memcpy(&length, bytes.data() + at, sizeof length);
    if (length < kTime || length > bytes.size() - at - kHead) return {};
    return std::string_view(bytes).substr(at + kHead, static_cast<std::size_t>(length));
  };
  std::size_t at = 0;
  for (std::size_t i = 0; at < bytes.size(); ++i) {
    const std::string_view found = record(at);
    if (found.empty() || i > curve.size()) return false;
    at += kHead + found.size() + sizeof(std::uint32_t);
    if (i == 0) continue;  // says what kind of file it is
    const CurvePoint& point = curve[i - 1];
    const std::string steps = event(0.0, static_cast<std::int64_t>(point.steps)).substr(kTime);
    if (!found.substr(kTime).starts_with(steps)) return false;
    for (const auto& scalar : scalars_of(point)) {
      if (found.find(scalar_value(scalar)) == std::string_view::npos) return false;
    }
  }
  return true;
}

/// Whether a curve in `folder` is that of another training.
bool has_other_curve(const std::filesystem::path& folder, const std::string& own,
                     const std::vector<CurvePoint>& curve) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kEvents)) continue;
    if (name != own || !is_of(entry.path(), curve)) return true;
  }
  return false;
}

/// Whether no other training that runs writes there.
bool claims(const std::string& folder, const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Problem(kInputOutput, "cannot make `" + folder + "`: " + error.message());
  return host::claim_output(folder + "/" + name) == 0;
}

}  // namespace

EventFile::EventFile(const std::string& folder, const std::string& graph,
                     const std::vector<CurvePoint>& curve)
    : folder_(folder) {
  const std::string name = std::string(kEvents) + "0." + graph;
  for (int run = 2; has_other_curve(folder_, name, curve) || !claims(folder_, name); ++run)
    folder_ = folder + "/run" + std::to_string(run);
  path_ = folder_ + "/" + name;
  write_file(path_, first_event(now_s()));
  for (const CurvePoint& point : curve) append(point);
}

void EventFile::append(const CurvePoint& point, const Scalars& more) {
  Scalars scalars = scalars_of(point);
  scalars.insert(scalars.end(), more.begin(), more.end());
  write(scalar_event(now_s(), static_cast<std::int64_t>(point.steps), scalars));
}

/// At the end of the file. A half record behind a full disk would hide what comes after it, so
/// nothing more is written then.
void EventFile::write(const std::string& record) {
  if (!problem_.empty()) return;
  std::ofstream file(path_, std::ios::binary | std::ios::app);
  file << record << std::flush;
  if (!file) problem_ = "cannot write `" + path_ + "`: " + std::strerror(errno);
}

}  // namespace eagerx::train
