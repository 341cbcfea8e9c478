#include "keiko/base/pending_file.h"

#include "keiko/base/output_file.h"
#include "keiko/base/stream_output.h"

namespace keiko {

PendingFile::PendingFile(const std::filesystem::path& path) : target_(output_target(path)) {
    if (!target_.stream) file_.emplace(target_.path);
}

void PendingFile::fill(std::string_view bytes) {
    if (!file_) {
        bytes_ = bytes;
        return;
    }
    file_->write(bytes);
    file_->finish();
}

void PendingFile::put_in_place() {
    if (!file_) return write_to_stream(target_.path, bytes_);
    file_->put_in_place();
    sync_to_disk(target_.path.parent_path());
}

} // namespace keiko
