// The scenes of `render:` in a trace: what `--trace-scenes` adds for its players.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <runtime/host/trace/scene_line.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Writes lines `# scene EPISODE TICK ROWS CHANGES`. They are no messages: the hash does not see
/// them. Of most scenes few numbers change, so only those are written. Nothing but the constructor
/// allocates.
class SceneRecord {
 public:
  /// A scene of [rows][kSceneColumns].
  explicit SceneRecord(std::size_t rows)
      : most_rows_(std::min(rows, std::size_t{trace_log::kMostSceneRows})),
        before_(rows * kSceneColumns) {}

  struct When {
    std::uint32_t episode;
    std::uint64_t rate_num, rate_den;  // pictures a second
    Seq tick;
  };
  template <class Writer>
  void write(Writer& out, const When& when, const float* scene) {
    if (!has_begun_) {
      out.text("# scenes ");
      out.number(when.rate_num);
      out.text("/");
      out.number(when.rate_den);
      out.text("\n");
      has_begun_ = true;
    }
    std::size_t rows = 0;
    while (rows < most_rows_ && scene[rows * kSceneColumns] != 0.0F) ++rows;
    out.text("# scene ");
    out.number(when.episode);
    out.text(" ");
    out.number(when.tick);
    out.text(" ");
    out.number(rows);
    changes(out, scene, rows * kSceneColumns);
    out.text("\n");
  }

 private:
  template <class Writer>
  void changes(Writer& out, const float* scene, std::size_t size) {
    bool first = true;
    for (std::size_t i = 0; i < size; ++i) {
      // Bits, since NaN differs from itself.
      if (std::bit_cast<std::uint32_t>(before_[i]) == std::bit_cast<std::uint32_t>(scene[i]))
        continue;
      before_[i] = scene[i];
      out.text(first ? " " : ",");
      out.number(i);
      out.text("=");
      out.number(scene[i]);
      first = false;
    }
  }

  std::size_t most_rows_;
  std::vector<float> before_;  // [rows * 16], as the lines so far have it
  bool has_begun_ = false;
};

}  // namespace eagerx::linux_sim
