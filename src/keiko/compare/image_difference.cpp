#include "keiko/compare/image_difference.h"

#include "keiko/base/error.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

std::string size_text(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
           std::to_string(image.channels);
}

double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0; // infinite depths are equal
    const double difference = std::abs(double{a} - double{b});
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

ChannelDifference channel_difference(const Image& a, const Image& b, int channel) {
    ChannelDifference result;
    double squares = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const double d = distance(a.pixel(x, y)[channel], b.pixel(x, y)[channel]);
            squares += d * d;
            if (d > result.largest) result.largest = d, result.x = x, result.y = y;
        }
    const double pixels = double(a.width) * double(a.height);
    result.root_mean_square = pixels > 0 ? std::sqrt(squares / pixels) : 0;
    return result;
}

} // namespace

std::vector<ChannelDifference> image_difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw Error("", "",
                    "pictures of " + size_text(a) + " and " + size_text(b) + " cannot be compared");
    std::vector<ChannelDifference> result;
    result.reserve(static_cast<std::size_t>(a.channels));
    for (int c = 0; c < a.channels; ++c) result.push_back(channel_difference(a, b, c));
    return result;
}

} // namespace keiko
