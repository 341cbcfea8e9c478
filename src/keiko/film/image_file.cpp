#include "keiko/film/image_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/base/text.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace keiko {
namespace {

const std::vector<std::string> color_names{"R", "G", "B"};
const std::vector<std::string> alpha_name{"A"};

std::vector<std::string> layer_names(Aov aov) {
    std::vector<std::string> names = channel_names(aov);
    const std::string prefix = std::string(name_of(aov)) + ".";
    for (std::string& name : names) name.insert(0, prefix);
    return names;
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Collects buffers, then interleaves them.
class Channels {
public:
    void add(const Image& image, const std::vector<std::string>& names) {
        const Image& first = parts_.empty() ? image : *parts_.front();
        if (image.width != first.width || image.height != first.height ||
            static_cast<std::size_t>(image.channels) != names.size())
            throw Error("", names.front(), "the buffer does not have the picture's size");
        parts_.push_back(&image);
        names_.insert(names_.end(), names.begin(), names.end());
    }

    NamedImage interleaved() const {
        const Image& first = *parts_.front();
        NamedImage all{Image(first.width, first.height, static_cast<int>(names_.size())), names_};
        float* out = all.image.values.data();
        for (std::size_t i = 0; i < pixel_count(first); ++i) {
            for (const Image* part : parts_) {
                const auto n = static_cast<std::size_t>(part->channels);
                out = std::copy_n(part->values.data() + i * n, n, out);
            }
        }
        return all;
    }

private:
    std::vector<const Image*> parts_;
    std::vector<std::string> names_;
};

/// The image of the channels with these names, or one without pixels if one is missing.
Image taken(const NamedImage& from, const std::vector<std::string>& names) {
    std::vector<std::size_t> at;
    for (const std::string& name : names) {
        const auto found = std::find(from.channel_names.begin(), from.channel_names.end(), name);
        if (found == from.channel_names.end()) return {};
        at.push_back(static_cast<std::size_t>(found - from.channel_names.begin()));
    }
    Image image(from.image.width, from.image.height, static_cast<int>(names.size()));
    float* out = image.values.data();
    const auto stride = static_cast<std::size_t>(from.image.channels);
    for (std::size_t i = 0; i < pixel_count(image); ++i)
        for (const std::size_t channel : at) *out++ = from.image.values[i * stride + channel];
    return image;
}

} // namespace

NamedImage channels_of(const Film& film) {
    Channels channels;
    channels.add(film.color, color_names);
    if (film.alpha.channels > 0) channels.add(film.alpha, alpha_name);
    for (const auto& [aov, image] : film.aovs) channels.add(image, layer_names(aov));
    return channels.interleaved();
}

Film film_of(const NamedImage& channels) {
    Film film{taken(channels, color_names), taken(channels, alpha_name), {}};
    if (film.color.channels == 0) throw Error("", "", "the picture has no channels R, G and B");
    for (const Aov aov : every_aov()) {
        Image layer = taken(channels, layer_names(aov));
        if (layer.channels > 0) film.aovs.emplace(aov, std::move(layer));
    }
    return film;
}

std::map<std::string, NamedImage> layers_of(const Film& film) {
    std::map<std::string, NamedImage> layers;
    layers["color"] = channels_of({film.color, film.alpha, {}});
    for (const auto& [aov, image] : film.aovs)
        layers[std::string(name_of(aov))] = {image, layer_names(aov)};
    return layers;
}

Film film_of(const std::map<std::string, NamedImage>& layers) {
    const auto color = layers.find("color");
    if (color == layers.end()) throw Error("", "", "the picture has no layer 'color'");
    Film film = film_of(color->second);
    for (const auto& [name, layer] : layers) {
        if (layer.image.width != film.color.width || layer.image.height != film.color.height)
            throw Error("", name, "the layer does not have the picture's size");
        if (name == "color") continue;
        const Aov aov = aov_by_name(name);
        Image image = taken(layer, layer_names(aov));
        if (image.channels == 0) throw Error("", name, "the layer lacks one of its channels");
        film.aovs.emplace(aov, std::move(image));
    }
    return film;
}

namespace fs = std::filesystem;
namespace {

enum class Format { exr, png };

Format format_of(const fs::path& path) {
    const std::string extension = lower_case(path.extension().string());
    if (extension == ".exr") return Format::exr;
    if (extension == ".png") return Format::png;
    throw Error(path.string(), "",
                "cannot tell the picture's format from \"" + extension + "\"; use .exr or .png");
}

/// Bytes of a picture file that OpenImageIO writes to memory. The name that it is given is for the
/// error alone.
std::string encoded(const char* format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                    const void* pixels) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput sink(bytes);
    const auto output = OIIO::ImageOutput::create(format, &sink);
    if (!output) throw Error("", format, OIIO::geterror());
    const std::string name = std::string("picture.") + format;
    if (!output->open(name, spec) || !output->write_image(type, pixels) || !output->close())
        throw Error("", format, output->geterror());
    return {bytes.begin(), bytes.end()};
}

/// Bytes are made in memory, so that an error of the encoder leaves the disk alone.
void write_bytes(const fs::path& path, const std::function<std::string()>& encode) {
    std::string bytes;
    try {
        bytes = encode();
    } catch (const Error& error) {
        throw Error(path.string(), error.where(), error.reason());
    }
    write_text_file(path, bytes);
}

std::vector<std::uint8_t> quantised(const Image& display) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(display.values.size());
    for (const float value : display.values) {
        const float clamped = value > 0 ? std::min(value, 1.0F) : 0.0F; // a NaN is 0
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * clamped)));
    }
    return bytes;
}

/// Throws Error for a picture that is too large or deep. A header may state any size; the product
/// of some is that of a small picture, modulo 2^64.
void require_size(const OIIO::ImageSpec& spec, const std::string& file) {
    constexpr int longest = 65536, most_channels = 1024;
    constexpr double most_numbers = 2147483648.0; // 8 GB
    const double numbers = static_cast<double>(spec.width) * spec.height * spec.nchannels;
    if (spec.width > longest || spec.height > longest || spec.nchannels > most_channels ||
        numbers > most_numbers)
        throw Error(file, "",
                    "is a picture of " + std::to_string(spec.width) + " x " +
                        std::to_string(spec.height) + " pixels with " +
                        std::to_string(spec.nchannels) + " channels: too large");
    if (spec.depth > 1 || spec.deep) throw Error(file, "", "has several values a pixel");
}

NamedImage picture_of(OIIO::ImageInput& input, const std::string& file) {
    const OIIO::ImageSpec& spec = input.spec();
    require_size(spec, file);
    NamedImage picture{Image(spec.width, spec.height, spec.nchannels), spec.channelnames};
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, picture.image.values.data()))
        throw Error(file, "", "cannot read the picture: " + input.geterror());
    return picture;
}

} // namespace

void require_image_extension(const fs::path& path) {
    format_of(path);
}

void write_film(const fs::path& path, const Film& film, const ToneMapping& mapping,
                bool with_alpha) {
    if (format_of(path) == Format::png) {
        write_png(path, tone_mapped(film, mapping, with_alpha));
    } else {
        write_bytes(path, [&] { return encode_exr(film); });
    }
}

void write_png(const fs::path& path, const Image& display) {
    write_bytes(path, [&] { return encode_png(display); });
}

std::string encode_png(const Image& display) {
    OIIO::ImageSpec spec(display.width, display.height, display.channels, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("png:compressionLevel", 6);
    return encoded("png", spec, OIIO::TypeUInt8, quantised(display).data());
}

std::string encode_exr(const Film& film) {
    return encode_exr(channels_of(film));
}

std::string encode_exr(const NamedImage& all) {
    OIIO::ImageSpec spec(all.image.width, all.image.height, all.image.channels, OIIO::TypeFloat);
    spec.channelnames = all.channel_names;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "1970:01:01 00:00:00"); // or OpenImageIO writes the time of day
    return encoded("exr", spec, OIIO::TypeFloat, all.image.values.data());
}

NamedImage decode_exr(std::string_view bytes, const std::string& file) {
    OIIO::Filesystem::IOMemReader source(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::open("picture.exr", nullptr, &source);
    if (!input) throw Error(file, "", "cannot read the picture: " + OIIO::geterror());
    return picture_of(*input, file);
}

NamedImage read_image(const fs::path& path) {
    require_readable_file(path);
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
    if (!input) {
        OIIO::geterror(); // in words of the library's developers
        throw Error(path.string(), "", "is no picture of a kind that can be read");
    }
    return picture_of(*input, path.string());
}

Film read_film(const fs::path& path) {
    try {
        return film_of(read_image(path));
    } catch (const Error& error) {
        throw Error(path.string(), error.where(), error.reason());
    }
}

} // namespace keiko
