// Converts collision meshes into shapes to simulate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/urdf/urdf.hpp"

namespace eagerx::urdf {

/// Corners of triangles, three after each other [m].
using Triangles = std::vector<Vector3>;

/// A file that the library assimp reads: STL, OBJ, DAE and others. Units of the file are applied;
/// the direction that it calls up is not, as in RViz.
struct LoadedMesh {
  Triangles triangles;
  std::string problem;  // why there are none
};
LoadedMesh load_mesh(const std::string& path);
/// Area of all triangles [m²].
double surface_of(const Triangles& triangles);
/// About the same surface with at most `most` triangles, or twelve of a box; counterclockwise from
/// outside.
Triangles decimated(const Triangles& triangles, std::size_t most);
/// Whether assimp was there when this was built.
bool reads_meshes();

/// A shape in the mesh's frame. Fields as in Collision.
struct Fitted {
  models::ShapeKind kind = models::ShapeKind::sphere;
  Vector3 size{};
  Frame origin;
};
/// Of sphere, capsule, cylinder and box the smallest that encloses all.
Fitted smallest_shape(const Triangles& triangles);
/// The smallest box.
Fitted smallest_box(const Triangles& triangles);
/// As many spheres, at most `most`, as enclose all and reach `distance` beyond it at most.
std::vector<Fitted> enclosing_spheres(const Triangles& triangles, double distance,
                                      std::size_t most);
/// Maximum distance by which shapes extend beyond the convex hull of the mesh, over 1,000
/// directions [m].
double reach_beyond(const std::vector<Fitted>& shapes, const Triangles& triangles);

enum class CollisionShapes : std::uint8_t { smallest, boxes, spheres, none };

struct MeshOptions {
  CollisionShapes shapes = CollisionShapes::smallest;
  double distance = 0.01;                  // of spheres [m]
  std::size_t facets = 400;                // triangles that draw visual meshes
  std::vector<std::string> packages = {};  // folders that `package://` is looked for in
};

/// Where a mesh is: by its path, next to the description in `folder` or in one of the folders above
/// it. Empty if there is no such file.
std::string find_mesh(const std::string& name, const std::string& folder,
                      const std::vector<std::string>& packages);

/// Replaces the meshes of collisions, and draws those of visuals. Problems: E0858.
void resolve_meshes(Description& description, const std::string& folder, const MeshOptions& options,
                    gen::Diagnostics& diagnostics);

}  // namespace eagerx::urdf
