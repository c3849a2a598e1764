#include "generator/urdf/meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::urdf {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostSpheres = 16;  // of a mesh

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Name of a package and the path in it; the name is empty where there is none.
struct MeshName {
  std::string package, path;
};
MeshName parts_of(const std::string& name) {
  for (const std::string prefix : {"package://", "model://"}) {
    if (!name.starts_with(prefix)) continue;
    const std::size_t begin = prefix.size(), slash = name.find('/', begin);
    if (slash == std::string::npos) return {{}, name.substr(begin)};
    return {name.substr(begin, slash - begin), name.substr(slash + 1)};
  }
  return {{}, name.starts_with("file://") ? name.substr(7) : name};
}

/// Meshes of one description. A file that several links name is read once.
class Resolver {
 public:
  Resolver(const std::string& folder, const MeshOptions& options, gen::Diagnostics& diagnostics)
      : folder_(folder), options_(options), diagnostics_(diagnostics) {}

  void resolve(Link& link) {
    std::vector<Collision> result;
    for (Collision& collision : link.collisions) {
      if (!collision.mesh) {
        result.push_back(std::move(collision));
      } else {
        add_shapes(collision, result);
      }
    }
    link.collisions = std::move(result);
  }

  void look_for(const Mesh& visual) {
    if (find(visual.file).empty() && missing_visuals_++ == 0) missing_visual_ = visual;
  }

  /// The larger a visual mesh is, the more triangles draw it. The smallest are left out if there is
  /// no room for them.
  void draw(std::vector<Link>& links) {
    std::vector<Drawn> all;
    for (Link& link : links) {
      for (const Visual& visual : link.visuals) {
        const std::string& path = options_.facets > 0 ? find(visual.mesh.file) : kNoPath;
        if (path.empty() || !load(path).problem.empty()) continue;
        Triangles triangles = scaled(load(path).triangles, visual.mesh.scale);
        for (Vector3& p : triangles) p = visual.origin.position + rotate(visual.origin.rotation, p);
        const double surface = surface_of(triangles);
        all.push_back({&link, std::move(triangles), surface});
      }
    }
    std::ranges::stable_sort(all, std::greater<>(), &Drawn::surface);
    double surface = 0.0;
    for (const Drawn& one : all) surface += one.surface;
    std::size_t room = std::max(options_.facets, kFewest);
    for (const Drawn& one : all) {
      const double share = surface > 0.0 ? one.surface / surface : 0.0;
      const auto part = static_cast<std::size_t>(static_cast<double>(options_.facets) * share);
      const Triangles few = decimated(one.triangles, std::max(part, kFewest));
      if (few.empty() || few.size() / 3 > room) continue;
      room -= few.size() / 3;
      one.link->look.insert(one.link->look.end(), few.begin(), few.end());
    }
  }

  void report(const Description& description) {
    if (missing_visuals_ > 0)
      diagnostics_.note(
          missing_visual_.place,
          fmt::format("not found: {} of `visual`, such as `{}`",
                      gen::counted(missing_visuals_, "mesh", "meshes"), missing_visual_.file));
    if (count_ == 0) return;
    std::string shapes;
    for (const auto& [kind, count] : kinds_)
      shapes += (shapes.empty() ? "" : ", ") +
                gen::counted(count, kind, kind == "box" ? "boxes" : kind + "s");
    diagnostics_.note(
        description.place,
        fmt::format("{} of collisions became {}, which enclose them and reach at most "
                    "{:.1f} mm beyond their convex hull (`{}`)",
                    gen::counted(count_, "mesh", "meshes"), shapes, 1e3 * farthest_,
                    farthest_mesh_));
  }

 private:
  static constexpr std::size_t kFewest = 12;  // triangles of a mesh
  inline static const std::string kNoPath;
  struct Drawn {
    Link* link;
    Triangles triangles;
    double surface;  // [m²]
  };

  static Triangles scaled(Triangles triangles, const Vector3& scale) {
    for (Vector3& p : triangles) {
      for (std::size_t i = 0; i < 3; ++i) p[i] *= scale[i];
    }
    return triangles;
  }

  const std::string& find(const std::string& name) {
    const auto [at, is_new] = found_.try_emplace(name);
    if (is_new) at->second = find_mesh(name, folder_, options_.packages);
    return at->second;
  }

  void add_shapes(const Collision& collision, std::vector<Collision>& result) {
    const Mesh& mesh = *collision.mesh;
    const std::string& path = find(mesh.file);
    if (path.empty()) {
      diagnostics_
          .warning("E0858", mesh.place,
                   fmt::format("there is no file `{}`: the link does not touch with it", mesh.file))
          .help = "`--package FOLDER` says where packages are";
      return;
    }
    const LoadedMesh& loaded = load(path);
    if (!loaded.problem.empty()) return cannot_read(mesh, loaded.problem);
    const Triangles triangles = scaled(loaded.triangles, mesh.scale);
    const std::vector<Fitted> shapes = fitted(triangles);
    const double reach = reach_beyond(shapes, triangles);
    ++count_;
    if (reach >= farthest_) farthest_ = reach, farthest_mesh_ = mesh.file;
    for (const Fitted& shape : shapes) {
      Collision one = collision;
      one.mesh.reset();
      one.kind = shape.kind;
      one.size = shape.size;
      one.origin = collision.origin * shape.origin;
      ++kinds_[name_of(shape.kind)];
      result.push_back(std::move(one));
    }
  }

  void cannot_read(const Mesh& mesh, const std::string& problem) {
    if (!reads_meshes()) {
      if (!without_library_)
        diagnostics_
            .error("E0858", mesh.place,
                   "this eagerx-urdf was built without assimp, which reads meshes")
            .help =
            "install libassimp-dev and build it again, or leave out what touches: "
            "`--collision none`";
      without_library_ = true;
      return;
    }
    diagnostics_.warning(
        "E0858", mesh.place,
        fmt::format("cannot read `{}` ({}): the link does not touch with it", mesh.file, problem));
  }

  const LoadedMesh& load(const std::string& path) {
    const auto [at, is_new] = loaded_.try_emplace(path);
    if (is_new) at->second = load_mesh(path);
    return at->second;
  }

  std::vector<Fitted> fitted(const Triangles& triangles) const {
    if (options_.shapes == CollisionShapes::boxes) return {smallest_box(triangles)};
    if (options_.shapes == CollisionShapes::spheres)
      return enclosing_spheres(triangles, options_.distance, kMostSpheres);
    return {smallest_shape(triangles)};
  }

  static std::string name_of(models::ShapeKind kind) {
    using models::ShapeKind;
    if (kind == ShapeKind::sphere) return "sphere";
    if (kind == ShapeKind::capsule) return "capsule";
    return kind == ShapeKind::cylinder ? "cylinder" : "box";
  }

  const std::string& folder_;
  const MeshOptions& options_;
  gen::Diagnostics& diagnostics_;
  std::map<std::string, std::string> found_;
  std::map<std::string, LoadedMesh> loaded_;
  std::map<std::string, std::size_t> kinds_;
  std::size_t count_ = 0, missing_visuals_ = 0;
  double farthest_ = 0.0;
  std::string farthest_mesh_;
  Mesh missing_visual_;
  bool without_library_ = false;
};

}  // namespace

std::string find_mesh(const std::string& name, const std::string& folder,
                      const std::vector<std::string>& packages) {
  const auto [package, path] = parts_of(name);
  if (path.empty()) return {};
  if (fs::path(path).is_absolute()) return is_file(path) ? path : std::string();
  std::vector<fs::path> roots(packages.begin(), packages.end());
  std::error_code ignored;
  for (fs::path above = fs::absolute(folder, ignored).lexically_normal();;
       above = above.parent_path()) {
    roots.push_back(above);
    if (above == above.root_path() || above.empty()) break;
  }
  for (const fs::path& root : roots) {
    if (!package.empty() && is_file(root / package / path)) return (root / package / path).string();
    if (!package.empty() && root.filename() == package && is_file(root / path))
      return (root / path).string();
  }
  // A repository that is cloned by another name than the package's, and paths from a folder of
  // data.
  for (const fs::path& root : roots) {
    if (is_file(root / path)) return (root / path).string();
  }
  return {};
}

void resolve_meshes(Description& description, const std::string& folder, const MeshOptions& options,
                    gen::Diagnostics& diagnostics) {
  Resolver resolver(folder, options, diagnostics);
  for (Link& link : description.links) {
    if (options.shapes == CollisionShapes::none) {
      link.collisions.clear();
    } else {
      resolver.resolve(link);
    }
    for (const Visual& visual : link.visuals) resolver.look_for(visual.mesh);
  }
  resolver.draw(description.links);
  resolver.report(description);
}

}  // namespace eagerx::urdf
