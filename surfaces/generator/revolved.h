#pragma once

#include "net.h"

namespace keiko::fixtures {

/// A control point of a profile in mm: distance from the z axis and height.
struct ProfilePoint {
    double radius, z;
};

/// Appends the body of revolution about the z axis of a chain of cubic Bezier curves: four bicubic
/// patches a curve. A curve begins in the last point of the one before. Upward profiles have their
/// normals outwards.
void append_revolved(std::vector<Net>& patches, const std::vector<ProfilePoint>& profile);

/// A control section of a pipe whose middle line lies in the plane y = 0: an ellipse about
/// `middle`. Its half axes are `height` along the unit vector `up` in that plane, and `width` along
/// y, mm.
struct PipePoint {
    gp_XYZ middle, up;
    double height, width;
};

/// Appends a pipe along a chain of cubic Bezier curves of sections: four bicubic patches a curve.
void append_pipe(std::vector<Net>& patches, const std::vector<PipePoint>& pipe);

} // namespace keiko::fixtures
