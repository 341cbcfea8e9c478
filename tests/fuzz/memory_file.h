#pragma once

#include "tests/fuzz/fuzz_target.h"
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace keiko::fuzz {

/// A file that never reaches a disk, for readers that take a path.
class MemoryFile {
public:
    MemoryFile() : number_(memfd_create("fuzz", MFD_CLOEXEC)) {
        require(number_ >= 0, "there is memory for a file");
    }
    ~MemoryFile() { close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    void write(std::string_view content) const {
        require(ftruncate(number_, 0) == 0, "the file can be emptied");
        const ssize_t written = pwrite(number_, content.data(), content.size(), 0);
        require(written == static_cast<ssize_t>(content.size()), "the file can be written");
    }
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    int number_;
};

} // namespace keiko::fuzz
