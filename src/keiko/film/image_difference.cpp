#include "keiko/film/image_difference.h"

#include "keiko/base/error.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace algorithm = OIIO::ImageBufAlgo;
namespace {

constexpr float largest_float = std::numeric_limits<float>::max();
constexpr int one_thread = 1;

/// The pixels themselves, as OpenImageIO sees them; it only reads what is given as const.
OIIO::ImageBuf view_of(const Image& image) {
    const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeFloat);
    return {spec, const_cast<float*>(image.values.data())};
}

Image image_of(const OIIO::ImageBuf& buffer) {
    Image image(buffer.spec().width, buffer.spec().height, buffer.nchannels());
    if (buffer.has_error() ||
        !buffer.get_pixels(OIIO::ROI::All(), OIIO::TypeFloat, image.values.data()))
        throw Error("", "", "pictures cannot be compared: " + buffer.geterror());
    return image;
}

OIIO::ImageBuf finite(const OIIO::ImageBuf& buffer) {
    return algorithm::min(buffer, largest_float, {}, one_thread);
}

} // namespace

Image largest_difference(const Image& a, const Image& b) {
    const OIIO::ImageBuf difference = algorithm::absdiff(view_of(a), view_of(b), {}, one_thread);
    return image_of(algorithm::maxchan(difference, {}, one_thread));
}

Image largest_size(const Image& a, const Image& b) {
    const OIIO::ImageBuf size =
        algorithm::max(algorithm::abs(view_of(a), {}, one_thread),
                       algorithm::abs(view_of(b), {}, one_thread), {}, one_thread);
    return image_of(finite(algorithm::maxchan(size, {}, one_thread)));
}

Image in_tolerances(const Image& distance, const Image& size, double absolute, double relative) {
    const OIIO::ImageBuf tolerance = algorithm::mad(view_of(size), static_cast<float>(relative),
                                                    static_cast<float>(absolute), {}, one_thread);
    // OpenImageIO takes a quotient by 0 for 0.
    const OIIO::ImageBuf divisor =
        algorithm::max(finite(tolerance), std::numeric_limits<float>::min(), {}, one_thread);
    return image_of(algorithm::div(view_of(distance), divisor, {}, one_thread));
}

Image larger_of(const Image& a, const Image& b) {
    return image_of(algorithm::max(view_of(a), view_of(b), {}, one_thread));
}

PixelStatistics pixel_statistics(const Image& channel, double limit) {
    // Infinite values are not counted by OpenImageIO in every case.
    const OIIO::ImageBuf bounded = finite(view_of(channel));
    const OIIO::ImageBuf nothing = algorithm::zero(bounded.roi(), one_thread);
    const auto threshold = static_cast<float>(limit);
    const algorithm::CompareResults found =
        algorithm::compare(bounded, nothing, threshold, threshold, OIIO::ROI::All(), one_thread);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool infinite = found.maxerror >= double{largest_float};
    return {infinite ? infinity : found.maxerror, found.maxx, found.maxy,
            infinite ? infinity : found.rms_error, static_cast<std::size_t>(found.nfail)};
}

namespace {

Rgb color_of(float excess) {
    constexpr double darkest = 0.08, lightest = 0.45, deepest_red = 100;
    if (std::isinf(excess)) return {1, 0, 1};
    const double x = excess;
    if (!(x > 1)) return Rgb(darkest + (lightest - darkest) * std::max(x, 0.0));
    const double depth = std::min(std::log(x) / std::log(deepest_red), 1.0);
    return {1, 0.9 * (1 - depth), 0};
}

} // namespace

Image difference_picture(const Image& excess) {
    Image picture(excess.width, excess.height, 3);
    float* out = picture.values.data();
    for (const float value : excess.values) {
        const Rgb color = color_of(value);
        for (const double channel : {color.r, color.g, color.b})
            *out++ = static_cast<float>(channel);
    }
    return picture;
}

} // namespace keiko
