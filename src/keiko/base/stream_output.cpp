#include "keiko/base/stream_output.h"

#include "keiko/base/error.h"
#include "keiko/base/stop_scope.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds rest{20}; ///< between two looks for a stop

/// A device or a pipe open for writing; no call on it waits.
class OpenStream {
public:
    explicit OpenStream(const fs::path& path) : path_(path) {
        // A pipe that nobody reads yet cannot be opened.
        while ((descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK)) < 0) {
            if (errno != ENXIO || !fs::is_fifo(path)) throw cannot_write();
            check_stop();
            std::this_thread::sleep_for(rest);
        }
    }
    ~OpenStream() { close(descriptor_); }
    OpenStream(const OpenStream&) = delete;
    OpenStream& operator=(const OpenStream&) = delete;

    void write(std::string_view bytes) const {
        while (!bytes.empty()) {
            check_stop();
            const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
            if (count >= 0)
                bytes.remove_prefix(static_cast<std::size_t>(count));
            else if (errno == EAGAIN)
                wait_for_room();
            else if (errno != EINTR)
                throw cannot_write();
        }
    }

private:
    void wait_for_room() const {
        pollfd entry{descriptor_, POLLOUT, 0};
        poll(&entry, 1, static_cast<int>(rest.count()));
    }
    Error cannot_write() const { return {path_.string(), "", "cannot write"}; }

    fs::path path_;
    int descriptor_ = -1;
};

} // namespace

void copy_into_stream(const fs::path& file, const fs::path& stream) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) throw Error(stream.string(), "", "cannot write");
    OpenStream(stream).write(bytes);
}

} // namespace keiko
