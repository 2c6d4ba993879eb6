// atelier-unseal SEALED OUT: writes the text of a sealed source, for the build (cmake/sealed.cmake).
#include <cstdio>
#include <fstream>
#include <sstream>

#include "base/sealed.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: atelier-unseal SEALED OUT\n", stderr);
    return 2;
  }
  std::ostringstream bytes;
  bytes << std::ifstream(arguments[1], std::ios::binary).rdbuf();
  if (!atelier::is_sealed(bytes.str())) {
    std::fprintf(stderr, "error: %s: is damaged; unpack the release again\n", arguments[1]);
    return 2;
  }
  std::ofstream out(arguments[2], std::ios::binary);
  out << atelier::unsealed(bytes.str());
  out.close();
  if (out) return 0;
  std::fprintf(stderr, "error: %s: cannot be written\n", arguments[2]);
  return 2;
}
