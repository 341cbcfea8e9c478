#include "keiko/files/photometric/luminaire_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace keiko {

namespace {

/// Products of a few numbers up to here stay finite.
constexpr double largest_number = 1e15;
/// By which the angle from the last plane to the first may be wider than the widest of the others.
constexpr double rounding = 1e-6;

/// Whether planes from 0 degrees on go all the way round: up to 360 degrees, or to one step less.
bool go_round(const std::vector<double>& degrees) {
    double widest = 0;
    for (std::size_t i = 0; i + 1 < degrees.size(); ++i)
        widest = std::max(widest, degrees[i + 1] - degrees[i]);
    return 360 - degrees.back() <= widest * (1 + rounding);
}

} // namespace

std::optional<double> photometric_number(std::string_view word) {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code != std::errc() || end != digits.data() + digits.size() ||
        !(std::abs(value) <= largest_number))
        return std::nullopt;
    return value;
}

void PhotometricPlace::fail(const std::string& reason) const {
    throw Error(source.string(), std::to_string(line), reason);
}

double PhotometricPlace::number(std::string_view word, const char* wanted) const {
    const std::optional<double> value = photometric_number(word);
    if (!value) fail(std::string("expected ") + wanted + ", found " + in_quotes(word));
    return *value;
}

void require_ascending(const PhotometricPlace& place, const std::vector<double>& degrees,
                       double low, double high, const char* wanted) {
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (!(degrees[i] >= low && degrees[i] <= high))
            place.fail(std::string(wanted) + " must be from " + std::to_string(std::lround(low)) +
                       " to " + std::to_string(std::lround(high)) + " degrees");
        if (i > 0 && !(degrees[i] > degrees[i - 1]))
            place.fail(std::string(wanted) + " must ascend");
    }
}

std::optional<PlaneSymmetry> symmetry_of_planes(const std::vector<double>& degrees) {
    const double first = degrees.front(), last = degrees.back();
    if (degrees.size() == 1) return PlaneSymmetry::axial;
    if (first == 90 && last == 270) return PlaneSymmetry::bilateral_across;
    if (first != 0) return std::nullopt;
    if (last == 90) return PlaneSymmetry::quadrant;
    if (last == 180) return PlaneSymmetry::bilateral;
    if (go_round(degrees)) return PlaneSymmetry::none;
    return std::nullopt;
}

namespace {

std::string lower_extension(const std::filesystem::path& path) {
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

} // namespace

bool is_luminaire_file(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".ies" || extension == ".ldt";
}

PhotometricWeb read_luminaire(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    return lower_extension(path) == ".ldt" ? parse_eulumdat(text, path) : parse_ies(text, path);
}

} // namespace keiko
