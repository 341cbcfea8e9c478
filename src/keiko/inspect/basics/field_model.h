#pragma once

#include "keiko/inspect/basics/line_field.h"
#include "keiko/inspect/basics/patch_box.h"
#include "keiko/inspect/basics/patch_model.h"

namespace keiko {

/// The field of lamps over a box of a patch, as Taylor models of the box's local parameters x and
/// y, from -1 to 1. Unlike interval bounds they keep what cancels in the reflection, so that boxes
/// can be large.
class FieldModel {
public:
    /// `shift`: level from which those below are counted; a near one keeps bounds tight. Keeps a
    /// reference to the field.
    FieldModel(const PatchBox& box, const LineField& field, double shift);

    /// False only if no ray of the box runs to the C-plane.
    bool may_face_plane() const;
    /// False only if the level, counted from the shift, is nowhere in the box.
    bool may_hold(double level) const { return may_vanish(values_.residual(level)); }
    /// False only if no ray of the box that runs to the C-plane of another field, of the same kind
    /// and viewpoint, meets it where that field's value is between `low` and `high`.
    bool may_meet(const LineField& other, double low, double high) const;
    /// False only if the surface has a normal everywhere in the box.
    bool may_be_singular() const;
    /// The field with its slopes by x and y.
    LineRatio<Jet<TaylorModel>> sloped() const { return ratio<Jet<TaylorModel>>(field_, shift_); }

private:
    /// A function over the box: its value, or its value and slopes.
    template <class T>
    T of(const TaylorModel& f, const TaylorModel& x, const TaylorModel& y) const;
    template <class T>
    Triple<T> point(const HomogeneousModel& f, const HomogeneousModel& x,
                    const HomogeneousModel& y) const {
        return {of<T>(f.p.x, x.p.x, y.p.x), of<T>(f.p.y, x.p.y, y.p.y), of<T>(f.p.z, x.p.z, y.p.z)};
    }
    template <class T>
    Triple<T> normal() const;
    template <class T>
    LineRatio<T> ratio(const LineField& field, double shift) const;

    const LineField& field_;
    double shift_;
    bool rational_;
    PatchModel patch_;
    LineRatio<TaylorModel> values_;
};

} // namespace keiko
