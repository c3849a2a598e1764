#include <algorithm>
#include <eagerx/scene.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/trace/scene_line.hpp>

namespace eagerx::trace_log {
namespace {

constexpr std::string_view kRate = "# scenes ", kScene = "# scene ";

/// Up to `separator`, which is cut off with it.
std::string_view take(std::string_view& rest, char separator) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

bool read_rate(std::string_view rate, Log& log) {
  const std::string_view num = take(rate, '/');
  return host::read_number(num, log.scenes_num) && host::read_number(rate, log.scenes_den) &&
         log.scenes_num > 0 && log.scenes_den > 0;
}

bool read_change(std::string_view text, std::uint32_t rows, Log& log) {
  SceneChange change;
  const std::string_view index = take(text, '=');
  if (!host::read_number(index, change.index) || !host::read_number(text, change.value))
    return false;
  log.scene_changes.push_back(change);
  return change.index < rows * kSceneColumns;
}

/// Ticks of an episode rise, and episodes follow each other.
bool follows(const RecordedScene& scene, const Log& log) {
  if (log.scenes.empty()) return true;
  const RecordedScene& last = log.scenes.back();
  return scene.episode > last.episode || (scene.episode == last.episode && scene.tick > last.tick);
}

}  // namespace

bool read_scene_line(std::string_view line, Log& log, std::string_view& place, std::string& what) {
  const auto fail = [&](std::string_view at, const char* why) {
    place = at;
    what = why;
    return false;
  };
  if (line.starts_with(kRate)) {
    std::string_view rate = line.substr(kRate.size());
    return read_rate(rate, log) || fail(rate, "the line is `# scenes RATE`, such as 30/1");
  }
  if (!line.starts_with(kScene)) return true;  // what a later version may add
  std::string_view rest = line.substr(kScene.size());
  if (log.scenes_num == 0) return fail(line, "no line `# scenes RATE` is before this scene");
  RecordedScene scene;
  const std::string_view episode = take(rest, ' '), tick = take(rest, ' '), rows = take(rest, ' ');
  if (!host::read_number(episode, scene.episode))
    return fail(episode, "expected the number of an episode");
  if (!host::read_number(tick, scene.tick)) return fail(tick, "expected the number of a scene");
  if (!host::read_number(rows, scene.rows) || scene.rows > kMostSceneRows)
    return fail(rows, "expected how many rows the scene has, at most 4095");
  if (!follows(scene, log)) return fail(episode, "this scene is not later than the one before");
  scene.first = log.scene_changes.size();
  while (!rest.empty()) {
    const std::string_view change = take(rest, ',');
    if (!read_change(change, scene.rows, log))
      return fail(change, "a change is `index=value`, with an index in the rows of the scene");
  }
  scene.changes = log.scene_changes.size() - scene.first;
  log.scenes.push_back(scene);
  return true;
}

}  // namespace eagerx::trace_log
