// The assembly of shader files, without a driver.
#include <map>

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"
#include "gl/shader.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

using FileMap = std::map<std::string, std::string>;  ///< names and texts

/// Shader files in a folder that lasts as long as this.
class Files {
 public:
  explicit Files(const FileMap& files) {
    for (const auto& [name, text] : files) write_file(folder_.path() / name, text);
  }
  ShaderSource assemble(const std::string& name = "main.glsl", const Defines& defines = {}) const {
    return assemble_shader([this](const std::string& n) { return find(n); }, name, defines);
  }
  std::filesystem::path find(const std::string& name) const {
    const auto file = folder_.path() / name;
    return std::filesystem::exists(file) ? file : std::filesystem::path();
  }

 private:
  TemporaryFolder folder_;
};

const std::string head = "#version 330 core\n";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// "main.glsl:1 b.glsl:1 ...": where the lines of a text come from.
std::string origins(const ShaderSource& source) {
  std::string text;
  for (const auto& [file, line] : source.lines)
    text +=
        (text.empty() ? "" : " ") + (file < 0 ? "-" : source.names.at(std::size_t(file))) + ":" + std::to_string(line);
  return text;
}

}  // namespace

TEST_CASE("The version and the defines come first, in order") {
  const Files files(FileMap{{"main.glsl", "void main() {}\n"}});
  const ShaderSource source = files.assemble("main.glsl", {{"ZED", "1"}, {"ALPHA", "vec3(1, 2, 3)"}, {"FLAG", ""}});
  CHECK(source.text == head + "#define ALPHA vec3(1, 2, 3)\n#define FLAG \n#define ZED 1\nvoid main() {}\n");
  CHECK(origins(source) == "-:1 -:2 -:3 -:4 main.glsl:1");
  REQUIRE(source.files.size() == 1);
  CHECK(source.files[0].filename() == "main.glsl");
}

TEST_CASE("Every line is mapped to its file") {
  const Files files(FileMap{{"main.glsl", "a\n#include \"sub/b.glsl\"\nc\n"}, {"sub/b.glsl", "b\n\n"}});
  const ShaderSource source = files.assemble();
  CHECK(source.text == head + "a\nb\n\nc\n");
  CHECK(origins(source) == "-:1 main.glsl:1 sub/b.glsl:1 sub/b.glsl:2 main.glsl:3");
}

TEST_CASE("A text that is not a file can include files") {
  const Files files(FileMap{{"b.glsl", "b\n"}});
  const ShaderSource source = assemble_shader_text([&](const std::string& name) { return files.find(name); },
                                                   "#include \"b.glsl\"\nx", "surface shader", {});
  CHECK(source.text == head + "b\nx\n");
  CHECK(origins(source) == "-:1 b.glsl:1 surface shader:2");
}

TEST_CASE("A sealed file is included like its text") {
  const FileMap plain = {{"main.glsl", "#include \"a.glsl\"\nlast\n"}, {"a.glsl", "one\ntwo\n"}};
  FileMap sealed = plain;
  sealed["a.glsl"] = seal(plain.at("a.glsl"));
  CHECK(Files(sealed).assemble().text == Files(plain).assemble().text);
}

TEST_CASE("The defines of a text precede its includes") {
  CHECK(text_including("a.glsl") == "#include \"a.glsl\"\n");
  CHECK(text_including("a.glsl", {{"TWO", "2"}, {"ONE", "1"}}, "float f;\n") ==
        "#define ONE 1\n#define TWO 2\nfloat f;\n#include \"a.glsl\"\n");
}

TEST_CASE("Line endings are normalised") {
  struct Row {
    const char* name;
    std::string text, assembled;
  };
  const Row rows[] = {
      {"empty file", "", "\n"},
      {"no last newline", "a", "a\n"},
      {"Windows line ends", "a\r\nb\r\n", "a\nb\n"},
      {"old Macintosh line ends", "a\rb", "a\nb\n"},
      {"byte order mark",
       "\xEF\xBB\xBF"
       "a\n",
       "a\n"},
      {"continued last line", "#define A \\", "#define A \\\n\n"},
      {"UTF-8 in a comment",
       "// Gr\xC3\xB6\xC3\x9F"
       "e\n",
       "// Gr\xC3\xB6\xC3\x9F"
       "e\n"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Files files(FileMap{{"main.glsl", row.text}});
    CHECK(files.assemble().text == head + row.assembled);
  }
}

TEST_CASE("An include is followed unless it is in a comment or not a directive") {
  struct Row {
    const char* name;
    std::string text;
    bool followed;
  };
  const Row rows[] = {
      {"plain", "#include \"b.glsl\"\n", true},
      {"without a newline", "#include \"b.glsl\"", true},
      {"with blanks", "  \t# \t include\t\"b.glsl\"  \n", true},
      {"without a blank", "#include\"b.glsl\"\n", true},
      {"Windows line end", "#include \"b.glsl\"\r\n", true},
      {"byte order mark", "\xEF\xBB\xBF#include \"b.glsl\"\n", true},
      {"comment behind", "#include \"b.glsl\" // the b\n", true},
      {"comment in front", "/* the b */ #include \"b.glsl\"\n", true},
      {"comment between", "#include /* the */ \"b.glsl\"\n", true},
      {"end of a long comment in front", "/*\n*/#include \"b.glsl\"\n", true},
      {"inside #if 0", "#if 0\n#include \"b.glsl\"\n#endif\n", true},
      {"line comment", "// #include \"b.glsl\"\n", false},
      {"block comment", "/* #include \"b.glsl\" */\n", false},
      {"long block comment", "/*\n#include \"b.glsl\"\n*/\n", false},
      {"block comment that holds //", "/* //\n#include \"b.glsl\"\n//*/\n", false},
      {"line comment that seems to begin a block", "// /*\n#include \"b.glsl\"\n", true},
      {"a comment's end is no beginning", "/*/\n#include \"b.glsl\"\n/*/\n", false},
      {"not at the line's beginning", "x #include \"b.glsl\"\n", false},
      {"another word", "#includes \"b.glsl\"\n", false},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Files files(FileMap{{"main.glsl", row.text}, {"b.glsl", "marker\n"}});
    CHECK(count(files.assemble().text, "marker") == (row.followed ? 1 : 0));
  }
}

TEST_CASE("Comments around an include are kept whole") {
  const Files files(FileMap{{"main.glsl", "/* one\n*/ #include \"b.glsl\" /* two\n*/ x\n"}, {"b.glsl", "b"}});
  CHECK(files.assemble().text == head + "/* one\n*/ \nb\n /* two\n*/ x\n");
  CHECK(origins(files.assemble()) == "-:1 main.glsl:1 main.glsl:2 b.glsl:1 main.glsl:2 main.glsl:3");
}

TEST_CASE("A file name may contain the start of a comment") {
  const Files files(FileMap{{"main.glsl", "#include \"sub//b.glsl\"\n"}, {"sub/b.glsl", "marker\n"}});
  CHECK(count(files.assemble().text, "marker") == 1);
}

TEST_CASE("A file is included once") {
  struct Row {
    const char* name;
    FileMap files;
  };
  const Row rows[] = {
      {"twice", {{"main.glsl", "#include \"b.glsl\"\n#include \"b.glsl\"\n"}, {"b.glsl", "marker\n"}}},
      {"by two ways",
       {{"main.glsl", "#include \"c.glsl\"\n#include \"d.glsl\"\n"},
        {"c.glsl", "#include \"b.glsl\"\n"},
        {"d.glsl", "#include \"b.glsl\"\n"},
        {"b.glsl", "marker\n"}}},
      {"under two spellings",
       {{"main.glsl", "#include \"sub/b.glsl\"\n#include \"sub/../sub/b.glsl\"\n"}, {"sub/b.glsl", "marker\n"}}},
      {"itself", {{"main.glsl", "#include \"main.glsl\"\nmarker\n"}}},
      {"a cycle",
       {{"main.glsl", "#include \"b.glsl\"\nmarker\n"},
        {"b.glsl", "#include \"c.glsl\"\n"},
        {"c.glsl", "#include \"main.glsl\"\n"}}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(count(Files(row.files).assemble().text, "marker") == 1);
  }
}

TEST_CASE("Errors of assembly have file and line") {
  struct Row {
    const char* name;
    std::string text;
    std::vector<std::string_view> words;
  };
  const Row rows[] = {
      {"missing include", "a\n#include \"no.glsl\"\n", {"main.glsl:2", "no.glsl", "not found"}},
      {"included folder", "#include \"sub\"\n", {"main.glsl:1", "folder"}},
      {"version", "\n\n#version 450\n", {"main.glsl:3", "#version"}},
      {"version after blanks", " # version 330\n", {"main.glsl:1", "#version"}},
      {"extension", "#extension GL_ARB_gpu_shader5 : enable\n", {"main.glsl:1", "#extension"}},
      {"line", "#line 7\n", {"main.glsl:1", "#line"}},
      {"version in an included file", "#include \"sub/version.glsl\"\n", {"sub/version.glsl:2", "#version"}},
      {"angle brackets", "#include <b.glsl>\n", {"main.glsl:1", "#include \"file\""}},
      {"no name", "#include\n", {"main.glsl:1", "#include \"file\""}},
      {"empty name", "#include \"\"\n", {"main.glsl:1", "#include \"file\""}},
      {"open quote", "#include \"b.glsl\n", {"main.glsl:1", "#include \"file\""}},
      {"two names", "#include \"b.glsl\" \"c.glsl\"\n", {"main.glsl:1", "#include \"file\""}},
      {"comment without an end", "a\nb /* c\nd\n", {"main.glsl:2", "no end"}},
      {"null byte", std::string("a\nb\0c\n", 6), {"main.glsl:2", "null byte"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Files files(FileMap{{"main.glsl", row.text}, {"sub/version.glsl", "\n#version 120\n"}});
    const std::string message = error_of([&] { files.assemble(); });
    INFO(message);
    for (const std::string_view word : row.words) CHECK(mentions(message, {word}));
  }
  const Files files(FileMap{{"main.glsl", ""}});
  CHECK(mentions(error_of([&] { files.assemble("other.glsl"); }), {"other.glsl", "not found"}));
}

TEST_CASE("Directives in comments are ignored") {
  const Files files(FileMap{{"main.glsl", "// #version 450\n/*\n#extension all : enable\n*/\n"}});
  CHECK_NOTHROW(files.assemble());
}

TEST_CASE("Includes may be nested 32 deep and no deeper") {
  const auto nested = [](int depth) {
    FileMap files;
    for (int i = 0; i < depth; ++i) {
      const std::string name = i == 0 ? "main.glsl" : std::to_string(i) + ".glsl";
      files[name] = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
    }
    files[std::to_string(depth) + ".glsl"] = "marker\n";
    return Files(files);
  };
  CHECK(count(nested(32).assemble().text, "marker") == 1);
  CHECK(mentions(error_of([&] { nested(33).assemble(); }), {"32.glsl:1", "33.glsl", "at most 32"}));
}

TEST_CASE("A file of a megabyte is refused") {
  const Files files(FileMap{{"main.glsl", "#include \"b.glsl\"\n"}, {"b.glsl", std::string((1 << 20) + 1, ' ')}});
  CHECK(mentions(error_of([&] { files.assemble(); }), {"main.glsl:1", "b.glsl", "at most"}));
}
