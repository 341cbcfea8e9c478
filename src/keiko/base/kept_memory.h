#pragma once

namespace keiko {

/// For a program's first line: freed memory, up to some 64 MB a thread, stays with the process. By
/// default glibc hands it back to the system whenever the top of the heap is free, and then each
/// tile of a picture has its pages made and cleared anew, which costs up to a third of the time.
/// Does nothing with other libraries.
void keep_freed_memory();

} // namespace keiko
