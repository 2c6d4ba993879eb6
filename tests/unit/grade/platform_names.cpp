#include "grade/intake/platform_names.hpp"

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using namespace atelier::grade;

TEST_CASE("names of Moodle") {
  const auto folder = moodle_name("Ada Lovelace_12345_assignsubmission_file_");
  REQUIRE(folder);
  CHECK(folder->name == "Ada Lovelace");
  CHECK(folder->identifier == "12345");
  CHECK(folder->file == "");
  CHECK_FALSE(folder->is_text);
  CHECK(moodle_name("Ada Lovelace_12345_assignsubmission_file")->identifier == "12345");
  CHECK(moodle_name("Ada_L_12345_assignsubmission_file_hw_1.zip")->file == "hw_1.zip");
  CHECK(moodle_name("Ada_L_12345_assignsubmission_file_hw_1.zip")->name == "Ada_L");
  CHECK(moodle_name("Ada_1_assignsubmission_onlinetext_")->is_text);
  for (const char* other :
       {"", "ada", "_assignsubmission_file_", "Ada_assignsubmission_file_", "Ada_x1_assignsubmission_"})
    CHECK_FALSE(moodle_name(other));
}

TEST_CASE("names of Canvas") {
  const auto found = canvas_name("lovelaceada_LATE_123_456_hw_1-2.zip");
  REQUIRE(found);
  CHECK(found->name == "lovelaceada");
  CHECK(found->identifier == "123");
  CHECK(found->order == 456);
  CHECK(found->file == "hw_1-2.zip");
  CHECK(found->late);
  CHECK_FALSE(canvas_name("lovelaceada_123_456_a.zip")->late);
  for (const char* other :
       {"", "ada_123_a.zip", "ada_123_456_", "_1_2_a", "ada_LATE_1_a_b", "ada_1_12345678901234567890_a"})
    CHECK_FALSE(canvas_name(other));
}

TEST_CASE("uploaded files have the names that they had") {
  CHECK(uploaded_name("ada_1_2_light_up.cpp") == "light_up.cpp");
  CHECK(uploaded_name("Ada_1_assignsubmission_file_light_up.cpp") == "light_up.cpp");
  CHECK(uploaded_name("light_up.cpp") == "light_up.cpp");
}

TEST_CASE("sentences name entries as they were uploaded, where that tells them apart") {
  using Names = std::vector<std::string>;
  CHECK(names_for_sentences({"ada_1_2_hw.zip", "ada_1_3_hw-1.zip"}) == Names{"hw.zip", "hw-1.zip"});
  CHECK(names_for_sentences({"ada_1_2_hw.zip", "ada_1_3_hw.zip"}) == Names{"ada_1_2_hw.zip", "ada_1_3_hw.zip"});
  CHECK(names_for_sentences({"Ada L_1_assignsubmission_file_"}) == Names{"Ada L"});
  CHECK(names_for_sentences({"submission_1"}) == Names{"submission_1"});
}

TEST_CASE("Gradescope's metadata name the students") {
  const TemporaryFolder folder;
  write_file(folder.path() / gradescope_metadata, std::string_view(R"(---
submission_111:
  :submitters:
  - :name: Ada Lovelace
    :sid: '12 34'
    :email: ada@example.org
  :created_at: 2024-03-05 23:30:00.123456000 +01:00
  :score: 7.0
  :history:
  - :id: 99
    :submitters:
    - :name: Nobody
    :created_at: 2020-01-01 00:00:00.000000000 Z
submission_222:
  :submitters:
  - :name: "Bob \"B\" O'Neil"
    :sid:
    :email: bob@example.org
  - :name: 'Carl ''C'''
    :sid: 77
  :created_at: 1970-01-02 00:00:01 Z
submission_x:
  :submitters:
  - :name: Nobody
submission_333:
  :created_at: yesterday
)"));
  const auto found = read_gradescope_metadata(folder.path() / gradescope_metadata);
  REQUIRE(found.size() == 3);
  REQUIRE(found.at("submission_111").submitters.size() == 1);
  CHECK(found.at("submission_111").submitters[0].name == "Ada Lovelace");
  CHECK(found.at("submission_111").submitters[0].identifier == "12 34");
  CHECK(found.at("submission_111").created == 1709677800);
  REQUIRE(found.at("submission_222").submitters.size() == 2);
  CHECK(found.at("submission_222").submitters[0].name == "Bob \"B\" O'Neil");
  CHECK(found.at("submission_222").submitters[0].identifier == "bob@example.org");
  CHECK(found.at("submission_222").submitters[1].name == "Carl 'C'");
  CHECK(found.at("submission_222").submitters[1].identifier == "77");
  CHECK(found.at("submission_222").created == 86401);
  CHECK(found.at("submission_333").submitters.empty());
  CHECK_FALSE(found.at("submission_333").created);
}
