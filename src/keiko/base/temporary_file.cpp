#include "keiko/base/temporary_file.h"

#include "keiko/base/error.h"

#include <cerrno>
#include <cstdio>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// New file at `path`; errors name the target, which the user knows.
Descriptor create_for(const fs::path& target, const fs::path& path, mode_t mode, int folder) {
    try {
        return create_file(path, mode, folder);
    } catch (const Error& error) {
        throw Error(target.string(), error.where(), error.reason());
    }
}

} // namespace

TemporaryFile::TemporaryFile(fs::path target, mode_t mode, int folder)
    : target_(std::move(target)),
      path_(target_.parent_path() / temporary_name()),
      folder_(folder),
      file_(create_for(target_, path_, mode, folder)) {}

TemporaryFile::~TemporaryFile() {
    if (!path_.empty()) unlinkat(folder_, path_.c_str(), 0);
}

void TemporaryFile::write(std::string_view bytes) {
    write_all(file_, bytes, target_);
}

void TemporaryFile::finish() {
    // Some file systems have nothing to wait for.
    const bool kept = fsync(file_.number()) == 0 || errno == EINVAL || errno == ENOTSUP;
    if (!kept) throw_system_error(target_, "cannot write");
    file_.close();
}

void TemporaryFile::put_in_place() {
    if (renameat(folder_, path_.c_str(), folder_, target_.c_str()) != 0)
        throw_system_error(target_, "cannot write");
    path_.clear();
}

} // namespace keiko
