#include "app/command_line.hpp"

#include "app/window/restart.hpp"
#include "base/file.hpp"
#include "catch.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;

std::optional<CommandLine> parse(std::vector<std::string> words) {
  words.insert(words.begin(), "00-fake");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  return parse_command_line(int(pointers.size()), pointers.data(), "00-fake");
}

}  // namespace

TEST_CASE("an invalid command line is refused with a suggestion", "[command_line]") {
  const struct {
    const char* name;
    std::vector<std::string> words;
    std::initializer_list<std::string_view> answer;
  } rows[] = {
      {"unknown option", {"--sise", "1x1"}, {"--sise", "00-fake --help"}},
      {"stray word", {"teapot"}, {"teapot"}},
      {"option without its value", {"--scene"}, {"--scene"}},
      {"one number as size", {"--size", "640"}, {"--size 640", "WIDTHxHEIGHT", "4096"}},
      {"size without height", {"--size", "640x"}, {"--size 640x", "WIDTHxHEIGHT"}},
      {"letters as size", {"--size", "axb"}, {"--size axb"}},
      {"more after the size", {"--size", "6x4x2"}, {"--size 6x4x2"}},
      {"no width", {"--size", "0x10"}, {"--size 0x10", "1 to 4096"}},
      {"negative height", {"--size", "10x-10"}, {"--size 10x-10"}},
      {"too wide", {"--size", "4097x1"}, {"--size 4097x1", "4096"}},
      {"two coordinates", {"--eye", "1,2"}, {"--eye 1,2", "X,Y,Z"}},
      {"four coordinates", {"--eye", "1,2,3,4"}, {"--eye 1,2,3,4"}},
      {"coordinate not a number", {"--target", "nan,0,0"}, {"--target nan,0,0", "finite"}},
      {"infinite coordinate", {"--target", "0,inf,0"}, {"--target", "finite"}},
      {"setting without a value", {"--set", "a.b"}, {"--set a.b", "NAME=VALUE"}},
      {"setting without a name", {"--set", "=3"}, {"--set =3", "NAME=VALUE"}},
      {"no frames", {"--frames", "0"}, {"--frames"}},
      {"frames in words", {"--frames", "ten"}, {"--frames", "ten"}},
      {"too many frames", {"--frames", "10001"}, {"--frames", "10000"}},
      {"truth in a window", {"--truth"}, {"--truth", "--out"}},
      {"truth of a driver", {"--truth", "--out", "a.png", "--context", "egl"}, {"--truth", "--context"}},
      {"cost of the truth", {"--truth", "--out", "a.png", "--stats"}, {"--truth", "--stats"}},
      {"truth that turns", {"--truth", "--record", "a.gif"}, {"--truth", "--record"}},
      {"samples of no truth", {"--samples", "4", "--out", "a.png"}, {"--samples", "--truth"}},
      {"no samples", {"--truth", "--samples", "0", "--out", "a.png"}, {"--samples", "64"}},
      {"too many samples", {"--truth", "--samples", "65", "--out", "a.png"}, {"--samples", "64"}},
      {"frames of no recording", {"--out", "a.png", "--frames", "3"}, {"--frames", "--record"}},
      {"nothing to vary", {"--record", "a.gif", "--vary", ""}, {"--vary", "no value"}},
      {"variation of no recording", {"--out", "a.png", "--vary", "a.b=0..1"}, {"--vary", "--record"}},
      {"variation without an end", {"--record", "a.gif", "--vary", "a.b=0.."}, {"--vary a.b=0..", "NAME=FROM..TO"}},
      {"variation without a beginning", {"--record", "a.gif", "--vary", "a.b=..1"}, {"NAME=FROM..TO"}},
      {"variation to one value", {"--record", "a.gif", "--vary", "a.b=1.5"}, {"--vary a.b=1.5", "NAME=FROM..TO"}},
      {"variation without a name", {"--record", "a.gif", "--vary", "=0..1"}, {"--vary =0..1", "NAME=FROM..TO"}},
      {"variation without a value", {"--record", "a.gif", "--vary", "a..b"}, {"--vary a..b", "NAME=FROM..TO"}},
      {"variation of what is set",
       {"--record", "a.gif", "--set", "a.b=7", "--vary", "a.b=0..1"},
       {"--vary a.b=0..1", "--set", "7"}},
      {"a film", {"--record", "q.mp4"}, {"--record q.mp4", ".gif", ".png, .bmp or .exr"}},
      {"a recording without an ending", {"--record", "turn"}, {"--record turn", ".gif"}},
      {"two kinds of pictures", {"--out", "a.png", "--record", "a.gif"}, {"--out", "--record"}},
      {"nowhere to look", {"--eye", "1,2,3", "--target", "1,2,3.0"}, {"--eye", "--target", "1,2,3"}},
      {"a setting twice", {"--set", "a.b=1", "--set", "a.b=2"}, {"--set a.b=2", "a.b is set to 1 already"}},
      {"for programs, of a picture", {"--out", "a.png", "--json"}, {"--json", "--list"}},
      {"cost of a window", {"--stats"}, {"--stats", "--out", "--record"}},
      {"cost of cases for programs", {"--cases", "a.json", "--out", "a", "--stats", "--json"}, {"--json", "picture"}},
      {"times without counts", {"--out", "a.png", "--repeat", "3"}, {"--repeat", "--stats"}},
      {"times of a recording", {"--record", "a.gif", "--stats", "--repeat", "3"}, {"--repeat", "--record"}},
      {"no repetition", {"--out", "a.png", "--stats", "--repeat", "0"}, {"--repeat", "10000"}},
      {"cases of another scene", {"--cases", "a.json", "--out", "a", "--scene", "hall"}, {"--cases", "--scene"}},
      {"cases of another size", {"--cases", "a.json", "--out", "a", "--size", "1x1"}, {"--cases", "--size"}},
      {"cases that are recorded", {"--cases", "a.json", "--out", "a", "--record", "a.gif"}, {"--record"}},
      {"progress of no cases", {"--out", "a.png", "--progress", "3"}, {"--progress", "--cases"}},
      {"a list into a file", {"--list", "--out", "a.txt"}, {"--list", "--out"}},
      {"a list of one scene", {"--list", "--scene", "hall"}, {"--list", "--scene"}},
      {"a list by a driver", {"--list", "--context", "egl"}, {"--list", "--context"}},
      {"no implementation", {"--implementations", ""}, {"--implementations", "no value"}},
      {"implementations between colons", {"--implementations", ":"}, {"--implementations :", "no folder"}},
      {"empty size", {"--size", ""}, {"--size", "no value"}},
      {"empty scene", {"--scene", ""}, {"--scene", "no value"}},
      {"empty output", {"--output", ""}, {"--output", "no value"}},
      {"empty context", {"--context", ""}, {"--context", "no value"}},
      {"empty eye", {"--eye="}, {"--eye"}},
      {"empty target", {"--target", ""}, {"--target", "no value"}},
      {"empty setting", {"--set", ""}, {"--set", "no value"}},
      {"empty file", {"--out", ""}, {"--out", "no value"}},
      {"empty recording", {"--record", ""}, {"--record", "no value"}},
      {"unknown context", {"--context", "cuda"}, {"cuda", "osmesa", "egl", "window"}},
      {"implementations that are not there", {"--implementations", "/no/such/folder"}, {"/no/such/folder"}},
      {"cases without a folder", {"--cases", "cases.json"}, {"--cases", "--out"}},
      {"descriptor in words", {"--progress", "three"}, {"--progress", "three"}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const std::string words = error_of([&] { parse(row.words); });
    INFO(words);
    CHECK(mentions(words, row.answer));
    CHECK(words.find('\n') == std::string::npos);
  }
}

TEST_CASE("missing arguments have defaults", "[command_line]") {
  const CommandLine line = parse({}).value();
  CHECK(line.picture.size == glm::ivec2(640, 480));
  CHECK(line.picture.output == "colour");
  CHECK(line.picture.scene.empty());
  CHECK(line.frames == 48);
  CHECK(line.repeat == 0);
  CHECK_FALSE(line.vary);
  CHECK_FALSE(line.stats);
  CHECK(line.settings.empty());
  CHECK_FALSE(line.context);
  CHECK_FALSE(line.implementations);
  CHECK_FALSE(line.picture.camera.eye);
  CHECK_FALSE(line.list);
}

TEST_CASE("arguments are read", "[command_line]") {
  const CommandLine line = parse({"--scene",   "hall",     "--size",  "1x4096",   "--set",      "a.b=1",    "--set",
                                  "c=x=y",     "--output", "depth",   "--eye",    "-1,2.5,1e6", "--target", "0,0,-0.5",
                                  "--context", "egl",      "--stats", "--record", "turn.GIF",   "--frames", "7"})
                               .value();
  CHECK(line.picture.scene == "hall");
  CHECK(line.picture.size == glm::ivec2(1, 4096));
  REQUIRE(line.settings.size() == 2);
  CHECK(line.settings[0] == std::pair<std::string, std::string>("a.b", "1"));
  CHECK(line.settings[1] == std::pair<std::string, std::string>("c", "x=y"));
  CHECK(line.picture.output == "depth");
  CHECK(line.picture.camera.eye == glm::dvec3(-1, 2.5, 1e6));
  CHECK(line.picture.camera.target == glm::dvec3(0, 0, -0.5));
  CHECK(line.context == ContextKind::egl);
  CHECK(line.stats);
  CHECK(line.record == "turn.GIF");
  CHECK(line.frames == 7);

  const struct {
    const char *text, *from, *to;
  } ranges[] = {{"a.b=0..360", "0", "360"},
                {"a.b=-1.5..-16", "-1.5", "-16"},
                {"a.b=.5...25", ".5", ".25"},
                {"a.b=0,.5,1..#3380ff", "0,.5,1", "#3380ff"}};
  for (const auto& row : ranges) {
    INFO(row.text);
    const CommandLine varied = parse({"--record", "a.gif", "--vary", row.text}).value();
    REQUIRE(varied.vary);
    CHECK(varied.vary->name == "a.b");
    CHECK(varied.vary->from == row.from);
    CHECK(varied.vary->to == row.to);
  }

  const CommandLine measured = parse({"--out", "a.png", "--stats", "--repeat", "9", "--json"}).value();
  CHECK(measured.stats);
  CHECK(measured.json);
  CHECK(measured.repeat == 9);
  CHECK(parse({"--cases", "job.json", "--out", "answers", "--stats"}).value().stats);

  const CommandLine judged = parse({"--cases", "job.json", "--out", "answers", "--progress", "5"}).value();
  CHECK(judged.cases == "job.json");
  CHECK(judged.out == "answers");
  CHECK(judged.progress == 5);

  const CommandLine list = parse({"--list", "--json"}).value();
  CHECK(list.list);
  CHECK(list.json);
}

TEST_CASE("a window's command line survives being written and read again", "[command_line]") {
  const TemporaryFolder folder;
  CommandLine line = parse({}).value();
  line.picture.scene = "-odd name.obj";
  line.picture.size = {123, 45};
  line.picture.output = "normal";
  line.picture.camera.eye = {-1.0 / 3, 1e6 + 0.1, 5e-324};  // the least double: the shortest text still reads back
  line.picture.camera.target = {0, -0.0, 1e300};
  line.settings = {{"a.b", "-0.1"}, {"c", "x=y"}, {"d", "off"}, {"e", "-0.2,0.5,1"}, {"f", "#3380ff"}};
  line.context = ContextKind::window;
  line.implementations = Implementations::parse("00-fake=" + folder.path().string());

  const CommandLine again = parse(to_arguments(line)).value();
  CHECK(again.picture.scene == line.picture.scene);
  CHECK(again.picture.size == line.picture.size);
  CHECK(again.picture.output == line.picture.output);
  CHECK(again.picture.camera.eye == line.picture.camera.eye);
  CHECK(again.picture.camera.target == line.picture.camera.target);
  CHECK(again.settings == line.settings);
  CHECK(again.context == line.context);
  CHECK(again.implementations->to_string() == line.implementations->to_string());
}
