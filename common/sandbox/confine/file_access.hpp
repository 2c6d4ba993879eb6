// Restricts a process to some files and folders, with Landlock, where there is no file system of its own.
#pragma once

#include <string>
#include <vector>

namespace atelier::confine {

/// From now on this process, and all that it starts, can read and run only what lies in `readable`, and write only what
/// lies in `writable`; both are existing files and folders. It can also reach no process and no abstract socket
/// outside, where the kernel knows how. False with errno set without success.
bool restrict_files(const std::vector<std::string>& readable, const std::vector<std::string>& writable);

}  // namespace atelier::confine
