#include "keiko/base/atomic_file.h"

#include "keiko/base/output_file.h"
#include "keiko/base/stream_output.h"

namespace keiko {

AtomicFile::AtomicFile(const std::filesystem::path& path) : target_(output_target(path)) {
    if (!target_.stream) file_.emplace(target_.path);
}

void AtomicFile::fill(std::string_view bytes) {
    if (!file_) {
        bytes_ = bytes;
        return;
    }
    file_->write(bytes);
    file_->finish();
}

void AtomicFile::put_in_place() {
    if (!file_) return write_to_stream(target_.path, bytes_);
    file_->put_in_place();
    sync_to_disk(target_.path.parent_path());
}

} // namespace keiko
