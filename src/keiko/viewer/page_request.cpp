#include "keiko/viewer/page_request.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <cstdint>

namespace keiko::viewer {
namespace {

/// Most pixels of an answer: 256 MB of a deep buffer, and a still of 4096 x 2048.
constexpr std::int64_t most_pixels = 1 << 23;

} // namespace

std::string client_of(const HttpRequest& request) {
    constexpr std::size_t longest = 64;
    std::string name = request.header("x-keiko-client");
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-';
    });
    if (name.size() > longest || !plain)
        throw Error("", "X-Keiko-Client", "must be up to 64 letters, digits and hyphens");
    return name;
}

ViewRequest request_of(const HttpRequest& request) {
    ViewRequest wanted = parse_view_request(request.body);
    if (!wanted.camera) return wanted;
    const auto pixels = static_cast<std::int64_t>(wanted.camera->width) * wanted.camera->height;
    if (pixels > most_pixels)
        throw Error("request", "camera",
                    "has a size of more than " + std::to_string(most_pixels) + " pixels");
    return wanted;
}

} // namespace keiko::viewer
