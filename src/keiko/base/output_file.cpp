#include "keiko/base/output_file.h"

#include "keiko/base/atomic_file.h"
#include "keiko/base/descriptor.h"

#include <fcntl.h>

namespace keiko {
namespace fs = std::filesystem;

void sync_to_disk(const fs::path& folder) {
    const Descriptor names(
        open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (names.open()) fsync(names.number());
}

void write_text_file(const fs::path& target, std::string_view text) {
    AtomicFile file(target);
    file.fill(text);
    file.put_in_place();
}

} // namespace keiko
