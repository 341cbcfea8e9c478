#pragma once

#include "keiko/placement/lamp_field.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <vector>

namespace keiko {

/// How good lamps on one plane are for a picture: the factors of the objective, each 0 to 1.
struct PlacementScore {
    double coverage = 0;    ///< share of the picture's weight that these lamps newly serve
    double stripes = 0;     ///< weighted mean over the faces of min(1, stripes on it / 5)
    double uniformity = 0;  ///< exp(-standard deviation of ln |grad v|): 1 for even stripes
    double in_range = 0;    ///< share of what is served whose stripe spacing is in the wanted range
    double crossing = 0;    ///< how squarely stripes cross features; 1 where there are none
    double compactness = 0; ///< 1 for lamps as small as what is seen, 0.5 at 8 times its size

    /// The product to make large. `crossing` has no part in it: it would cost coverage, see
    /// docs/decisions/0006-placement.md.
    double objective() const;
};

/// The stripes a picture should show, in pixels of a picture 540 high; scaled to others.
struct StripeSpacing {
    double least = 12, wanted = 24, most = 60;

    StripeSpacing for_height(int height) const {
        const double scale = height / 540.0;
        return {least * scale, wanted * scale, most * scale};
    }
};

/// Which way lamps may run in their plane.
enum class LampDirection {
    best,  ///< as the objective has it
    along, ///< along the vehicle's x axis, as far as the plane allows
    across ///< square to that
};

/// Requirements on the lamps of a plane.
struct LampDemand {
    int lamps = 12;        ///< 0: as many as give the wanted spacing
    StripeSpacing spacing; ///< px of the picture in question
    LampDirection direction = LampDirection::best;
    std::optional<MirrorPlane> mirror{}; ///< on planes that are their own image so are the lamps
};

/// A rectangle of lamps on a plane.
struct LampRectangle {
    PlaneFrame frame; ///< u along the lamps
    Box2 extent;      ///< mm in that frame
    int lamps = 0;
    PlacementScore score;

    double pitch() const { return extent.extent().y / lamps; }
    CPlane c_plane(double diameter, const Rgb& luminance) const;
};

/// Tries rectangles and directions of lamps on one plane against the samples that still wait.
class PlaneSearch {
public:
    PlaneSearch(const LampField& field, const PlaneFrame& frame, const LampDemand& demand);

    /// Best rectangle with the lamps `angle` radians from the frame's u. Its score is zero where
    /// the plane is of no use.
    LampRectangle best_at(double angle) const;
    /// The rectangle as it is, with lamps along the frame's u.
    LampRectangle rated(const Box2& extent) const;
    /// Best rectangle over the angles that the demand allows; where it allows all, lamps stay along
    /// or across the vehicle unless another angle is clearly better, or would be no mirror image.
    LampRectangle best() const;

private:
    /// A sample whose reflected ray meets the plane.
    struct Reached {
        std::size_t sample = 0;
        Vec2 place{0};
        PlaneHit::Gradients gradients;
        double log_gradient = 0; ///< ln |grad v|; NaN where it is not known
    };

    LampRectangle score(const PlaneFrame& frame, const Box2& extent,
                        const std::vector<Reached>& turned) const;
    /// Turns in ever smaller steps as long as that helps.
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
