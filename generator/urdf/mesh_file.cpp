// Files of meshes, by the library assimp.
#include "generator/urdf/meshes.hpp"

#ifdef EAGERX_ASSIMP
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

namespace eagerx::urdf {

#ifdef EAGERX_ASSIMP
bool reads_meshes() {
  return true;
}

LoadedMesh load_mesh(const std::string& path) {
  aiPropertyStore* const settings = aiCreatePropertyStore();
  aiSetImportPropertyInteger(settings, AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  const aiScene* const scene = aiImportFileExWithProperties(
      path.c_str(), aiProcess_Triangulate | aiProcess_PreTransformVertices, nullptr, settings);
  aiReleasePropertyStore(settings);
  if (scene == nullptr) return {{}, aiGetErrorString()};
  LoadedMesh result;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // a line or a point
      for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D& v = mesh.mVertices[face.mIndices[i]];
        result.triangles.push_back({{v.x, v.y, v.z}});
      }
    }
  }
  aiReleaseImport(scene);
  if (result.triangles.empty()) result.problem = "it has no triangle";
  return result;
}
#else
bool reads_meshes() {
  return false;
}

LoadedMesh load_mesh(const std::string& /*path*/) {
  return {{}, "built without assimp"};
}
#endif

}  // namespace eagerx::urdf
