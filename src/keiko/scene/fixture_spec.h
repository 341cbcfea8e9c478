#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/criteria_preset.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace KEIKO_API keiko {

/// Tolerance of one layer of two pictures.
struct LayerTolerance {
    double relative = 0; ///< share of the larger of the two values
    double absolute = 0; ///< in the layer's unit; added to the relative part
    double allowed = 0;  ///< share of the compared pixels that may be farther apart
    double hard = 0;     ///< tolerances that no pixel may be apart; at least 1

    bool operator==(const LayerTolerance&) const = default;
};

/// Tolerances of two pictures.
struct FilmTolerance {
    LayerTolerance color{2e-3, 1e-2, 2e-3, 100};      ///< cd/m2, the channel that differs most
    LayerTolerance normal{0, 0.01, 2e-3, 100};        ///< degrees between the normals
    LayerTolerance depth{1e-6, 1e-3, 2e-3, 100};      ///< mm
    LayerTolerance uv{0, 1e-5, 2e-3, 100};            ///< patch parameters
    LayerTolerance c_plane_uv{1e-5, 0.1, 5e-3, 1000}; ///< mm on the C-plane
    double flips = 2e-3; ///< share of the pixels whose first surface may be another

    bool operator==(const FilmTolerance&) const = default;
};

/// Quantity that a metric states.
enum class Quantity {
    count,     ///< of faces, seams, ...
    verdict,   ///< "pass", "undecided" or "fail"
    place,     ///< mm, a coordinate
    length,    ///< mm
    area,      ///< mm2
    direction, ///< a component of a mean unit vector
    gap,       ///< mm
    angle,     ///< degrees
    curvature, ///< mismatch across a seam: share of 1, or 1/mm where nearly flat
    slope,     ///< degrees, of the curvature's slope
    line,      ///< mm of reflection lines
    share      ///< of 1
};

constexpr std::size_t quantity_count = 12; ///< number of values of Quantity

/// "gap"
std::string_view name_of(Quantity quantity);
/// "mm", "deg", ...; empty for what has none.
std::string_view unit_of(Quantity quantity);
/// Throws Error for a name that is no quantity.
Quantity quantity_by_name(std::string_view name);

/// A number or a word that a fixture is guarded by.
struct Metric {
    std::string check; ///< "shape", "seams" or "lines"
    std::string name;  ///< unique within the check, e.g. "face 3 (roof): area"
    /// Quantity of the number, and by that its unit and tolerance.
    Quantity quantity = Quantity::count;
    std::variant<double, std::string> value; ///< a word for verdicts only

    bool operator==(const Metric&) const = default;
};

/// Tolerance of two numbers: `absolute` + `relative` times the larger of their sizes.
struct MetricTolerance {
    double absolute = 0, relative = 0; ///< in the quantity's unit, and as a share of 1

    bool operator==(const MetricTolerance&) const = default;
};

/// Tolerance of each quantity. The defaults leave room for another compiler or processor, not for
/// another shape: an inner control point moved by 10 um shows (docs/regression.md).
struct MetricTolerances {
    /// By Quantity.
    std::array<MetricTolerance, quantity_count> each{{{0, 0},
                                                      {0, 0},
                                                      {1e-6, 1e-12},
                                                      {1e-6, 1e-9},
                                                      {1e-6, 1e-9},
                                                      {1e-9, 0},
                                                      {1e-5, 0},
                                                      {1e-4, 0},
                                                      {1e-6, 1e-4},
                                                      {1e-3, 0},
                                                      {0.1, 1e-3},
                                                      {1e-6, 0}}};

    /// Tolerance of a quantity.
    const MetricTolerance& operator[](Quantity quantity) const {
        return each[static_cast<std::size_t>(quantity)];
    }
    /// Tolerance of a quantity, to be changed.
    MetricTolerance& operator[](Quantity quantity) {
        return each[static_cast<std::size_t>(quantity)];
    }

    bool operator==(const MetricTolerances&) const = default;
};

/// Parts of a fixture that are held against its baseline.
struct FixtureChecks {
    bool shape = true;    ///< area, centre, direction and borders of every face
    bool seams = true;    ///< every seam: length, gap, angle, curvature, verdicts
    bool lines = true;    ///< length of every lamp's reflection line, by view
    bool pictures = true; ///< every view: colour and layers

    bool operator==(const FixtureChecks&) const = default;
};

/// A fixture file's content (keiko-fixture/1), every path resolved: a body and what is guarded.
struct FixtureSpec {
    std::string name;                          ///< of the file, without its extension
    std::filesystem::path file;                ///< path of the fixture file
    std::vector<std::filesystem::path> models; ///< files of one body, or one scene file
    std::optional<std::string> material;       ///< of models that no scene paints
    std::vector<std::string> views;            ///< names; empty: the scene's own
    std::optional<std::filesystem::path> rig;  ///< none: the scene's own, or else placed
    CriteriaPreset preset;                     ///< that seams are judged by
    double join = 0.5;                         ///< mm
    int width = 96, height = 54;               ///< pixels
    std::vector<std::string> layers;           ///< of the pictures, besides the colour
    bool shadows = false;                      ///< bodies cast shadows in the pictures
    FixtureChecks checks;                      ///< parts that are held against the baseline
    MetricTolerances metric_tolerance;         ///< of the numbers
    FilmTolerance film_tolerance;              ///< of the pictures
};

/// The layers that a fixture may request: the AOVs that pictures are compared by.
inline const std::vector<std::string> fixture_layers{"normal", "face", "depth", "uv", "c_plane_uv"};

} // namespace keiko
