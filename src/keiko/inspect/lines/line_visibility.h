#pragma once

#include "keiko/inspect/basics/line_field.h"
#include "keiko/intersect/traversal/tracer.h"

namespace keiko {

/// Whether the eye of a field sees one level's line at places of the surfaces.
class LineVisibility {
public:
    /// `seen`: all that may stand in the way. Keeps references.
    LineVisibility(const Tracer& seen, const LineField& field, double level);

    /// Whether the eye sees the place and, in it, the lamp of the line: the ray to the eye is free
    /// and, of reflections, the mirrored one up to the C-plane too; reflection and highlight lines
    /// end with the lamp; what stands in the way less than 0.2 mm from the place (2e-4 of the size
    /// of what is seen) is the other side of a seam and hides no line; isophotes are kept where the
    /// normal that faces the eye faces the lamps. `normal` is unit, `root` the place's own.
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
