#pragma once

#include "keiko/light/fog/medium.h"
#include "keiko/math/affine.h"
#include "keiko/math/rgb.h"

#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace keiko {

/// Files of the values of voxels, and the places of their nodes (keiko-voxels/1).
struct VoxelFiles {
    /// Type of a value of a raw file. Whole numbers count as shares of the largest one.
    enum class Type { uint8, uint16, float32 };

    std::filesystem::path header{};              ///< that describes them
    std::vector<std::filesystem::path> slices{}; ///< pictures, by rising z; empty: `raw`
    std::filesystem::path raw{};                 ///< values alone, x fastest, then y
    std::array<int, 3> nodes{};                  ///< of a raw file, along x, y and z
    int channels = 1;                            ///< of a raw file: 1, or 3 of coloured voxels
    Type type = Type::uint8;                     ///< of a raw file
    bool big_endian = false;                     ///< order of the bytes of a raw file
    Vec3 origin{0};                              ///< mm, the first node
    Vec3 spacing{1};                             ///< mm between nodes, along x, y and z

    bool operator==(const VoxelFiles&) const = default;
};

/// Median of the values in a cube of nodes, which removes noise and keeps edges.
struct MedianFilter {
    int radius = 1; ///< nodes from the middle of the cube to its faces

    bool operator==(const MedianFilter&) const = default;
};

/// Mean of the values, weighted by a Gaussian of the distance.
struct GaussFilter {
    double width = 1; ///< mm, its standard deviation

    bool operator==(const GaussFilter&) const = default;
};

/// Preprocessing of the values of voxels.
using VoxelFilter = std::variant<MedianFilter, GaussFilter>;

/// Surface of one value, with an opacity in proportion to the distance to it [Levoy1988, eq. 3].
struct ContourOpacity {
    double value = 0.5;   ///< of the surface
    double thickness = 2; ///< steps between nodes on either side of it
    double opacity = 0.9; ///< of a layer one step thick on the surface itself, below 1

    bool operator==(const ContourOpacity&) const = default;
};

/// Opacity in proportion to the gradient, within a range of values [Levoy1988].
struct RegionOpacity {
    double low = 0, high = 1;                     ///< range of the values
    double opacity_low = 0.5, opacity_high = 0.5; ///< at its ends, times the gradient per step

    bool operator==(const RegionOpacity&) const = default;
};

/// Function of the value, in straight lines between points of rising value and constant beyond.
template <class Result>
struct ValueTable {
    std::vector<std::pair<double, Result>> points; ///< at least one

    bool operator==(const ValueTable&) const = default;

    /// Result at a value.
    Result operator()(double value) const {
        if (!(value > points.front().first)) return points.front().second;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto& [end, after] = points[i];
            if (value > end) continue;
            const auto& [begin, before] = points[i - 1];
            return before + (after - before) * ((value - begin) / (end - begin));
        }
        return points.back().second;
    }
};

/// Local reflection of volumes: Phong's sum with Blinn's highlight and a depth cue
/// (docs/theory/volumes.md#shading).
struct VolumeShading {
    std::optional<Vec3> light{}; ///< direction towards the light; none: towards the viewer
    double luminance = 1000;     ///< cd/m2 that the factors below multiply
    double ambient = 0.1, diffuse = 0.6, specular = 0.3; ///< factors
    double exponent = 20;                                ///< of the highlight
    double cue = 1;            ///< part of the depth cue that does not depend on the distance
    double cue_per_length = 0; ///< 1/mm, its growth with the distance from the viewer

    bool operator==(const VolumeShading&) const = default;
};

/// Single scattering of the light of sun and sky in a volume: a cloud
/// (docs/theory/volumes.md#clouds).
struct VolumeScattering {
    Rgb albedo{0.9};       ///< share of the extinction that is scattering
    PhaseFunction phase{}; ///< uniform by default
    /// True if light reaches each place through a uniform medium of the mean extinction of the
    /// nodes, instead of the voxels.
    bool uniform_leg = false;

    bool operator==(const VolumeScattering&) const = default;
};

/// Voxels of a scene and how they look.
struct VolumeSpec {
    VoxelFiles voxels{};
    Affine placement{};                           ///< of the voxels in the scene; keeps angles
    std::vector<VoxelFilter> filters{};           ///< in their order
    ValueTable<double> extinction{};              ///< 1/m by value; without points: none
    std::vector<ContourOpacity> contours{};       ///< opacities of several add up as layers do
    std::vector<RegionOpacity> regions{};         ///< the same
    ValueTable<Rgb> color{{{0, Rgb(1)}}};         ///< by value, factor of what is reflected
    ValueTable<Rgb> emits{{{0, Rgb(0)}}};         ///< cd/m2 by value
    std::optional<VolumeShading> shading{};       ///< none: it reflects no light of its own lamp
    std::optional<VolumeScattering> scattering{}; ///< none: sun and sky do not light it
    double step = 0;                              ///< mm between samples; 0: chosen
};

} // namespace keiko
