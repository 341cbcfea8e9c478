#include "keiko/base/input_file.h"

#include "keiko/base/error.h"

#include <fstream>
#include <iterator>
#include <string_view>

namespace keiko {
namespace fs = std::filesystem;

void require_readable_file(const fs::path& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found) throw Error(path.string(), "", "no such file");
    if (code) throw Error(path.string(), "", "cannot read: " + code.message());
    if (fs::is_directory(status)) throw Error(path.string(), "", "is a directory, not a file");
    // Some devices never end.
    if (!fs::is_regular_file(status) && !fs::is_fifo(status))
        throw Error(path.string(), "", "is a device, not a file");
    const std::ifstream in(path, std::ios::binary);
    if (!in) throw Error(path.string(), "", "cannot read: permission denied");
    if (fs::is_regular_file(status) && fs::file_size(path, code) == 0)
        throw Error(path.string(), "", "the file is empty");
}

std::string read_file(const fs::path& path) {
    require_readable_file(path);
    std::ifstream in(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(in), {}};
    if (in.bad()) throw Error(path.string(), "", "cannot read");
    return content;
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
    return without_byte_order_mark(read_file(path), path);
}

} // namespace keiko
