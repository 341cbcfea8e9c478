#pragma once

#include "keiko/base/export.h"
#include "keiko/math/bounds.h"
#include "keiko/math/rgb.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Colour of faces as CAD systems show it and users write it: "#c0c0c0".
struct FaceColor {
    std::array<std::uint8_t, 3> parts{}; ///< red, green and blue, sRGB [IEC61966-2-1]

    /// "#c0c0c0", in small or large letters; throws Error for anything else.
    static FaceColor parse(std::string_view text);
    /// The nearest colour to that of a face, which has linear parts from 0 to 1.
    static FaceColor of(const Rgb& linear);
    /// "#c0c0c0"
    std::string text() const;

    auto operator<=>(const FaceColor&) const = default; ///< By red, green, blue.
};

/// Conditions for faces. A face is selected if it meets all conditions that are there, each by any
/// of its words. Without conditions all faces are selected.
struct FaceSelection {
    std::vector<std::string> faces;  ///< numbers, or names with * and ? as in file names
    std::vector<std::string> layers; ///< names of layers with * and ?
    std::vector<FaceColor> colors;   ///< of the faces
    std::optional<Box3> box{};       ///< world, mm: all material of the face lies within it
    /// Share of the face's area, above 0, that at least one of the standing views shows.
    std::optional<double> visible{};

    /// True if there is no condition.
    bool is_empty() const { return *this == FaceSelection{}; }
    /// The conditions for people: "faces roof*, layers SKIN, visible 50 %"; empty without any.
    std::string text() const;

    /// True if the conditions are equal.
    bool operator==(const FaceSelection& other) const;
};

/// Name of the scope that is found: the faces that the standing views show.
constexpr std::string_view outer_skin = "outer-skin";
/// Share of a face's area up to which it is no part of the outer skin.
constexpr double outer_skin_share = 0.01;

/// Part of a body that is judged: faces that the selection and any of the zones hold.
struct Scope {
    FaceSelection selection;        ///< of the faces
    std::vector<std::string> zones; ///< names of the preset's zones, or `outer_skin`; empty: all

    /// True if all of the body is judged.
    bool is_whole() const { return selection.is_empty() && zones.empty(); }
    /// The selection and the zones for people; empty if all of the body is judged.
    std::string text() const;
};

} // namespace keiko
