// Geoms with contacts and geoms with mass.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "generator/urdf/inertia.hpp"
#include "generator/urdf/mjcf_frames.hpp"

namespace eagerx::urdf {

/// `mesh` in `asset`.
struct MeshAsset {
  Mesh mesh;
  Frame origin;  // of the file's frame in that of the geom
};

struct Geom {
  std::optional<Collision> shape;    // in the frame of what the geom is in
  std::optional<Inertial> inertial;  // the same
  unsigned type = 1, affinity = 1;   // `contype`, `conaffinity`
};

class Geoms {
 public:
  Geoms(Document& document, const Compiler& compiler) : document_(document), compiler_(compiler) {}

  void read_meshes();
  /// Of a geom in `in`. Its mass is only looked for where `has_mass`.
  Geom read(const Element& element, const Frame& in, bool has_mass);

 private:
  void set_size(const Element& element, Collision& shape, Frame& frame, const std::string& type);
  void set_ellipsoid(const Vector3& half, Collision& shape, Frame& frame);
  bool set_mesh(const Element& element, Collision& shape, Frame& frame);
  std::optional<Inertial> mass_of(const Element& element, const Collision& shape,
                                  const std::string& type);
  /// Of density 1, in the mesh's frame.
  const Inertial& solid(const Mesh& mesh);

  Document& document_;
  const Compiler& compiler_;
  std::map<std::string, MeshAsset> meshes_;
  std::map<std::string, Inertial> solids_;
  Inertial ellipsoid_;  // the last one, of density 1, in the frame of the capsule around it
};

/// `contype` or `conaffinity`.
unsigned bits_of(const Element& element, const char* attribute);

/// Mass and inertia of shapes of density 1; a size as Collision has it.
Inertial solid_shape(models::ShapeKind kind, const Vector3& size);
Inertial solid_ellipsoid(const Vector3& half);

}  // namespace eagerx::urdf
