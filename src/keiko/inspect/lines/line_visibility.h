#pragma once

#include "keiko/inspect/basics/line_field.h"
#include "keiko/intersect/traversal/tracer.h"

namespace keiko {

/// Visibility of one level's line from the viewpoint of a field.
class LineVisibility {
public:
    /// `seen`: all possible occluders. Keeps references.
    LineVisibility(const Tracer& seen, const LineField& field, double level);

    /// True if the place is visible from the viewpoint and the lamp of the line is visible in it.
    /// The ray to the viewpoint must be free and, for reflections, the mirrored one up to the
    /// C-plane too. Reflection and highlight lines end with the lamp. An occluder less than 0.2 mm
    /// from the place (2e-4 of the size of the visible geometry) is the other side of a seam and
    /// hides no line. Isophotes are kept where the normal towards the viewpoint faces the lamps.
    /// `normal` is unit, `root` the place's own.
    bool sees(const Vec3& place, const Vec3& normal, const Root& root) const;

private:
    bool on_lamp(const LineField::Image& image) const;
    Ray to_eye(const Vec3& place) const;

    const Tracer& seen_;
    const LineField& field_;
    double level_;
    double begin_; ///< mm
};

} // namespace keiko
