#include "keiko/base/output_file.h"

#include "keiko/base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <system_error>

namespace keiko {
namespace fs = std::filesystem;

void sync_to_disk(const fs::path& path) {
    const int descriptor = open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

void write_atomically(const fs::path& target,
                      const std::function<void(const fs::path& temporary)>& write) {
    std::error_code ignored; // whatever is wrong with the target shows when it is written
    if (fs::is_directory(target, ignored))
        throw Error(target.string(), "", "is a directory, not a file");
    const fs::path temporary =
        target.parent_path() / ("." + target.stem().string() + "." + std::to_string(getpid()) +
                                ".tmp" + target.extension().string());
    try {
        write(temporary);
        sync_to_disk(temporary);
        fs::rename(temporary, target);
        sync_to_disk(target.parent_path());
    } catch (const fs::filesystem_error& error) {
        fs::remove(temporary, ignored);
        throw Error(target.string(), "", "cannot write: " + error.code().message());
    } catch (...) {
        fs::remove(temporary, ignored);
        throw;
    }
}

void write_text_file(const fs::path& target, std::string_view text) {
    write_atomically(target, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.close();
        if (!out) throw Error(target.string(), "", "cannot write");
    });
}

} // namespace keiko
