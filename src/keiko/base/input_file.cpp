#include "keiko/base/input_file.h"

#include "keiko/base/error.h"
#include "keiko/base/job.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// A regular file open for reading. Opening it never waits, whatever it has become meanwhile.
class OpenFile {
public:
    /// Throws Error for what is no regular file with content.
    explicit OpenFile(const fs::path& path)
        : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        if (descriptor_ < 0) throw missing_or_unreadable(errno);
        struct stat status {};
        const int failure = fstat(descriptor_, &status) == 0 ? 0 : errno;
        if (const std::string reason = failure ? std::strerror(failure) : fault_of(status);
            !reason.empty()) {
            close(descriptor_);
            throw Error(path.string(), "", reason);
        }
        size_ = static_cast<std::uintmax_t>(status.st_size);
    }
    ~OpenFile() { close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::string content(std::uintmax_t most) const {
        if (size_ > most)
            throw Error(
                path_.string(), "",
                "has " + std::to_string(size_) + " bytes; a text may have " + std::to_string(most));
        std::string text;
        std::array<char, 1 << 16> buffer;
        for (;;) {
            check_stop();
            const ssize_t count = read(descriptor_, buffer.data(), buffer.size());
            if (count == 0) return text;
            if (count > 0)
                text.append(buffer.data(), static_cast<std::size_t>(count));
            else if (errno != EINTR)
                throw Error(path_.string(), "",
                            std::string("cannot read: ") + std::strerror(errno));
        }
    }

private:
    Error missing_or_unreadable(int code) const {
        if (code == ENOENT) return {path_.string(), "", "no such file"};
        if (code == EACCES) return {path_.string(), "", "cannot read: permission denied"};
        if (code == ENXIO) return {path_.string(), "", "is a device, not a file"};
        return {path_.string(), "", std::string("cannot read: ") + std::strerror(code)};
    }

    /// Pipes and some devices never end, and a file is read more than once.
    static std::string fault_of(const struct stat& status) {
        if (S_ISDIR(status.st_mode)) return "is a directory, not a file";
        if (S_ISFIFO(status.st_mode)) return "is a pipe, not a file: save what comes out of it";
        if (!S_ISREG(status.st_mode)) return "is a device, not a file";
        return status.st_size == 0 ? "the file is empty" : "";
    }

    fs::path path_;
    int descriptor_;
    std::uintmax_t size_ = 0; ///< bytes, when it was opened
};

} // namespace

void require_readable_file(const fs::path& path) {
    const OpenFile file(path);
}

std::string read_file(const fs::path& path, std::uintmax_t most) {
    return OpenFile(path).content(most);
}

std::string without_byte_order_mark(std::string text, const fs::path& path) {
    using namespace std::string_view_literals;
    for (const std::string_view mark : {"\xff\xfe"sv, "\xfe\xff"sv, "\0\0\xfe\xff"sv})
        if (text.starts_with(mark))
            throw Error(path.string(), "", "is text in UTF-16 or UTF-32: save it as UTF-8");
    constexpr std::string_view utf8 = "\xef\xbb\xbf";
    if (text.starts_with(utf8)) text.erase(0, utf8.size());
    return text;
}

std::string read_text_file(const fs::path& path) {
    return without_byte_order_mark(read_file(path, largest_text), path);
}

} // namespace keiko
