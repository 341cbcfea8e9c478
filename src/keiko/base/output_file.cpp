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

namespace {

fs::path temporary_in(const fs::path& folder, const fs::path& target) {
    return folder / ("." + target.stem().string() + "." + std::to_string(getpid()) + ".tmp" +
                     target.extension().string());
}

/// Devices and pipes: nothing may take their place.
bool is_stream(const fs::path& target) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

void copy_into(const fs::path& temporary, const fs::path& stream) {
    std::ifstream in(temporary, std::ios::binary);
    std::ofstream out(stream, std::ios::binary);
    if (fs::file_size(temporary) > 0) out << in.rdbuf();
    out.close();
    if (!in || !out) throw Error(stream.string(), "", "cannot write");
}

void replace(const fs::path& target, const fs::path& temporary) {
    sync_to_disk(temporary);
    fs::rename(temporary, target);
    sync_to_disk(target.parent_path());
}

} // namespace

void write_atomically(const fs::path& path,
                      const std::function<void(const fs::path& temporary)>& write) {
    std::error_code ignored; // whatever is wrong with the target shows when it is written
    if (fs::is_directory(path, ignored))
        throw Error(path.string(), "", "is a directory, not a file");
    const bool stream = is_stream(path);
    const fs::path target =
        fs::is_symlink(path, ignored) && !stream ? fs::weakly_canonical(path, ignored) : path;
    const fs::path temporary =
        temporary_in(stream ? fs::temp_directory_path(ignored) : target.parent_path(), target);
    try {
        write(temporary);
        if (!stream) return replace(target, temporary);
        copy_into(temporary, path);
        fs::remove(temporary, ignored);
    } catch (const fs::filesystem_error& error) {
        fs::remove(temporary, ignored);
        throw Error(path.string(), "", "cannot write: " + error.code().message());
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
