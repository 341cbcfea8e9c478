#include "keiko/files/scene/volume_table.h"

#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/scene/transform_table.h"
#include "keiko/files/scene/voxel_header.h"
#include "keiko/files/toml/toml_reader.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr TomlLimits values{.low = -1e9, .high = 1e9};   ///< of voxels
constexpr TomlLimits extinctions{.low = 0, .high = 1e9}; ///< 1/m
constexpr TomlLimits factors{.low = 0, .high = 1000};    ///< of light
constexpr TomlLimits below_one{.low = 0, .high = 0.9999};

VoxelFilter filter_from(const TomlTable& table) {
    const auto kind = table.required("kind", table.choice("kind", {"median", "gauss"}));
    const auto radius = table.integer("radius", 1, 5);
    const auto width = table.number("width", TomlLimits::length());
    if (kind == 0 && width) throw table.error("width", "belongs to kind = \"gauss\"");
    if (kind == 1 && radius) throw table.error("radius", "belongs to kind = \"median\"");
    table.finish();
    if (kind == 0) return MedianFilter{radius.value_or(MedianFilter().radius)};
    return GaussFilter{table.required("width", width)};
}

ContourOpacity contour_from(const TomlTable& table) {
    ContourOpacity contour;
    contour.value = table.required("value", table.number("value", values));
    contour.thickness =
        table.number("thickness", {.low = 0.01, .high = 1000}).value_or(contour.thickness);
    contour.opacity = table.number("opacity", below_one).value_or(contour.opacity);
    table.finish();
    return contour;
}

RegionOpacity region_from(const TomlTable& table) {
    RegionOpacity region;
    region.low = table.required("low", table.number("low", values));
    region.high = table.required("high", table.number("high", values));
    if (!(region.low < region.high)) throw table.error("high", "must be above low");
    region.opacity_low =
        table.number("opacity_low", TomlLimits::not_negative()).value_or(region.opacity_low);
    region.opacity_high =
        table.number("opacity_high", TomlLimits::not_negative()).value_or(region.opacity_high);
    table.finish();
    return region;
}

/// A table by value at `key`, of one number or, if `colors`, of one or three a point.
std::optional<ValueTable<Rgb>> value_table(const TomlTable& table, std::string_view key,
                                           const TomlLimits& limits, bool colors) {
    const auto lists = table.keyed_lists(key, limits);
    if (!lists) return {};
    ValueTable<Rgb> read;
    for (const auto& [value, numbers] : *lists) {
        if (numbers.size() != 1 && !(colors && numbers.size() == 3))
            throw table.error(key, colors ? "each value needs one number or three"
                                          : "each value needs one number");
        if (!read.points.empty() && !(value > read.points.back().first))
            throw table.error(key, "values must ascend");
        read.points.emplace_back(
            value, numbers.size() == 1 ? Rgb(numbers[0]) : Rgb(numbers[0], numbers[1], numbers[2]));
    }
    return read;
}

VolumeShading shading_from(const TomlTable& table) {
    VolumeShading shading;
    shading.light = table.vector("light");
    if (shading.light && !(shading.light->length() > 0))
        throw table.error("light", "must not be a zero vector");
    const auto take = [&](std::string_view key, const TomlLimits& limits, double& number) {
        number = table.number(key, limits).value_or(number);
    };
    take("luminance", TomlLimits::light(), shading.luminance);
    take("ambient", factors, shading.ambient);
    take("diffuse", factors, shading.diffuse);
    take("specular", factors, shading.specular);
    take("exponent", {.low = 1, .high = 1e6}, shading.exponent);
    if (const auto cue = table.numbers("depth_cue", 2, {.low = 0, .high = 1e9}))
        shading.cue = (*cue)[0], shading.cue_per_length = (*cue)[1];
    if (!(shading.cue > 0)) throw table.error("depth_cue", "the first number must be above 0");
    table.finish();
    return shading;
}

VolumeScattering scattering_from(const TomlTable& table) {
    VolumeScattering scattering;
    scattering.albedo = table.rgb("albedo", TomlLimits::share()).value_or(scattering.albedo);
    if (const auto phase = table.table("phase")) scattering.phase = phase_from(*phase);
    scattering.uniform_leg = table.choice("light_leg", {"voxels", "uniform"}) == 1;
    table.finish();
    return scattering;
}

void take_opacity(const TomlTable& table, VolumeSpec& volume) {
    if (const auto extinction = value_table(table, "extinction", extinctions, false))
        for (const auto& [value, grey] : extinction->points)
            volume.extinction.points.emplace_back(value, grey.g);
    for (const TomlTable& contour : table.tables("contour"))
        volume.contours.push_back(contour_from(contour));
    for (const TomlTable& region : table.tables("region"))
        volume.regions.push_back(region_from(region));
    if (volume.extinction.points.empty() && volume.contours.empty() && volume.regions.empty()) {
        table.refuse_misspelt();
        throw table.error("", "nothing makes it opaque: give extinction, contour or region");
    }
}

} // namespace

VolumeSpec volume_from(const TomlTable& table) {
    VolumeSpec volume;
    volume.voxels = read_voxel_header(table.required("file", path_from(table, "file")));
    if (const auto transform = table.table("transform"))
        volume.placement = transform_from(*transform).affine();
    for (const TomlTable& filter : table.tables("filter"))
        volume.filters.push_back(filter_from(filter));
    take_opacity(table, volume);
    if (auto color = value_table(table, "color", TomlLimits::share(), true))
        volume.color = std::move(*color);
    if (auto emits = value_table(table, "emits", TomlLimits::light(), true))
        volume.emits = std::move(*emits);
    if (const auto shading = table.table("shading")) volume.shading = shading_from(*shading);
    if (const auto scattering = table.table("scattering"))
        volume.scattering = scattering_from(*scattering);
    if (!volume.shading && !volume.scattering && !table.has("emits")) volume.shading.emplace();
    volume.step = table.number("step", TomlLimits::length()).value_or(volume.step);
    const Vec3& spacing = volume.voxels.spacing;
    const double scale = std::cbrt(std::abs(volume.placement.determinant()));
    if (volume.step > 0 && volume.step < scale * std::min({spacing.x, spacing.y, spacing.z}) / 100)
        throw table.error("step", "must be at least a hundredth of the spacing of the voxels");
    table.finish();
    return volume;
}

} // namespace keiko
