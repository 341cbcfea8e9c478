#pragma once

#include "keiko/base/job.h"
#include "keiko/drawing/curves/image_projection.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/geometry/bvh/box_tree.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// A place of a curve at which the number of sheets before it changes.
struct CountChange {
    double t = 0;   ///< parameter of the curve
    int change = 0; ///< by which the number rises as the parameter rises
};

/// The occluding curves of a body in one view, and where others pass behind them: the events of
/// [Appel1967] for curved surfaces. Keeps references to its arguments.
class OccluderImage {
public:
    /// `size`: of the body, mm. `chord_error`: of all curves, mm.
    OccluderImage(const ImageProjection& projection, std::span<const OccludingCurve> borders,
                  std::span<const OccludingCurve> outlines, double size, double chord_error);

    /// Every place along a curve where the number of sheets before it changes, by rising parameter:
    /// crossings with nearer curves in the image, contacts with the outlines of its own faces,
    /// cusps and piercings.
    std::vector<CountChange> along(const ModelCurve& curve) const;

private:
    struct Chord {
        const OccludingCurve* curve = nullptr;
        std::uint32_t index = 0; ///< of its first point
        ImagePoint a, b;
    };
    static std::vector<Chord> chords_of(const ImageProjection& projection,
                                        std::span<const OccludingCurve> borders,
                                        std::span<const OccludingCurve> outlines);
    static std::vector<Box3> boxes_of(std::span<const Chord> chords);
    void add_crossings(const ModelCurve& curve, std::vector<CountChange>& changes) const;
    void add_crossing(const ModelCurve& curve, std::size_t i, const Chord& chord,
                      std::vector<std::pair<CountChange, const void*>>& found) const;
    void add_contacts(const ModelCurve& curve, std::vector<CountChange>& changes) const;
    void add_ends_on(const ModelCurve& curve, const OccludingCurve& outline,
                     std::vector<CountChange>& changes) const;
    void add_meetings(const ModelCurve& curve, const OccludingCurve& outline,
                      std::vector<CountChange>& changes) const;
    void add_cusps(const ModelCurve& curve, std::vector<CountChange>& changes) const;
    void add_piercings(const ModelCurve& curve, std::vector<CountChange>& changes) const;
    int crossing_change(const ModelCurve& curve, double t, const OccludingCurve& behind,
                        double u) const;

    const ImageProjection& projection_;
    double size_, chord_error_;
    std::vector<Chord> chords_;
    BoxTree tree_;       ///< of the chords: right, up, depth
    double nearest_;     ///< mm, least depth of all
    double image_error_; ///< of the chords, in the image
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<const OccludingCurve*>>
        outlines_; ///< by instance and face
};

} // namespace keiko
