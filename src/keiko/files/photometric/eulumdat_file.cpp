#include "keiko/base/text.h"
#include "keiko/files/photometric/luminaire_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr std::size_t most_planes = 721, most_angles = 1801, most_lamp_sets = 20;
constexpr double lumens_of_unit = 1000; ///< intensities are in cd/klm

/// A text of one field a line.
class EulumdatLines {
public:
    EulumdatLines(std::string_view text, const std::filesystem::path& source)
        : text_(text), source_(source) {}

    PhotometricPlace place() const { return {source_, line_}; }

    std::string_view text(const char* wanted) {
        ++line_;
        if (text_.empty()) place().fail(std::string("the file ends before ") + wanted);
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        const std::string_view field = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        const std::size_t begin = field.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return {};
        return field.substr(begin, field.find_last_not_of(blanks) - begin + 1);
    }
    void skip(int lines, const char* wanted) {
        for (int i = 0; i < lines; ++i) text(wanted);
    }
    /// With a decimal point or comma.
    double number(const char* wanted) {
        const std::string field = with_point(wanted);
        return place().number(field, wanted);
    }
    /// Number on a line that may hold anything else.
    std::optional<double> number_if_any(const char* wanted) {
        return photometric_number(with_point(wanted));
    }
    double not_negative(const char* wanted) {
        const double value = number(wanted);
        if (!(value >= 0)) place().fail(std::string(wanted) + " must not be negative");
        return value;
    }
    std::size_t whole(std::size_t least, std::size_t most, const char* wanted) {
        const double value = number(wanted);
        if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
            value != std::floor(value))
            place().fail(std::string(wanted) + " must be a whole number from " +
                         std::to_string(least) + " to " + std::to_string(most));
        return static_cast<std::size_t>(value);
    }
    std::vector<double> angles(std::size_t n, double high, const char* wanted) {
        std::vector<double> degrees;
        for (std::size_t i = 0; i < n; ++i) degrees.push_back(number(wanted));
        require_ascending(place(), degrees, 0, high, wanted);
        return degrees;
    }
    void expect_end() {
        while (!text_.empty())
            if (const auto field = text("the end"); !field.empty())
                place().fail("more lines than the counts say");
    }

private:
    static constexpr std::string_view blanks = " \t\r\x1a";

    std::string with_point(const char* wanted) {
        std::string field(text(wanted));
        std::replace(field.begin(), field.end(), ',', '.');
        return field;
    }

    std::string_view text_;
    const std::filesystem::path& source_;
    std::size_t line_ = 0;
};

/// mm: the length lies along C90, the width, 0 for a disc, along C0.
Vec3 opening_of(EulumdatLines& in) {
    const double length = in.not_negative("the luminous area's length");
    const double width = in.not_negative("the luminous area's width");
    double height = 0;
    for (int side = 0; side < 4; ++side)
        height = std::max(height, in.not_negative("the luminous area's height"));
    return {width > 0 ? width : length, length, height};
}

/// The downward flux fraction and the light output ratio, both in percent. A ratio of 0 states
/// neither; what is no number states nothing.
StatedFlux stated_flux_of(EulumdatLines& in) {
    const std::optional<double> downward = in.number_if_any("the downward flux fraction");
    const std::optional<double> ratio = in.number_if_any("the light output ratio");
    if (!ratio || !(*ratio > 0)) return {};
    StatedFlux stated{.output_ratio = *ratio / 100};
    if (downward && *downward >= 0) stated.downward_share = *downward / 100;
    return stated;
}

/// Flux of the first set of lamps.
struct LampSet {
    double flux = 0;       ///< lm
    bool absolute = false; ///< the flux is that of the luminaire
};

LampSet first_lamp_set(EulumdatLines& in) {
    const std::size_t sets = in.whole(1, most_lamp_sets, "the number of lamp sets");
    LampSet first;
    for (std::size_t i = 0; i < sets; ++i) {
        const double lamps = in.number("the number of lamps");
        in.text("the kind of lamp");
        const double of_set = in.not_negative("the lamps' luminous flux");
        in.skip(3, "the lamps' colour, rendering and power");
        if (i == 0) first = {of_set, lamps < 0};
    }
    return first;
}

/// The planes of a table, and what the file's own, in its order, stand for.
struct Planes {
    std::vector<double> degrees;
    PlaneSymmetry symmetry;
    bool backwards = false; ///< the file has them from the last to the first
};

/// C planes for which the file has intensities.
Planes stored_planes(const EulumdatLines& in, const std::vector<double>& all,
                     std::size_t symmetry) {
    const auto require = [&](bool fits) {
        if (!fits) in.place().fail("the C angles do not fit the file's symmetry");
    };
    const std::size_t n = all.size();
    const auto some = [&](std::size_t first, std::size_t count) {
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first),
                                   all.begin() + static_cast<std::ptrdiff_t>(first + count));
    };
    switch (symmetry) {
        case 0:
            require(n > 1 && symmetry_of_planes(all) == PlaneSymmetry::none);
            return {all, PlaneSymmetry::none};
        case 1:
            return {{0}, PlaneSymmetry::axial};
        case 2:
            require(n % 2 == 0 && all.front() == 0 && all[n / 2] == 180);
            return {some(0, n / 2 + 1), PlaneSymmetry::bilateral};
        case 4:
            require(n % 4 == 0 && all.front() == 0 && all[n / 4] == 90);
            return {some(0, n / 4 + 1), PlaneSymmetry::quadrant};
        default:
            break;
    }
    // From C270 over C0 to C90; mirrored in the plane of both, they run from 270 down to 90.
    require(n % 4 == 0 && all.front() == 0 && all[n / 4] == 90 && all[3 * n / 4] == 270);
    Planes planes{{}, PlaneSymmetry::bilateral_across, true};
    for (std::size_t i = n / 4 + 1; i-- > 0;) planes.degrees.push_back(180 - all[i]);
    for (std::size_t i = n; i-- > 3 * n / 4;) planes.degrees.push_back(540 - all[i]);
    return planes;
}

IntensityTable table_of(EulumdatLines& in, const Planes& planes, std::vector<double> gamma,
                        double factor) {
    std::vector<std::vector<double>> read(planes.degrees.size());
    for (std::vector<double>& plane : read)
        for (std::size_t i = 0; i < gamma.size(); ++i)
            plane.push_back(in.not_negative("an intensity") * factor);
    if (planes.backwards) std::reverse(read.begin(), read.end());
    std::vector<double> candela;
    for (const auto& plane : read) candela.insert(candela.end(), plane.begin(), plane.end());
    return {std::move(gamma), planes.degrees, std::move(candela), planes.symmetry};
}

} // namespace

PhotometricWeb parse_eulumdat(std::string_view text, const std::filesystem::path& source) {
    EulumdatLines in(text, source);
    in.skip(2, "the maker and the kind of luminaire");
    const std::size_t symmetry = in.whole(0, 4, "the symmetry");
    const std::size_t planes = in.whole(1, most_planes, "the number of C planes");
    in.text("the distance of C planes");
    const std::size_t angles = in.whole(2, most_angles, "the number of gamma angles");
    in.skip(2, "the distance of gamma angles and the report");
    std::string name = one_line(in.text("the luminaire's name"));
    in.skip(6, "the luminaire's size");
    const Vec3 opening = opening_of(in);
    StatedFlux stated = stated_flux_of(in);
    const double factor = in.number("the conversion factor");
    if (!(factor > 0)) in.place().fail("the conversion factor must be above 0");
    in.text("the tilt");
    const LampSet lamps = first_lamp_set(in);
    in.skip(10, "the direct ratios");
    const std::vector<double> all = in.angles(planes, 360, "C angles");
    const Planes stored = stored_planes(in, all, symmetry);
    std::vector<double> gamma = in.angles(angles, 180, "gamma angles");
    IntensityTable table =
        table_of(in, stored, std::move(gamma), factor * lamps.flux / lumens_of_unit);
    in.expect_end();
    stated.reference = lamps.flux;
    return {.type = PhotometricType::c,
            .candela = std::move(table),
            .name = std::move(name),
            .lamp_flux = lamps.absolute ? 0 : lamps.flux,
            .opening = opening,
            .stated = stated};
}

} // namespace keiko
