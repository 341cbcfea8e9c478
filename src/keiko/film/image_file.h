#pragma once

#include "keiko/base/export.h"
#include "keiko/film/tone_mapping.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// An image whose channels have names, as in a file: "R", "normal.X", "face.id".
struct NamedImage {
    Image image;                            ///< its pixels
    std::vector<std::string> channel_names; ///< one a channel
};

/// Throws Error, listing .exr and .png, for a path with another extension: to be called before the
/// work that fills the picture.
void require_image_extension(const std::filesystem::path& path);

/// Writes a film by the extension of `path`: .exr holds all of it in float (R, G, B, A and the
/// AOVs as layers, e.g. normal.X), untouched; .png its tone mapped colour, `with_alpha` too. The
/// bytes depend on the film alone, and no reader ever sees half a file. Throws Error.
void write_film(const std::filesystem::path& path, const Film& film,
                const ToneMapping& mapping = {}, bool with_alpha = false);

/// Writes a display picture (1, 3 or 4 channels in [0, 1]) as 8-bit PNG.
void write_png(const std::filesystem::path& path, const Image& display);

/// Bytes of the file that write_png writes, to embed it.
std::string encode_png(const Image& display);
/// Bytes of the .exr file that write_film writes, to embed it.
std::string encode_exr(const Film& film);
/// Bytes of an .exr file of 32-bit floats under their channel names.
std::string encode_exr(const NamedImage& image);

/// Reads a picture as it is stored, 8-bit values as n / 255. Throws Error.
NamedImage read_image(const std::filesystem::path& path);

/// The picture whose .exr file has these bytes. Throws Error naming `file`.
NamedImage decode_exr(std::string_view bytes, const std::string& file);

/// Reads what write_film wrote as .exr; channels of unknown layers are left out. Throws Error for
/// a file without R, G and B.
Film read_film(const std::filesystem::path& path);

/// Every buffer of a film side by side under the names a file gives them: R, G, B, A, then
/// "aov.channel". All buffers must have the size of the colour; throws Error otherwise.
NamedImage channels_of(const Film& film);

/// The film that channels_of took apart. Throws Error when R, G or B is missing; without A the
/// film has no alpha; an AOV counts when all of its channels are there.
Film film_of(const NamedImage& channels);

/// Buffers of a film by layer: "color" (R, G, B, A), then the AOVs by name.
std::map<std::string, NamedImage> layers_of(const Film& film);

/// The film that layers_of took apart, or of some of its layers. Throws Error without "color", and
/// where the layers differ in size.
Film film_of(const std::map<std::string, NamedImage>& layers);

} // namespace keiko
