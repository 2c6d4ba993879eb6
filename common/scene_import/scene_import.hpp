// Scenes from files: glTF 2.0 (.gltf, .glb) and Wavefront OBJ with its MTL materials.
//
// What comes in:
//   glTF  the default scene's nodes (translation, rotation, scale, or a matrix), triangles, strips and fans with
//   normals,
//         tangents and texture coordinates 0, metallic-roughness and specular-glossiness materials, pictures (outside,
//         embedded, as data URIs), samplers, cameras, KHR_lights_punctual, KHR_texture_transform of the base colour.
//   OBJ   faces of any number of corners, concave ones too, materials, pictures, smoothing groups.
// What does not: skins (models stand in their rest pose), morph targets, animations, vertex colours, opacity, points
// and lines, texture coordinates 1 and up, curves and free-form surfaces. How their materials become Blinn-Phong stands
// in blinn_phong_of.hpp. Lengths and the up axis are as the file has them (glTF: metres, y up).
//
// The readers are ours and not a library's, because they meet files from anywhere: each number is checked before it is
// used, a complaint names the field or the line, and no file outside the model's own folder is opened.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Limits of what is imported; what goes beyond is refused with an Error.
inline constexpr std::size_t max_import_vertices = 50'000'000;   ///< in all meshes together
inline constexpr std::size_t max_import_triangles = 50'000'000;  ///< in all meshes together
inline constexpr std::size_t max_import_nodes = 1'000'000;
inline constexpr std::size_t max_import_texels = 256'000'000;  ///< in all pictures together: 4 GB

/// Reads a .gltf, .glb or .obj file (told apart by the ending) into a scene that passes validate(). A file without a
/// camera gets one that sees the whole model in a picture at least as wide as high, a file without a light a key light.
///
/// Throws Error, in one sentence that names the file and the field or line, where the file is missing, broken, of
/// another kind or version, beyond the limits, needs an extension that is not supported, names data outside its folder,
/// has a coordinate that is not finite, or has no triangles. What viewers commonly forgive is mended instead: normals
/// that are missing or no directions, pictures and material files that are not there, attributes of the wrong length. A
/// sentence about each is added to `notes` where that is given (at most 100).
Scene import_scene(const std::filesystem::path& file, std::vector<std::string>* notes = nullptr);

}  // namespace atelier
