#include "render/renderer.hpp"

#include <glm/gtc/constants.hpp>

#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// A renderer on a context of its own, with up to one feature.
struct Studio {
  Shaders shaders;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  TransformFunctions transforms = fake_transforms();
  Piece* piece = nullptr;  ///< where there is a feature
  std::unique_ptr<Renderer> renderer;

  explicit Studio(std::unique_ptr<Piece> feature = nullptr) {
    piece = feature.get();
    std::vector<std::unique_ptr<Feature>> features;
    if (feature) features.push_back(std::move(feature));
    renderer = std::make_unique<Renderer>(gl(), shaders.implementations(), transforms, std::move(features));
  }
  Gl& gl() { return context->gl(); }

  Image draw(const Scene& scene, View view, glm::ivec2 size = {32, 24}) {
    renderer->prepare(scene);
    const Target target(gl(), {.width = size.x, .height = size.y, .depth = DepthFormat::depth32f});
    gl().restart_counts();
    renderer->render(view, target);
    return target.read_colour(gl());
  }
  Image draw(const Scene& scene) { return draw(scene, {.camera = scene.camera}); }
};

int count(const Image& image, const Rgba& colour) {
  return int(std::count(image.pixels().begin(), image.pixels().end(), colour));
}

Image mirrored(const Image& image) {
  Image result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) result.at(x, y) = image.at(image.width() - 1 - x, y);
  return result;
}

}  // namespace

TEST_CASE("a triangle is drawn where the camera sees it", "[renderer]") {
  Studio studio;
  const Image image = studio.draw(triangle_scene());
  // From 3 m at 45 degrees the picture is 2.485 m high: the triangle covers 2 / (2.485 * 2.485 * 4/3) of it, 187 pixels
  // of 768; its edges decide over some 20.
  CHECK(std::abs(count(image, grey) - 187) < 20);
  CHECK(count(image, grey) + count(image, dark_blue) == 32 * 24);
  CHECK(image.at(0, 0) == dark_blue);
  CHECK(image.at(10, 18) == grey);      // lower left of the middle: inside
  CHECK(image.at(22, 6) == dark_blue);  // upper right: outside
}

TEST_CASE("intermediates show the surface", "[renderer]") {
  Studio studio;
  const Scene scene = triangle_scene();
  const auto at = [&](const char* output) {
    return studio.draw(scene, {.camera = scene.camera, .output = output}, {33, 33}).at(13, 19);
  };
  const float half_picture = 3 * std::tan(0.7853982f / 2);                                   // metres
  const glm::vec2 place = glm::vec2(13.5f / 33 * 2 - 1, 1 - 19.5f / 33 * 2) * half_picture;  // of that pixel's middle
  // All by a few operations on floats around 1: 1e-5 is a hundred roundings.
  CHECK(at("normal").b == Approx(1).margin(1e-5));
  CHECK(at("normal").r == Approx(0.5).margin(1e-5));
  CHECK(at("position").r == Approx(place.x).margin(1e-5));
  CHECK(at("position").g == Approx(place.y).margin(1e-5));
  CHECK(at("texcoord").r == Approx((place.x + 1) / 2).margin(1e-5));
  CHECK(at("texcoord").g == Approx((place.y + 1) / 2).margin(1e-5));
  // d = f (z - n) / (z (f - n)) at z = 3 between n = 0.5 and f = 10.
  CHECK(at("depth").r == Approx(10 * 2.5 / (3 * 9.5)).margin(1e-5));
  CHECK(studio.draw(scene, {.camera = scene.camera, .output = "position"}).at(0, 0) == Rgba{0, 0, 0, 1});
}

TEST_CASE("back faces are culled unless the material is two-sided", "[renderer]") {
  Studio studio;
  Scene scene = triangle_scene();
  scene.nodes[0].rotation_angle = glm::pi<float>();  // about +y: its back shows
  CHECK(count(studio.draw(scene), grey) == 0);
  scene.materials[0].two_sided = true;
  CHECK(count(studio.draw(scene), grey) > 150);
  const Image normals = studio.draw(scene, {.camera = scene.camera, .output = "normal"});
  CHECK(normals.at(22, 18).b == Approx(1).margin(1e-5));  // the normal turns to the viewer; rounding of floats
}

TEST_CASE("a negative scale keeps faces visible", "[renderer]") {
  Studio studio;
  const Image plain = studio.draw(triangle_scene());
  const Image upside_down = [&] {
    Image image = mirrored(plain);
    std::reverse(image.pixels().begin(), image.pixels().end());  // both ways, and back in x
    return image;
  }();
  const struct {
    const char* name;
    glm::vec3 scale;
    Image expected;
  } rows[] = {
      {"as it is", {1, 1, 1}, plain},
      {"mirrored in x", {-1, 1, 1}, mirrored(plain)},
      {"mirrored in y", {1, -1, 1}, upside_down},
      {"mirrored in x and y", {-1, -1, 1}, mirrored(upside_down)},
      {"mirrored in z, so that the front looks away", {1, 1, -1}, Image(32, 24, dark_blue)},
      {"pressed flat", {1, 1, 0}, plain},
      {"nothing left", {0, 0, 0}, Image(32, 24, dark_blue)},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    Scene scene = triangle_scene();
    scene.nodes[0].scale = row.scale;
    const Image image = studio.draw(scene);
    int different = 0;
    for (int i = 0; i < 32 * 24; ++i) different += image.pixels()[i] != row.expected.pixels()[i];
    CHECK(different <= 24);  // a pixel whose middle lies on the long edge goes to one side of it: one in each row
  }
}

TEST_CASE("a world far away looks like the same world at the origin", "[renderer]") {
  Studio studio;
  Scene near = triangle_scene();
  near.camera.eye = {0.25, 0.5, 3};
  near.camera.target = {0.125, 0, 0};
  near.nodes[0].translation = {0.03125, 0, 0};
  Scene far = near;
  // Sums of a power of two and these coordinates are exact in double precision, so that the pictures are equal bit by
  // bit. In floats a step at 2^20 is an eighth.
  const glm::dvec3 offset(1048576, -1048576, 1048576);
  far.camera.eye += offset;
  far.camera.target += offset;
  far.nodes[0].translation += offset;

  const auto relative = [&](const Scene& scene, bool on) {
    return studio.draw(scene, {.camera = scene.camera, .camera_relative = on}, {64, 48});
  };
  CHECK(relative(far, true) == relative(near, true));
  CHECK_FALSE(relative(far, false) == relative(near, false));
  CHECK(count(relative(near, true), grey) ==
        Approx(count(relative(near, false), grey)).margin(3));  // roundings on edges

  Scene child = far;  // hung below a group: only roots stand in world space
  child.nodes[0].mesh.reset();
  child.nodes.push_back({.parent = 0, .mesh = 0});
  CHECK(relative(child, true) == relative(near, true));

  Scene matrix = near, far_matrix = far;  // a matrix holds floats, in which an eighth is still exact at 2^20
  matrix.nodes[0].matrix = glm::translate(glm::mat4(1), glm::vec3(0.125f, 0, 0));
  far_matrix.nodes[0].matrix = glm::translate(glm::mat4(1), glm::vec3(offset) + glm::vec3(0.125f, 0, 0));
  CHECK(relative(far_matrix, true) == relative(matrix, true));
  CHECK(count(relative(matrix, true), grey) > 600);  // it is in sight: some 750 of 3072 pixels
}

TEST_CASE("the nearer surface is seen, whatever is drawn first", "[renderer]") {
  auto feature = std::make_unique<Piece>();
  feature->filled = {{Slot::shade, {"00-fake/place.glsl", "place"}}};
  Studio studio(std::move(feature));
  studio.shaders.write("00-fake/place.glsl", "vec3 place(Surface s) { return vec3(s.position_world.z); }\n");
  for (const bool reversed : {false, true}) {
    if (reversed && !studio.gl().ClipControl.call) {
      WARN("skipped: this driver has no glClipControl");
      continue;
    }
    for (const bool near_first : {false, true}) {
      INFO("reversed " << reversed << ", near first " << near_first);
      Scene scene = triangle_scene();
      scene.nodes = {Node{.translation = {0, 0, near_first ? 1 : -1}, .mesh = 0},
                     Node{.translation = {0, 0, near_first ? -1 : 1}, .mesh = 0}};
      const Image image = studio.draw(scene, {.camera = scene.camera, .reversed_depth = reversed});
      CHECK(image.at(14, 13) == Rgba{1, 1, 1, 1});
    }
  }
}

TEST_CASE("reversed depth is one at the near plane", "[renderer]") {
  Studio studio;
  if (!studio.gl().ClipControl.call) SKIP_TEST("this driver has no glClipControl");
  Scene scene = triangle_scene();
  const auto depth_at = [&](double z) {
    scene.nodes[0].translation.z = 3 - z;
    const Image image =
        studio.draw(scene, {.camera = scene.camera, .output = "depth", .reversed_depth = true}, {33, 33});
    return image.at(15, 17).r;
  };
  // d = n (f - z) / (z (f - n)); floats around 1 after a few operations.
  for (const double z : {0.5001, 1.0, 3.0, 9.5}) {
    INFO(z);
    CHECK(depth_at(z) == Approx(0.5 * (10 - z) / (z * 9.5)).margin(1e-5));
  }
  CHECK(studio.draw(scene, {.camera = scene.camera, .output = "depth"}).at(16, 13).r > 0.9);  // and the next is not

  // Without perspective it is even: d = (f - z) / (f - n).
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = 1;
  for (const double z : {0.5001, 3.0, 9.5}) {
    INFO(z << ", orthographic");
    CHECK(depth_at(z) == Approx((10 - z) / 9.5).margin(1e-5));
  }
}

TEST_CASE("equal keys share a program, and a program is linked once", "[renderer]") {
  auto feature = std::make_unique<Piece>();
  feature->wants = [](const Material& material) {
    if (material.specular == glm::vec3(0)) return Need{.wanted = true};
    return Need{.wanted = true, .structure = {{"SPECULAR", "1"}}};
  };
  Studio studio(std::move(feature));
  Scene scene = triangle_scene();
  scene.materials = {Material{.diffuse = glm::vec3(0.1f)}, Material{.diffuse = glm::vec3(0.9f)},
                     Material{.specular = glm::vec3(1)}};
  scene.nodes = {Node{.mesh = 0, .material = 0}, Node{.mesh = 0, .material = 1}, Node{.mesh = 0, .material = 0}};
  studio.draw(scene);
  CHECK(studio.gl().counts().programs_linked == 1);  // colours are numbers, no structure
  CHECK(studio.gl().counts().draws == 3);
  CHECK(studio.gl().counts().triangles == 3);
  CHECK(studio.gl().counts().clears == 1);
  studio.draw(scene);
  CHECK(studio.gl().counts().programs_linked == 0);
  scene.nodes.push_back({.mesh = 0, .material = 2});
  studio.draw(scene);
  CHECK(studio.gl().counts().programs_linked == 1);
  studio.draw(scene, {.camera = scene.camera, .output = "normal"});
  CHECK(studio.gl().counts().programs_linked == 2);  // another output: both variants anew
}

TEST_CASE("features are queried, prepared and bound only when needed", "[renderer]") {
  auto feature = std::make_unique<Piece>();
  feature->wants = [](const Material& material) { return Need{.wanted = material.name == "shiny"}; };
  Studio studio(std::move(feature));
  Scene scene = triangle_scene();
  scene.materials = {Material{.name = "dull"}, Material{.name = "shiny"}};
  studio.draw(scene);
  CHECK(studio.piece->prepared == 1);
  CHECK(studio.piece->views == 0);  // wanted by no material: never bound
  CHECK(studio.piece->materials == 0);
  scene.nodes[0].material = 1;
  studio.draw(scene);
  CHECK(studio.piece->prepared == 2);
  CHECK(studio.piece->views == 1);
  CHECK(studio.piece->materials == 1);
  // What is the same for a view, once for the draws that follow each other with one program; a material for each draw.
  for (const int material : {1, 0, 1}) scene.nodes.push_back({.mesh = 0, .material = material});
  studio.draw(scene);
  CHECK(studio.piece->views == 1 + 2);
  CHECK(studio.piece->materials == 1 + 3);
  studio.renderer->configure(Settings());
  CHECK(studio.piece->configured == 1);
}

TEST_CASE("a viewpoint has the origin of world space", "[renderer]") {
  auto feature = std::make_unique<Piece>();
  glm::vec3 eye(7);
  glm::dvec3 origin(7);
  feature->bind = [&](Binder&, const Viewpoint& viewpoint) { eye = viewpoint.eye, origin = viewpoint.origin; };
  Studio studio(std::move(feature));
  const Scene scene = triangle_scene();
  studio.draw(scene);
  CHECK(eye == glm::vec3(0, 0, 3));
  CHECK(origin == glm::dvec3(0));
  studio.draw(scene, {.camera = scene.camera, .camera_relative = true});
  CHECK(eye == glm::vec3(0));
  CHECK(origin == glm::dvec3(0, 0, 3));
}

TEST_CASE("every size can be drawn, and every projection", "[renderer]") {
  Studio studio;
  Scene scene = triangle_scene();
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 64}, {64, 1}, {33, 7}}) {
    INFO(size.x << "x" << size.y);
    const Image image = studio.draw(scene, {.camera = scene.camera}, size);
    CHECK(image.width() == size.x);
    CHECK(image.height() == size.y);
    for (const Rgba& pixel : image.pixels()) CHECK((pixel == grey || pixel == dark_blue));
  }
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = 2;
  // Two metres of height show the triangle's whole height, and half the width of 24/32.
  const Image image = studio.draw(scene);
  CHECK(std::abs(count(image, grey) - 24 * 24 / 2) <= 24);  // the pixels on the diagonal go either way
}

TEST_CASE("wireframes can be drawn, without side effects", "[renderer]") {
  Studio studio;
  const Scene scene = triangle_scene();
  const Image plain = studio.draw(scene);
  const Image edges = studio.draw(scene, {.camera = scene.camera, .wireframe = true});
  CHECK(count(edges, grey) > 20);
  CHECK(count(edges, grey) < count(plain, grey) / 2);
  GLint mode[2] = {};
  studio.gl().GetIntegerv(GL_POLYGON_MODE, mode);
  CHECK(mode[0] == GL_FILL);  // whoever draws next, a window say, must not find it changed
  CHECK(studio.draw(scene) == plain);
}

TEST_CASE("unwritten student's functions draw nothing", "[renderer]") {
  Studio studio;
  TransformFunctions unwritten = fake_transforms();
  unwritten.upload_mesh = [](Gl&, std::span<const Vertex>, std::span<const std::uint32_t>) { return MeshBuffers{}; };
  Renderer renderer(studio.gl(), studio.shaders.implementations(), unwritten, {});
  const Scene scene = triangle_scene();
  renderer.prepare(scene);
  const Target target(studio.gl(), {.width = 8, .height = 8});
  studio.gl().restart_counts();
  renderer.render({.camera = scene.camera}, target);
  CHECK(studio.gl().counts().draws == 0);
  CHECK(count(target.read_colour(studio.gl()), dark_blue) == 64);
}

TEST_CASE("a mesh without indices is drawn in order", "[renderer]") {
  Studio studio;
  const Image plain = studio.draw(triangle_scene());
  TransformFunctions in_order = fake_transforms();
  in_order.upload_mesh = [](Gl& gl, std::span<const Vertex> vertices, std::span<const std::uint32_t>) {
    return fake_upload_mesh(gl, vertices, {});
  };
  Renderer renderer(studio.gl(), studio.shaders.implementations(), in_order, {});
  const Scene scene = triangle_scene();
  renderer.prepare(scene);
  const Target target(studio.gl(), {.width = 32, .height = 24});
  renderer.render({.camera = scene.camera}, target);
  CHECK(target.read_colour(studio.gl()) == plain);
}

TEST_CASE("invalid drawings are reported", "[renderer]") {
  Studio studio;
  const Scene scene = triangle_scene();
  const Target target(studio.gl(), {.width = 8, .height = 8});
  CHECK(mentions(error_of([&] { studio.renderer->render({.camera = scene.camera}, target); }), {"no scene"}));
  CHECK(mentions(error_of([&] { studio.draw(scene, {.camera = scene.camera, .output = "shadow"}); }),
                 {"shadow", "normal"}));
  Scene broken = scene;
  broken.nodes[0].mesh = 5;
  CHECK(mentions(error_of([&] { studio.draw(broken); }), {"mesh 5"}));

  TransformFunctions forgetful = fake_transforms();
  forgetful.world_matrices = [](std::span<const Joint>) { return std::vector<glm::mat4>(7); };
  Renderer renderer(studio.gl(), studio.shaders.implementations(), forgetful, {});
  renderer.prepare(scene);
  CHECK(mentions(error_of([&] { renderer.render({.camera = scene.camera}, target); }), {"7 matrices", "1 node"}));
}
