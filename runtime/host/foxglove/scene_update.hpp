// Pictures of `render:` as messages of Foxglove's 3D panel: `foxglove.SceneUpdate` in JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace eagerx::foxglove {

/// A scene of [rows][kSceneColumns] as one entity, `scene`, in the frame `world`, whose z points
/// up. A planar drawing is upright: its x is x, its y is z, and later shapes are closer to a viewer
/// who looks along y. Shapes on the screen are placed in the view of the drawing; with a camera
/// there is no such view, and they are left out. So is the background.
std::string scene_update(const float* scene, std::size_t rows, std::int64_t time_ns);

/// JSON Schema of all that a SceneUpdate can have.
std::string scene_update_schema();

}  // namespace eagerx::foxglove
