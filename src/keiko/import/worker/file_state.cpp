#include "keiko/import/worker/file_state.h"

#include "keiko/base/input_file.h"
#include "keiko/base/new_file.h"
#include "keiko/base/sha256.h"

#include <sys/stat.h>

namespace keiko {

FileStamp file_stamp(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) throw_system_error(file, "cannot read");
    return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
            status.st_ctim.tv_sec * 1'000'000'000 + status.st_ctim.tv_nsec};
}

FileState file_state(const std::filesystem::path& file) {
    const FileStamp stamp = file_stamp(file);
    return {stamp, sha256_hex(read_file(file))};
}

} // namespace keiko
