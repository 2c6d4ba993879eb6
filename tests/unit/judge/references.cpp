// References: made, refused, read back, and always checked.
#include "judge/compare/references.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include "base/file.hpp"
#include "base/sha256.hpp"
#include "catch.hpp"
#include "image_io/image_io.hpp"
#include "judge/compare/make_reference.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/picture_cache.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

namespace fs = std::filesystem;
using atelier::test::error_of;
using atelier::test::mentions;

Image drawn(void (*change)(Drawing&)) {
  Drawing drawing;
  change(drawing);
  return draw(drawing);
}

JudgedCase claiming(std::vector<std::string> mistakes) {
  JudgedCase c = picture_case();
  c.rejects = std::move(mistakes);
  return c;
}

ReferenceMaterial good_material() {
  ReferenceMaterial material;
  material.solution = answer_of(draw({}));
  material.skeleton = answer_of(drawn([](Drawing& d) { d.no_shadow = d.no_highlight = d.no_ambient = true; }));
  material.mistakes["no-shadow"] = answer_of(drawn([](Drawing& d) { d.no_shadow = true; }));
  material.mistakes["no-highlight"] = answer_of(drawn([](Drawing& d) { d.no_highlight = true; }));
  material.mistakes["invisible-here"] = answer_of(draw({}));
  material.mistakes["crashes"].ended = Answer::Ended::crashed;
  material.environment = {{"driver", "llvmpipe"}, {"cpu", "any"}};
  return material;
}

StepReferences read_from(const fs::path& folder, const fs::path& cache = {}) {
  return StepReferences("02-blinn-phong", {}, folder, cache);
}

void overwrite(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST_CASE("a new reference is read back, with its atlas") {
  const TemporaryFolder folder;
  const JudgedCase c = claiming({"no-shadow", "no-highlight", "crashes"});
  const MadeReference made = make_reference(folder.path(), c, good_material());
  CHECK(made.margin >= min_margin);
  CHECK((made.nearest == "no-highlight" || made.nearest == "no-shadow"));
  CHECK(made.margins.at("invisible-here") < 1);
  CHECK(made.margins.at("crashes") == max_margin);
  CHECK(made.skeleton_fraction > 0.5);
  CHECK(made.skeleton_fraction < 1);  // the background is right
  for (const fs::path& file : made.written) CHECK(fs::is_regular_file(file));
  CHECK(read_sidecar(folder.path() / "sphere.json").atlas == std::vector<std::string>{"no-highlight", "no-shadow"});

  const StepReferences references = read_from(folder.path());
  CHECK(references.of(c).skeleton_fraction == made.skeleton_fraction);
  CHECK(references.atlas(c).pictures.size() == 2);
  CHECK(judge_case(c, answer_of(draw({})), references).status == Status::passed);
  const CaseResult wrong = judge_case(c, good_material().mistakes.at("no-shadow"), references);
  CHECK(wrong.status == Status::failed);
  CHECK(wrong.could_be == std::vector<std::string>{"no-shadow"});
}

TEST_CASE("invalid references are refused, and nothing is written") {
  using Change = void (*)(JudgedCase&, ReferenceMaterial&);
  struct Row {
    const char* name;
    Change change;
    std::vector<std::string_view> words;
  };
  const std::vector<Row> rows{
      {"no answer", [](JudgedCase&, ReferenceMaterial& m) { m.solution = {}; }, {"did not answer"}},
      {"another size", [](JudgedCase&, ReferenceMaterial& m) { m.solution.pixels = Image(8, 4); }, {"8x4", "192x192"}},
      {"NaN",
       [](JudgedCase&, ReferenceMaterial& m) { m.solution.pixels->at(5, 6).b = std::nanf(""); },
       {"NaN", "(5, 6)"}},
      {"a single colour",
       [](JudgedCase&, ReferenceMaterial& m) {
         m.solution.pixels = Image(192, 192, {1, 0, 0, 1});
       },
       {"single colour"}},
      {"a claimed mistake that passes",
       [](JudgedCase& c, ReferenceMaterial&) { c.rejects = {"invisible-here"}; },
       {"'invisible-here'", "0.00", "at least 2"}},
      {"a claimed mistake that lies too near",
       [](JudgedCase& c, ReferenceMaterial& m) {
         m.mistakes["exponent"] = answer_of(drawn([](Drawing& d) { d.exponent = 36; }));
         c.rejects = {"exponent"};
         c.delta = 4;  // at 7.3/255 it fails, but not with twice the tolerance
       },
       {"'exponent'", "1.", "at least 2"}},
      {"a claimed mistake that nobody drew",
       [](JudgedCase& c, ReferenceMaterial&) { c.rejects = {"unheard-of"}; },
       {"'unheard-of'", "not drawn"}},
      {"a skeleton that passes",
       [](JudgedCase&, ReferenceMaterial& m) { m.skeleton = m.solution; },
       {"skeleton passes"}},
      {"a tie",
       [](JudgedCase& c, ReferenceMaterial& m) {
         c.profile = Profile::exact;
         c.unit = Unit::encoded;
         m.solution.pixels = dithered_ramp(192, false);
         m.solution.pixels->at(9, 9).r = 100.5f / 255;
       },
       {"(9, 9)", "100.5"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const TemporaryFolder folder;
    JudgedCase c = claiming({"no-shadow"});
    ReferenceMaterial material = good_material();
    row.change(c, material);
    const std::string message = error_of([&] { make_reference(folder.path(), c, material); });
    INFO(message);
    CHECK(mentions(message, {"'sphere'"}));
    for (std::string_view word : row.words) CHECK(mentions(message, {word}));
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("margins: the distance of a picture in tolerances") {
  const JudgedCase c = picture_case();
  const Image right(64, 64, {0.2f, 0.2f, 0.2f, 1});
  const auto off_by = [&](float levels) {  // a square of 10x10, brighter by so many 1/255
    Image picture = compared_form(right, c);
    for (int y = 20; y < 30; ++y)
      for (int x = 20; x < 30; ++x) picture.at(x, y).r += levels / 255;
    return margin(picture, compared_form(right, c), c);
  };
  CHECK(off_by(0) == 0);
  CHECK(off_by(1.5f) == Approx(0.5).epsilon(0.03));  // 1 % from the bisection, and the rounding of a level
  CHECK(off_by(6) == Approx(2).epsilon(0.03));
  CHECK(off_by(30) == Approx(10).epsilon(0.03));
}

TEST_CASE("a reference that is missing or broken is an error, whatever the answer") {
  const JudgedCase c = claiming({"no-shadow"});
  using Change = void (*)(const fs::path&);
  struct Row {
    const char* name;
    Change change;
    std::vector<std::string_view> words;
  };
  const std::vector<Row> rows{
      {"no picture", [](const fs::path& f) { fs::remove(f / "sphere.exr"); }, {"sphere.exr", "missing", "reference"}},
      {"no sidecar", [](const fs::path& f) { fs::remove(f / "sphere.json"); }, {"sphere.json", "missing"}},
      {"a folder",
       [](const fs::path& f) {
         fs::remove(f / "sphere.exr");
         fs::create_directory(f / "sphere.exr");
       },
       {"sphere.exr", "missing"}},
      {"another picture",
       [](const fs::path& f) {
         write_image(f / "sphere.exr", drawn([](Drawing& d) { d.no_ambient = true; }), {Encoding::linear, Depth::half});
       },
       {"sphere.exr", "SHA-256"}},
      {"a broken sidecar", [](const fs::path& f) { overwrite(f / "sphere.json", "{"); }, {"sphere.json"}},
      {"a sidecar of something else",
       [](const fs::path& f) { overwrite(f / "sphere.json", R"({"schema": 1})"); },
       {"sphere.json", "'case'"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const TemporaryFolder folder;
    make_reference(folder.path(), c, good_material());
    row.change(folder.path());
    const std::string message = error_of([&] { judge_case(c, Answer{}, read_from(folder.path())); });
    INFO(message);
    for (std::string_view word : row.words) CHECK(mentions(message, {word}));
  }
}

TEST_CASE("a reference made for another tolerance or size is stale") {
  const TemporaryFolder folder;
  make_reference(folder.path(), claiming({"no-shadow"}), good_material());
  struct Row {
    const char* name;
    void (*change)(JudgedCase&);
  };
  for (const Row& row :
       {Row{"mask []",
            [](JudgedCase& c) {
              c.mask = {{0, 0, 8, 8}};
            }},
        Row{"regions []",
            [](JudgedCase& c) {
              c.regions = {{"the corner", {0, 0, 8, 8}, 2}};
            }},
        Row{"delta", [](JudgedCase& c) { c.delta = 2; }}, Row{"budget", [](JudgedCase& c) { c.budget = 5; }},
        Row{"profile", [](JudgedCase& c) { c.profile = Profile::robust; }},
        Row{"exposure", [](JudgedCase& c) { c.exposure = 2; }}, Row{"192x192", [](JudgedCase& c) {
                                                                      c.ask.size = {96, 96};
                                                                    }}}) {
    JudgedCase c = claiming({"no-shadow"});
    row.change(c);
    const std::string message = error_of([&] { read_from(folder.path()).require({c}); });
    INFO(message);
    CHECK(mentions(message, {row.name}));
  }
}

TEST_CASE("mask and regions are in the sidecar, and affect the skeleton's fraction") {
  const TemporaryFolder folder;
  JudgedCase c = claiming({"no-shadow"});
  c.mask = {{0, 0, 8, 192}, {184, 0, 8, 192}};
  c.regions = {{"the middle", {64, 64, 64, 64}, 10}};
  make_reference(folder.path(), c, good_material());
  const Sidecar sidecar = read_sidecar(folder.path() / "sphere.json");
  CHECK(sidecar.mask == c.mask);
  CHECK(sidecar.regions == c.regions);
  CHECK(sidecar.skeleton_fraction != check_reference(claiming({"no-shadow"}), good_material()).skeleton_fraction);
  read_from(folder.path()).require({c});
}

TEST_CASE("probes: numbers by hand or by the solution, and the answers of mistakes") {
  const TemporaryFolder folder;
  JudgedCase c;
  c.ask.name = "square";
  c.ask.probe = "square";
  c.profile = Profile::values;
  c.points = 2;
  c.tolerance.absolute = 0.1;
  c.ask.inputs.resize(2);
  c.rejects = {"doubles"};
  ReferenceMaterial material;
  material.solution = answer_of(std::vector<Numbers>{{4}, {infinity}});
  material.skeleton = answer_of(std::vector<Numbers>{{0}, {infinity}});
  material.mistakes["doubles"] = answer_of(std::vector<Numbers>{{4.5}, {infinity}});

  SECTION("made by the solution") {
    const MadeReference made = make_reference(folder.path(), c, material);
    CHECK(made.margin == Approx(5));
    CHECK(made.skeleton_fraction == Approx(0.5));
    const StepReferences references = read_from(folder.path());
    CHECK(references.of(c).values == *material.solution.values);
    CHECK(judge_case(c, material.mistakes["doubles"], references).could_be == std::vector<std::string>{"doubles"});
    fs::remove(folder.path() / "square.values.json");
    CHECK(mentions(error_of([&] { read_from(folder.path()).of(c); }), {"square.values.json", "missing"}));
  }
  SECTION("written by hand: the solution must agree") {
    c.expected = {{4}, {infinity}};
    make_reference(folder.path(), c, material);
    CHECK(read_from(folder.path()).of(c).skeleton_fraction == Approx(0.5));
    fs::remove(folder.path() / "square.values.json");
    CHECK(read_from(folder.path()).of(c).values == c.expected);  // needs no file
    c.expected = {{5}, {infinity}};
    CHECK(mentions(error_of([&] { make_reference(folder.path(), c, material); }), {"4", "expects 5"}));
  }
  SECTION("a mistake too near") {
    material.mistakes["doubles"].values = {{4.15}, {infinity}};
    CHECK(mentions(error_of([&] { make_reference(folder.path(), c, material); }), {"'doubles'", "1.50", "at least 2"}));
  }
}

TEST_CASE("data references keep every bit") {
  const TemporaryFolder folder;
  JudgedCase c = picture_case(Profile::strict, Unit::number, 1e-4, 4);
  ReferenceMaterial material;
  material.solution = answer_of(draw_depth({}));
  make_reference(folder.path(), c, material);
  const Image read = read_from(folder.path()).of(c).pictures.at(0);
  CHECK(read == *material.solution.pixels);
}

TEST_CASE("the cache of decoded pictures: entries are found, damaged ones ignored") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "picture.exr", cache = folder.path() / "cache";
  overwrite(file, "stands for a picture");
  int decoded = 0;
  const auto get = [&](const std::string& fingerprint = "a") {
    return cached_picture(cache, file, fingerprint, [&] {
      ++decoded;
      return Image(3, 2, {float(decoded), 0, 0, 1});
    });
  };
  CHECK(get().at(0, 0).r == 1);
  CHECK(get().at(2, 1).r == 1);
  CHECK(decoded == 1);

  SECTION("another fingerprint") {
    CHECK(get("b").at(0, 0).r == 2);
  }
  SECTION("a changed file") {
    overwrite(file, "stands for another picture");
    CHECK(get().at(0, 0).r == 2);
  }
  SECTION("a deleted folder") {
    fs::remove_all(cache);
    CHECK(get().at(0, 0).r == 2);
  }
  SECTION("one flipped bit, a short file, rubbish: in every entry") {
    for (int kind = 0; kind < 3; ++kind) {
      const int before = decoded;
      for (const auto& entry : fs::directory_iterator(cache)) {
        std::string bytes = read_file(entry.path());
        if (kind == 0) bytes[bytes.size() - 3] = char(bytes[bytes.size() - 3] ^ 4);
        if (kind == 1) bytes.resize(bytes.size() / 2);
        if (kind == 2) bytes = "rubbish";
        overwrite(entry.path(), bytes);
      }
      CHECK(get().at(0, 0).r == float(before + 1));
    }
  }
  SECTION("no folder, or one that cannot be made") {
    const auto decode = [] { return Image(1, 1, {7, 0, 0, 1}); };
    CHECK(cached_picture({}, file, "a", decode).at(0, 0).r == 7);
    CHECK(cached_picture(file / "below-a-file", file, "a", decode).at(0, 0).r == 7);
  }
  CHECK(mentions(error_of([&] { cached_picture(cache, folder.path() / "none.exr", "a", [] { return Image(); }); }),
                 {"none.exr"}));
}

TEST_CASE("references come from the cache the second time") {
  const TemporaryFolder folder;
  const JudgedCase c = claiming({"no-shadow"});
  make_reference(folder.path(), c, good_material());
  const fs::path cache = folder.path() / "cache";
  const Image first = read_from(folder.path(), cache).of(c).pictures.at(0);
  CHECK_FALSE(fs::is_empty(cache));
  CHECK(read_from(folder.path(), cache).of(c).pictures.at(0) == first);
  // A picture that changed after it was kept is found out, although an entry of its former self is there.
  write_image(folder.path() / "sphere.exr", drawn([](Drawing& d) { d.no_ambient = true; }));
  CHECK(mentions(error_of([&] { read_from(folder.path(), cache).of(c); }), {"SHA-256"}));
}

TEST_CASE("SHA-256: the standard's examples") {
  // FIPS 180-4's own examples, and lengths around the border of a block, whose digests are sha256sum's.
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(55, 'a')) == "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
  CHECK(sha256(std::string(64, 'a')) == "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
  CHECK(sha256(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace atelier::judge::test
