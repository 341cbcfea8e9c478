#pragma once

namespace keiko {

/// For a program's first line: freed blocks of up to 4 MB stay with the process, and up to 64 MB of
/// free memory at the top of each heap. By default glibc hands that back to the system, and then
/// each tile of a picture has its pages made and cleared anew, which costs up to a third of the
/// time. Larger blocks, such as pictures, come from the system, zero already. Leaves alone what
/// MALLOC_TRIM_THRESHOLD_ or MALLOC_MMAP_THRESHOLD_ set; does nothing with other libraries.
void keep_freed_memory();

} // namespace keiko
