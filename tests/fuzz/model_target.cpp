// the serialised model
#include "keiko/files/model/byte_stream.h"

#include "tests/fuzz/sound_model.h"

namespace {

using namespace keiko;

/// A right header before any payload: no mutation would ever hit its checksum.
std::string with_header(std::string_view payload) {
    constexpr std::size_t magic_and_version = 8 + 4;
    std::string bytes = serialize({}).substr(0, magic_and_version);
    ByteWriter rest([&](std::string_view piece) { bytes += piece; });
    rest.put(checksum(payload));
    rest.put(payload);
    rest.flush();
    return bytes;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::accepts([&] { fuzz::require_sound(deserialize(bytes, "model")); });
    fuzz::accepts([&] { fuzz::require_sound(deserialize(with_header(bytes), "model")); });
    return 0;
}
