// The scenes of `render:` in a trace: what `--trace-scenes` adds for whoever plays it back.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <runtime/host/trace/scene_line.hpp>
#include <targets/common/image_message.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Whether the graph shows a scene, not an image that is pixels already.
template <class Graph>
inline constexpr bool shows_scene = requires {
  requires !target::ImageShape<typename Graph::Rendered>::is_image;
};

/// Writes lines `# scene EPISODE TICK ROWS CHANGES`. They are no messages: the hash does not see
/// them. Of most scenes few numbers change, so only those are written. Nothing but the constructor
/// allocates.
template <class Message>
class SceneRecord {
 public:
  SceneRecord() { before_.resize(kSceneRows<Message> * kSceneColumns); }

  template <class Writer, class Rate>
  void write(Writer& out, std::uint32_t episode, Rate /*rate*/, Seq tick, const Message& scene) {
    if (!has_begun_) {
      out.text("# scenes ");
      out.number(Rate::num);
      out.text("/");
      out.number(Rate::den);
      out.text("\n");
      has_begun_ = true;
    }
    std::size_t rows = 0;
    while (rows < kMostRows && scene[rows * kSceneColumns] != 0.0F) ++rows;
    out.text("# scene ");
    out.number(episode);
    out.text(" ");
    out.number(tick);
    out.text(" ");
    out.number(rows);
    changes(out, scene, rows * kSceneColumns);
    out.text("\n");
  }

 private:
  static constexpr std::size_t kMostRows = kSceneRows<Message> < trace_log::kMostSceneRows
                                               ? kSceneRows<Message>
                                               : trace_log::kMostSceneRows;

  template <class Writer>
  void changes(Writer& out, const Message& scene, std::size_t size) {
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

  std::vector<float> before_;  // [rows * 16], as the lines so far have it
  bool has_begun_ = false;
};

}  // namespace eagerx::linux_sim
