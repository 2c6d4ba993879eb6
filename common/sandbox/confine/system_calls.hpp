// The system calls that no confined program may make.
#pragma once

namespace atelier::confine {

/// Refuses them with EPERM, for this process and all that it starts, for ever: what reaches other processes, the
/// network, mounts, namespaces, keys, the kernel's modules and tracing, and io_uring, which a filter does not see into.
/// False with errno set without success, or if this processor has no filter here.
bool refuse_system_calls();

}  // namespace atelier::confine
