// Tangents of a torus: the lesson's, and those of the standard, beside assimp's. assimp wants triangles that share no
// corners, and finds what belongs together by position; ours have an index.
#ifdef HAVE_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <assimp/Importer.hpp>
#endif
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "05-normal-mapping/normal_mapping.hpp"
#include "base/error.hpp"
#include "peers/peers.hpp"
#include "scene/shapes.hpp"
#include "scene/standard_tangents.hpp"

namespace atelier::peers {

namespace {

#ifdef HAVE_ASSIMP

/// The mesh as an OBJ file.
std::string as_obj(const Mesh& mesh) {
  std::string text;
  for (const Vertex& v : mesh.vertices)
    text += fmt::format("v {} {} {}\nvt {} {}\nvn {} {} {}\n", v.position.x, v.position.y, v.position.z, v.texcoord.x,
                        v.texcoord.y, v.normal.x, v.normal.y, v.normal.z);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    text += "f";
    for (std::size_t k = 0; k < 3; ++k) text += fmt::format(" {0}/{0}/{0}", mesh.indices[i + k] + 1);
    text += "\n";
  }
  return text;
}

/// Throws Error unless every corner of the mesh has a tangent of unit length.
void check_tangents(const aiMesh& mesh) {
  if (!mesh.HasTangentsAndBitangents()) throw Error("assimp computed no tangents");
  for (unsigned i = 0; i < mesh.mNumVertices; ++i)
    if (!(std::abs(mesh.mTangents[i].Length() - 1) < 1e-3f))
      throw Error(fmt::format("assimp: the tangent of corner {} has the length {}", i, mesh.mTangents[i].Length()));
}

Peer assimp(const Mesh& mesh) {
  const auto importer = std::make_shared<Assimp::Importer>();
  const std::string text = as_obj(mesh);
  const aiScene* scene = importer->ReadFileFromMemory(text.data(), text.size(), 0, "obj");
  if (!scene) throw Error(fmt::format("assimp: {}", importer->GetErrorString()));
  if (scene->mNumMeshes != 1 || scene->mMeshes[0]->mNumFaces != mesh.indices.size() / 3)
    throw Error(fmt::format("assimp read {} meshes, {} faces in the first, from one of {} triangles", scene->mNumMeshes,
                            scene->mNumMeshes > 0 ? scene->mMeshes[0]->mNumFaces : 0, mesh.indices.size() / 3));
  aiMesh* read = scene->mMeshes[0];
  return {.name = fmt::format("assimp {}.{}, CalcTangentSpace", aiGetVersionMajor(), aiGetVersionMinor()),
          .run = [importer] { importer->ApplyPostProcessing(aiProcess_CalcTangentSpace); },
          .prepare =
              [read] {  // it computes none where there are some
                delete[] std::exchange(read->mTangents, nullptr);
                delete[] std::exchange(read->mBitangents, nullptr);
              },
          .check = [read] { check_tangents(*read); }};
}

#else

Peer assimp(const Mesh&) {
  return {.name = "assimp, CalcTangentSpace", .missing = "libassimp-dev"};
}

#endif

std::vector<Row> rows_of_tangents() {
  std::vector<Row> rows;
  struct Size {
    const char* name;
    int segments, sides;
  };
  for (const Size& size : {Size{"10k", 100, 50}, {"100k", 316, 158}, {"1M", 1000, 500}}) {
    const auto mesh = std::make_shared<Mesh>(make_torus({.segments = size.segments, .sides = size.sides}));
    const Peer peer = assimp(*mesh);
    rows.push_back({.work = fmt::format("vertex_tangents, {} triangles", size.name),
                    .ours = [mesh] { normal_mapping::vertex_tangents(*mesh); },
                    .peer = peer,
                    .aim = 5});
    rows.push_back({.work = fmt::format("standard_tangents, {} triangles", size.name),
                    .ours = [mesh] { standard_tangents(*mesh); },
                    .peer = peer});
  }
  return rows;
}

}  // namespace

}  // namespace atelier::peers

int main(int argc, char** argv) {
  return atelier::peers::compare(atelier::peers::rows_of_tangents, argc, argv);
}
