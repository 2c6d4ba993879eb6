#include "base/sealed.hpp"

#include "catch.hpp"

using namespace atelier;

TEST_CASE("a sealed text comes back, and cannot be read or searched") {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += char(byte);
  const std::string zeros(1000, '\0');
  for (const std::string& text : {std::string(), std::string("return max(dot(n, l), 0.0);"), all, zeros}) {
    INFO(text.size() << " bytes");
    const std::string sealed = seal(text);
    CHECK(is_sealed(sealed));
    CHECK(is_sealed(sealed.substr(0, seal_length)));
    CHECK(unsealed(sealed) == text);
    if (!text.empty()) CHECK(sealed.find(text) == sealed.npos);
    CHECK(sealed.find('\0') < seal_length);  // tools take it for what it is, no text
  }
  CHECK(seal("dot(n, l)").find("dot") == std::string::npos);
}

TEST_CASE("what is not sealed stays as it is") {
  for (const std::string& text : {std::string(), std::string("Atelier: a sealed part"), seal("a").substr(1)}) {
    CHECK_FALSE(is_sealed(text));
    CHECK(unsealed(text) == text);
  }
}
