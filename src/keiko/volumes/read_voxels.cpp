#include "keiko/volumes/read_voxels.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/film/image_file.h"
#include "keiko/volumes/voxel_filters.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace keiko {
namespace {

/// Voxels as stored: 1 or 3 channels a node.
struct Stored {
    std::array<int, 3> nodes{};
    int channels = 1;
    std::vector<float> values{};
};

std::string text_of(int wide, int deep) {
    return std::to_string(wide) + " x " + std::to_string(deep);
}

/// Adds a picture as the next layer; of grey ones the first channel, else red, green and blue.
void add_slice(const std::filesystem::path& path, Stored& stored) {
    const Image picture = read_image(path).image;
    const int channels = picture.channels >= 3 ? 3 : 1;
    if (picture.width < 2 || picture.height < 2)
        throw Error(path.string(), "", "a slice must have at least 2 x 2 pixels");
    if (stored.nodes[2]++ == 0) {
        stored.nodes = {picture.width, picture.height, 1};
        stored.channels = channels;
    }
    if (picture.width != stored.nodes[0] || picture.height != stored.nodes[1])
        throw Error(path.string(), "",
                    "has " + text_of(picture.width, picture.height) + " pixels, the first slice " +
                        text_of(stored.nodes[0], stored.nodes[1]));
    if (channels != stored.channels)
        throw Error(path.string(), "", "one slice is in colour, another is not");
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            stored.values.insert(stored.values.end(), picture.pixel(x, y),
                                 picture.pixel(x, y) + channels);
}

Stored slices_of(const VoxelFiles& files) {
    Stored stored;
    for (const std::filesystem::path& slice : files.slices) {
        check_stop();
        add_slice(slice, stored);
    }
    return stored;
}

/// The number whose bytes begin at `bytes`.
template <class Number>
Number number_at(const char* bytes, bool big_endian) {
    using Bits =
        std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                           std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint32_t>>;
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) {
        const std::size_t byte = big_endian ? i : sizeof(Bits) - 1 - i;
        bits = static_cast<Bits>(bits << 8U | static_cast<unsigned char>(bytes[byte]));
    }
    return std::bit_cast<Number>(bits);
}

/// Values of a raw file; whole numbers as shares of the largest one.
template <class Number>
std::vector<float> numbers_of(const std::string& bytes, bool big_endian) {
    std::vector<float> values;
    values.reserve(bytes.size() / sizeof(Number));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number)) {
        const auto number = static_cast<float>(number_at<Number>(&bytes[at], big_endian));
        values.push_back(std::is_floating_point_v<Number>
                             ? number
                             : number / static_cast<float>(std::numeric_limits<Number>::max()));
    }
    return values;
}

std::uintmax_t bytes_of(VoxelFiles::Type type) {
    return type == VoxelFiles::Type::uint8 ? 1 : type == VoxelFiles::Type::uint16 ? 2 : 4;
}

Stored raw_of(const VoxelFiles& files) {
    std::uintmax_t expected = bytes_of(files.type) * static_cast<unsigned>(files.channels);
    for (const int count : files.nodes) expected *= static_cast<unsigned>(count);
    const std::uintmax_t size = std::filesystem::file_size(files.raw);
    if (size != expected)
        throw Error(files.raw.string(), "",
                    "has " + std::to_string(size) + " bytes, but " + files.header.string() +
                        " states " + std::to_string(expected));
    const std::string bytes = read_file(files.raw);
    const bool big = files.big_endian;
    Stored stored{files.nodes, files.channels};
    stored.values = files.type == VoxelFiles::Type::uint8    ? numbers_of<std::uint8_t>(bytes, big)
                    : files.type == VoxelFiles::Type::uint16 ? numbers_of<std::uint16_t>(bytes, big)
                                                             : numbers_of<float>(bytes, big);
    return stored;
}

std::string name_of(const VoxelFiles& files) {
    return files.raw.empty() ? files.header.string() : files.raw.string();
}

void require_finite(const VoxelFiles& files, const std::vector<float>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw Error(name_of(files), "",
                        "value " + std::to_string(i + 1) + " is not a finite number");
}

/// Luminances of colours, three channels each.
std::vector<float> luminances_of(const std::vector<float>& colors) {
    std::vector<float> values;
    for (std::size_t i = 0; i < colors.size(); i += 3)
        values.push_back(
            static_cast<float>(luminance(Rgb(colors[i], colors[i + 1], colors[i + 2]))));
    return values;
}

} // namespace

VoxelGrid read_voxels(const VoxelFiles& files, std::span<const VoxelFilter> filters,
                      const Job& job) {
    Stored stored = files.slices.empty() ? raw_of(files) : slices_of(files);
    require_finite(files, stored.values);
    const bool colored = stored.channels == 3;
    std::vector<float> values = colored ? luminances_of(stored.values) : std::move(stored.values);
    try {
        for (const VoxelFilter& filter : filters)
            values = filtered(filter, std::move(values), stored.nodes, files.spacing, job);
    } catch (const FieldError& e) {
        throw Error(name_of(files), e.field(), e.reason());
    }
    return {stored.nodes, std::move(values),
            colored ? std::move(stored.values) : std::vector<float>()};
}

} // namespace keiko
