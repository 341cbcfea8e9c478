#include "keiko/base/pending_file.h"

#include "keiko/base/error.h"
#include "keiko/base/output_file.h"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <system_error>

namespace keiko {
namespace fs = std::filesystem;
namespace {

fs::path temporary_in(const fs::path& folder, const std::string& stem, const fs::path& extension) {
    return folder / ("." + stem + "." + std::to_string(getpid()) + ".tmp" + extension.string());
}

bool is_stream(const fs::path& target) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

/// Several outputs may go to one device.
std::string numbered(const fs::path& stem) {
    static std::atomic<unsigned> number{0};
    return stem.string() + "-" + std::to_string(++number);
}

void copy_into(const fs::path& temporary, const fs::path& stream) {
    std::ifstream in(temporary, std::ios::binary);
    std::ofstream out(stream, std::ios::binary);
    if (fs::file_size(temporary) > 0) out << in.rdbuf();
    out.close();
    if (!in || !out) throw Error(stream.string(), "", "cannot write");
}

template <class Step>
void with_errors_of(const fs::path& path, const Step& step) {
    try {
        step();
    } catch (const fs::filesystem_error& error) {
        throw Error(path.string(), "", "cannot write: " + error.code().message());
    }
}

} // namespace

PendingFile::PendingFile(const fs::path& path) : path_(path), target_(path) {
    std::error_code ignored; // whatever is wrong with the target shows when it is written
    if (fs::is_directory(path, ignored))
        throw Error(path.string(), "", "is a directory, not a file");
    stream_ = is_stream(path);
    if (stream_) {
        temporary_ =
            temporary_in(fs::temp_directory_path(ignored), numbered(path.stem()), path.extension());
        return;
    }
    if (fs::is_symlink(path, ignored)) target_ = fs::weakly_canonical(path, ignored);
    temporary_ = temporary_in(target_.parent_path(), target_.stem().string(), target_.extension());
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void PendingFile::fill(const std::function<void(const fs::path& temporary)>& write) {
    with_errors_of(path_, [&] {
        write(temporary_);
        if (!stream_) sync_to_disk(temporary_);
    });
}

void PendingFile::put_in_place() {
    with_errors_of(path_, [&] {
        if (stream_) return copy_into(temporary_, path_);
        fs::rename(temporary_, target_);
        sync_to_disk(target_.parent_path());
    });
}

} // namespace keiko
