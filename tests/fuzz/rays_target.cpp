// the lines of rays that `keiko trace` reads
#include "keiko/stream/ray_lines.h"

#include "tests/fuzz/fuzz_target.h"

#include <cstring>

namespace {

using namespace keiko;

/// Contents of a stream up to its first fault.
struct Contents {
    std::vector<Ray> rays;
    std::optional<Error> fault;
};

/// Hands out a text in pieces of at most `piece` bytes.
ByteSource pieces_of(std::string_view text, std::size_t piece) {
    return [text, piece](std::span<char> to) mutable {
        const std::size_t count = std::min({to.size(), piece, text.size()});
        std::memcpy(to.data(), text.data(), count);
        text.remove_prefix(count);
        return count;
    };
}

Contents contents_of(std::string_view text, std::size_t piece) {
    RayLineReader reader(pieces_of(text, piece));
    Contents contents;
    for (RayLines lines; !contents.fault && reader.read(lines);) {
        fuzz::require(lines.first_ray == contents.rays.size(), "the reader counts the rays");
        ParsedRays parsed = rays_of(lines);
        contents.rays.insert(contents.rays.end(), parsed.rays.begin(), parsed.rays.end());
        contents.fault = std::move(parsed.fault);
    }
    return contents;
}

bool same(const Contents& a, const Contents& b) {
    if (a.fault.has_value() != b.fault.has_value()) return false;
    if (a.fault && std::strcmp(a.fault->what(), b.fault->what()) != 0) return false;
    return std::equal(a.rays.begin(), a.rays.end(), b.rays.begin(), b.rays.end(),
                      [](const Ray& p, const Ray& q) {
                          return p.origin == q.origin && p.direction == q.direction;
                      });
}

} // namespace

/// The first byte tells how large the pieces are in which the stream arrives.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text = fuzz::text_of(data, size).substr(1);
    const Contents whole = contents_of(text, text.size() + 1);
    if (whole.fault) fuzz::require_clear(*whole.fault);
    fuzz::require(same(whole, contents_of(text, data[0] + std::size_t{1})),
                  "rays do not depend on the pieces they arrive in");
    return 0;
}
