#include "grade/intake/version_names.hpp"

#include <algorithm>
#include <vector>

#include "catch.hpp"

using namespace atelier::grade;

TEST_CASE("a name is split into what is versioned and its version") {
  struct Row {
    const char* name;
    const char* base;
    bool versioned;
  };
  const Row rows[] = {{"ada", "ada", false},
                      {"ada.zip", "ada", false},
                      {"ada v2", "ada", true},
                      {"Ada-V2.tar.gz", "Ada", true},
                      {"ada (1).zip", "ada", true},
                      {"ada(1)", "ada", true},
                      {"ada - Copy", "ada", true},
                      {"ada - Copy (2)", "ada", true},
                      {"ada_final_v3", "ada", true},
                      {"ada-2024-03-05", "ada", true},
                      {"ada_20240305", "ada", true},
                      {"v1", "", true},
                      {"old", "", true},
                      {"final", "", true},
                      {"(1)", "", true},
                      {"", "", false},
                      {"---", "", false},
                      {"hw2", "hw2", false},
                      {"ada-2", "ada-2", false},
                      {"gold", "gold", false},
                      {"renew", "renew", false},
                      {"ada-12345678", "ada-12345678", false},
                      {"in/a/folder/ada v2", "ada", true}};
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(split_version(row.name).base == row.base);
    CHECK(split_version(row.name).versioned == row.versioned);
  }
}

TEST_CASE("versions are ordered by their names") {
  const std::vector<std::string> sorted = {
      "ada old", "ada", "ada (1)", "ada v2", "ada v10", "ada 2024-03-05", "ada 2024-11-01", "ada final"};
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      INFO(sorted[i] << ", " << sorted[j]);
      CHECK(is_older(sorted[i], sorted[j]) == (i < j));
    }
  CHECK(is_older("hw9", "hw10"));
  CHECK(is_older("hw09", "hw10"));
  CHECK_FALSE(is_older("hw10", "hw9"));
}

TEST_CASE("names of versions and of parts of a work are no students'") {
  for (const char* name : {"v1", "old", "new", "final (2)", "hw1", "HW_02", "src", "Homework 3.zip", "skeletons", "2",
                           "2024-03-05", "notes", ""}) {
    INFO(name);
    CHECK(is_name_of_work(name));
  }
  for (const char* name : {"ada", "Ada Lovelace", "ada-v2", "group1", "1234567", "hw-ada", "submitter"}) {
    INFO(name);
    CHECK_FALSE(is_name_of_work(name));
  }
}

TEST_CASE("a second copy's number is taken off") {
  CHECK(without_copy_number("light (1)") == "light");
  CHECK(without_copy_number("light-1") == "light");
  CHECK(without_copy_number("light_12") == "light");
  CHECK(without_copy_number("light - Copy") == "light");
  CHECK(without_copy_number("light-123456") == "light-123456");
  CHECK(without_copy_number("light") == "light");
  CHECK(without_copy_number("-1") == "-1");
}
