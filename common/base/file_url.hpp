// The address of a file.
#pragma once

#include <filesystem>
#include <string>

namespace atelier {

/// "file:///home/a%20b/report.html": an absolute path as an address for browsers and terminals (RFC 8089). Bytes other
/// than ASCII letters, digits and -._~/ are percent-encoded.
std::string file_url(const std::filesystem::path& path);

}  // namespace atelier
