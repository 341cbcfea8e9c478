#pragma once

#include "keiko/base/export.h"
#include "keiko/placement/lamp_field.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// Quality of lamps on one plane for a picture: the factors of the objective, each 0 to 1.
struct PlacementScore {
    double coverage = 0;    ///< share of the picture's weight that these lamps newly serve
    double stripes = 0;     ///< weighted mean over the faces of min(1, stripes on it / 5)
    double uniformity = 0;  ///< exp(-standard deviation of ln |grad v|): 1 for uniform stripes
    double in_range = 0;    ///< share of the served weight whose stripe spacing is in the wanted
                            ///< range
    double crossing = 0;    ///< squareness of the crossings of stripes with features; 1 without
                            ///< features
    double compactness = 0; ///< 1 for lamps as small as the visible part, 0.5 at 8 times its size

    /// The product that is maximised. `crossing` has no part in it: it would cost coverage, see
    /// docs/decisions/0006-placement.md.
    double objective() const;
};

/// Spacings of stripes in a picture, in pixels of a picture 540 high; scaled to others.
struct StripeSpacing {
    double least = 12, wanted = 24, most = 60; ///< px from stripe to stripe

    /// The spacings scaled to a picture of this height, px.
    StripeSpacing for_height(int height) const {
        const double scale = height / 540.0;
        return {least * scale, wanted * scale, most * scale};
    }
};

/// Direction of lamps in their plane.
enum class LampDirection {
    best,  ///< the one with the best objective
    along, ///< along the vehicle's x axis, as far as the plane allows
    across ///< square to that
};

/// Requirements on the lamps of a plane.
struct LampDemand {
    int lamps = 12;                                ///< 0: as many as give the wanted spacing
    StripeSpacing spacing;                         ///< px of the picture in question
    LampDirection direction = LampDirection::best; ///< of the lamps in their plane
    std::optional<MirrorPlane> mirror{}; ///< on planes that are their own image the lamps are, too
};

/// A rectangle of lamps on a plane.
struct LampRectangle {
    PlaneFrame frame;     ///< u along the lamps
    Box2 extent;          ///< mm in that frame
    int lamps = 0;        ///< number of lamps
    PlacementScore score; ///< factors of the objective

    /// Distance between neighbouring lamps, mm.
    double pitch() const { return extent.extent().y / lamps; }
    /// C-plane of the rectangle; diameter in mm, luminance in cd/m2.
    CPlane c_plane(double diameter, const Rgb& luminance) const;
};

/// Tests rectangles and directions of lamps on one plane against the uncovered samples.
class PlaneSearch {
public:
    /// Search on one plane; keeps a reference to the field.
    PlaneSearch(const LampField& field, const PlaneFrame& frame, const LampDemand& demand);

    /// Best rectangle with the lamps `angle` radians from the frame's u. Its score is zero if the
    /// plane is of no use.
    LampRectangle best_at(double angle) const;
    /// The given rectangle, with lamps along the frame's u.
    LampRectangle rated(const Box2& extent) const;
    /// Best rectangle over the angles that the demand allows. If it allows all, lamps stay along or
    /// across the vehicle unless another angle is clearly better, or would be no mirror image.
    LampRectangle best() const;

private:
    /// A sample whose reflected ray meets the plane.
    struct Reached {
        std::size_t sample = 0;
        Vec2 place{0};
        PlaneHit::Gradients gradients;
        double log_gradient = 0; ///< ln |grad v|; NaN if unknown
    };

    LampRectangle score(const PlaneFrame& frame, const Box2& extent,
                        const std::vector<Reached>& turned) const;
    /// Turns in ever smaller steps as long as that improves the score.
    LampRectangle refined(LampRectangle start) const;
    std::vector<Reached> turned(double angle) const;
    int lamp_count(const Box2& extent, const std::vector<Reached>& turned) const;
    std::vector<bool> hidden_by(const PlaneFrame& frame, const Box2& extent) const;

    const LampField& field_;
    PlaneFrame frame_;
    bool own_image_ = false; ///< of the demand's mirror
    LampDemand demand_;
    std::vector<Reached> reached_;
    std::vector<std::size_t> seen_through_; ///< samples whose camera ray crosses the plane
};

} // namespace keiko
