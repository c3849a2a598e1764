// The film of a trace: the scenes that differ, thinned so that the page stays small.
#include "generator/tools/page/scenes.hpp"

#include <algorithm>
#include <bit>
#include <eagerx/scene.hpp>
#include <runtime/host/trace/scene_line.hpp>
#include <string>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/json/base64.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;
using trace_log::RecordedScene;

void add_number(std::string& bytes, std::uint32_t value, unsigned size) {
  for (unsigned byte = 0; byte < size; ++byte)
    bytes += static_cast<char>((value >> (8 * byte)) & 0xffU);
}

/// Numbers of a scene as the log has them so far.
class Canvas {
 public:
  void change(const Log& log, const RecordedScene& scene) {
    const std::size_t size = std::size_t{scene.rows} * kSceneColumns;
    numbers_.resize(std::max(numbers_.size(), size));
    for (std::size_t i = scene.first; i < scene.first + scene.changes; ++i)
      numbers_[log.scene_changes[i].index] = log.scene_changes[i].value;
    size_ = size;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t bits(std::size_t i) const {
    return std::bit_cast<std::uint32_t>(numbers_[i]);
  }

 private:
  std::vector<float> numbers_;
  std::size_t size_ = 0;
};

/// tick u32, rows u16, changes u16, and for each change index u16 and float32.
class Encoder {
 public:
  void add(std::uint64_t tick, const Canvas& canvas) {
    std::string changes;
    std::uint32_t count = 0;
    shown_.resize(std::max(shown_.size(), canvas.size()));
    for (std::size_t i = 0; i < canvas.size(); ++i) {
      if (shown_[i] == canvas.bits(i)) continue;
      shown_[i] = canvas.bits(i);
      add_number(changes, static_cast<std::uint32_t>(i), 2);
      add_number(changes, canvas.bits(i), 4);
      ++count;
    }
    add_number(bytes_, static_cast<std::uint32_t>(tick), 4);
    add_number(bytes_, static_cast<std::uint32_t>(canvas.size() / kSceneColumns), 2);
    add_number(bytes_, count, 2);
    bytes_ += changes;
    ++scenes_;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::size_t scenes() const { return scenes_; }

 private:
  std::string bytes_;
  std::vector<std::uint32_t> shown_;
  std::size_t scenes_ = 0;
};

/// Every n-th scene of an episode.
Encoder encode(const Log& log, std::uint32_t episode, std::size_t every) {
  Encoder encoder;
  Canvas canvas;
  std::size_t number = 0;
  for (const RecordedScene& scene : log.scenes) {
    if (scene.episode > episode) break;
    canvas.change(log, scene);
    if (scene.episode == episode && number++ % every == 0) encoder.add(scene.tick, canvas);
  }
  return encoder;
}

}  // namespace

Json scenes_json(const Log& log, std::uint32_t episode, std::size_t most_bytes) {
  static_assert(trace_log::kMostSceneRows * kSceneColumns <= 0xffff, "indexes are 16 bits");
  Json json = nullptr;
  const auto of_episode = [&](const RecordedScene& scene) { return scene.episode == episode; };
  if (ranges::none_of(log.scenes, of_episode)) return json;
  std::size_t every = 1;
  Encoder encoder = encode(log, episode, every);
  while (encoder.bytes().size() > most_bytes && encoder.scenes() > 1) {
    // The size does not shrink in proportion to the scenes, so each try at least halves their
    // number.
    every = std::max(2 * every, every * (encoder.bytes().size() / most_bytes));
    encoder = encode(log, episode, every);
  }
  return Json{
      {"rate_hz", static_cast<double>(log.scenes_num) / static_cast<double>(log.scenes_den)},
      {"every", every},
      {"scenes", encoder.scenes()},
      {"changes", base64(encoder.bytes())}};
}

}  // namespace eagerx::gen
