// Messages for exceptions of a student's code.
#include "app/thrown.hpp"

#include <functional>
#include <stdexcept>

#include "catch.hpp"

using namespace atelier;

namespace {

struct Odd {};

std::string words_for(const std::function<void()>& code) {
  try {
    code();
  } catch (...) {
    return thrown_in_words();
  }
  return "nothing was thrown";
}

}  // namespace

TEST_CASE("a thrown exception is reported with its type, and its text if it has one") {
  struct Row {
    const char* name;
    std::function<void()> code;
    std::string words;
  };
  const Row rows[] = {
      {"an int", [] { throw 42; }, "int was thrown: 42"},
      {"a std::exception", [] { throw std::out_of_range("vector::at"); }, "std::out_of_range was thrown: vector::at"},
      {"a literal", [] { throw "boom"; }, "a string was thrown: boom"},
      {"a null text", [] { throw static_cast<const char*>(nullptr); }, "a string was thrown: (null)"},
      {"a string", [] { throw std::string("boom"); }, "std::string was thrown: boom"},
      {"a type of one's own", [] { throw Odd{}; }, "(anonymous namespace)::Odd was thrown"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(words_for(row.code) == row.words);
  }
  CHECK(thrown_in_words() == "std::terminate was called");
}

TEST_CASE("mangled names are demangled, others are kept") {
  CHECK(demangle("_ZN7atelier7look_atEv") == "atelier::look_at()");
  CHECK(demangle("look_at") == "look_at");
}
