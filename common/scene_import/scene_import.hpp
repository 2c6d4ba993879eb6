// Scenes from files: glTF 2.0 (.gltf, .glb) and Wavefront OBJ with its MTL materials.
//
// Imported:
//   glTF  the default scene's nodes (translation, rotation, scale, or a matrix), triangles, strips and fans with
//         normals, tangents and texture coordinates 0, metallic-roughness and specular-glossiness materials, pictures
//         (external, embedded, as data URIs), samplers, cameras, KHR_lights_punctual, KHR_texture_transform of the base
//         colour, skins in the rest pose (gltf_skin.hpp).
//   OBJ   faces of any number of corners, concave ones too, materials, pictures, smoothing groups.
// A mesh without valid tangents whose material has a normal map gets the standard's (scene/standard_tangents.hpp).
// Not imported: animations, morph targets, vertex colours, opacity, points and lines, texture coordinates 1 and up,
// curves and free-form surfaces. blinn_phong_of.hpp says how materials become Blinn-Phong. Lengths and the up axis are
// those of the file (glTF: metres, y up).
//
// We wrote our own readers because files are untrusted: each number is checked before use, errors name the field or the
// line, and no file outside the model's own folder is opened.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Limits of imports; exceeding one throws Error.
inline constexpr std::size_t max_import_vertices = 50'000'000;   ///< in all meshes together
inline constexpr std::size_t max_import_triangles = 50'000'000;  ///< in all meshes together
inline constexpr std::size_t max_import_nodes = 1'000'000;
inline constexpr std::size_t max_import_texels = 256'000'000;  ///< in all pictures together: 4 GB

/// Reads a .gltf, .glb or .obj file (by its extension) into a scene that passes validate(). A file without a camera
/// gets one that sees the whole model in a picture at least as wide as high, a file without a light a key light.
///
/// Throws Error, in one sentence that names the file and the field or line, if the file is missing, invalid, of another
/// format or version, exceeds the limits, needs an unsupported extension, references data outside its folder, has a
/// coordinate that is not finite, or has no triangles. Common defects are fixed instead: missing or invalid normals,
/// missing pictures and material files, statements of materials that cannot be read, attributes that are missing or
/// have the wrong length. A sentence about each, and about each kind of thing that is left out, is added to `notes`, if
/// given (at most 100).
Scene import_scene(const std::filesystem::path& file, std::vector<std::string>* notes = nullptr);

}  // namespace atelier
