#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/math/polygon.h"

#include <algorithm>

namespace keiko {
namespace {

/// Corners and luminance of a sign's panel or of a part of its legend.
PolygonLight face_from(const TomlTable& table, const Rgb& otherwise) {
    PolygonLight face{corners_from(table)};
    require_ring(table, face.corners);
    face.luminance =
        table.rgb("luminance", TomlLimits::light()).value_or(otherwise) * color_of(table);
    require_light(table, "luminance", face.luminance);
    return face;
}

std::string face_text(const PolygonLight& face) {
    return corners_line(face.corners) + toml_line("luminance", toml_value(face.luminance), "cd/m2");
}

} // namespace

LuminousSign sign_from(const TomlTable& table) {
    constexpr double panel = 40, legend = 400; // cd/m2
    LuminousSign sign;
    sign.panel = face_from(table, Rgb(panel));
    const std::vector<TomlTable> parts = table.tables("legend");
    table.finish();
    constexpr std::size_t most_corners = 1000; // each hole is cut past all others
    std::size_t corners = sign.panel.corners.size();
    for (const TomlTable& one : parts) {
        PolygonLight part = face_from(one, Rgb(legend));
        corners += part.corners.size();
        if (corners > most_corners)
            throw one.error("corners", "the sign must have at most " +
                                           std::to_string(most_corners) +
                                           " corners with its legend");
        one.finish();
        require_legend(one, part, sign);
        if (part.normal().dot(sign.panel.normal()) < 0)
            std::reverse(part.corners.begin(), part.corners.end());
        sign.legend.push_back(std::move(part));
    }
    return sign;
}

std::string table_text(const LuminousSign& sign) {
    std::string text = "\n[[sign]]\n";
    text += face_text(sign.panel);
    for (const PolygonLight& part : sign.legend) text += "\n[[sign.legend]]\n" + face_text(part);
    return text;
}

} // namespace keiko
