#include "keiko/film/film_channels.h"

#include "keiko/base/error.h"

#include <algorithm>

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

} // namespace keiko
