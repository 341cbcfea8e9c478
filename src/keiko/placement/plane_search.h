#pragma once

#include "keiko/placement/lamp_field.h"
#include "keiko/placement/placement_score.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <vector>

namespace keiko {

/// Which way lamps may run in their plane.
enum class LampDirection {
    best,  ///< as the objective has it
    along, ///< along the vehicle's x axis, as far as the plane allows
    across ///< square to that
};

/// What is asked of the lamps on a plane.
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
