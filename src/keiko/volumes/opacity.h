#pragma once

#include "keiko/scene/volume_spec.h"

namespace keiko {

/// Opacity of a node with this value by a surface of one value [Levoy1988, eq. 3]; `gradient`: the
/// length of its gradient, per step between nodes.
double contour_opacity(const ContourOpacity& contour, double value, double gradient);

/// Opacity of a node by a range of values, in proportion to the gradient, at most 1
/// [Levoy1988].
double region_opacity(const RegionOpacity& region, double value, double gradient);

/// Opacity of a layer by its optical depth.
double opacity_of_depth(double optical_depth);

/// Optical depth of a layer by its opacity; an opacity near 1 counts as 1 - 1e-4.
double depth_of_opacity(double opacity);

/// Optical depth over one step of `step` mm at a node, by all that makes a volume opaque.
double node_depth(const VolumeSpec& spec, double step, double value, double gradient);

} // namespace keiko
