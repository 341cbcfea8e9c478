#include "keiko/base/output_file.h"

#include "keiko/base/error.h"
#include "keiko/base/pending_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>

namespace keiko {
namespace fs = std::filesystem;

void sync_to_disk(const fs::path& path) {
    const int descriptor = open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

void write_bytes(const fs::path& path, std::string_view bytes, const fs::path& name) {
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw Error(name.string(), "", "cannot write");
}

void write_atomically(const fs::path& path,
                      const std::function<void(const fs::path& temporary)>& write) {
    PendingFile file(path);
    file.fill(write);
    file.put_in_place();
}

void write_text_file(const fs::path& target, std::string_view text) {
    write_atomically(target,
                     [&](const fs::path& temporary) { write_bytes(temporary, text, target); });
}

} // namespace keiko
