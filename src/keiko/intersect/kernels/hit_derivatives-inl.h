// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_HIT_DERIVATIVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_HIT_DERIVATIVES_INL_H
#undef KEIKO_INTERSECT_HIT_DERIVATIVES_INL_H
#else
#define KEIKO_INTERSECT_HIT_DERIVATIVES_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/patch_jet-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// HomogeneousJet, a vector of hits wide: in `at`, value, du, dv, duu, duv and dvv.
template <class D>
struct HomogeneousJets {
    static constexpr std::size_t lanes = hn::MaxLanes(D()); ///< hits side by side

    alignas(64) std::array<std::array<std::array<double, lanes>, 4>, 6> at; ///< by component

    /// Writes the jet of one lane.
    void put(const HomogeneousJet& jet, std::size_t lane) {
        const std::array<const Component4*, 6> from{&jet.value, &jet.du,  &jet.dv,
                                                    &jet.duu,   &jet.duv, &jet.dvv};
        for (std::size_t k = 0; k < 6; ++k)
            for (std::size_t c = 0; c < 4; ++c) at[k][c][lane] = (*from[k])[c];
    }
};

/// The sums of jet_at() of hits on one sub-patch, side by side, for `count` components from `first`
/// on. Keeps its order of products and sums, since a hit has the same bits in any company.
template <std::size_t first, std::size_t count, class D>
void find_jets_on_sub_patch(const BezierPatchView& sub_patch, const BasisJet<D>& u,
                            const BasisJet<D>& v, HomogeneousJets<D>& jets) {
    const D d;
    using V = hn::Vec<D>;
    using Some = std::array<V, count>;
    const auto rows = static_cast<std::size_t>(sub_patch.degree_u);
    const auto columns = static_cast<std::size_t>(sub_patch.degree_v);
    const auto at = [&](const auto& basis, std::size_t i) { return hn::Load(d, basis[i].data()); };
    const auto add = [](const Some& a, V factor, Some& to) {
        for (std::size_t c = 0; c < count; ++c) to[c] = hn::MulAdd(a[c], factor, to[c]);
    };
    Some zero;
    zero.fill(hn::Zero(d));
    Some value = zero, du = zero, dv = zero, duu = zero, duv = zero, dvv = zero;
    const Vec4* point = sub_patch.points.data();
    for (std::size_t i = 0; i <= rows; ++i) {
        Some row = zero, slope = zero, bend = zero;
        for (std::size_t j = 0; j <= columns; ++j, ++point) {
            Some p;
            for (std::size_t c = 0; c < count; ++c) p[c] = hn::Set(d, (&point->x)[first + c]);
            add(p, at(v.value, j), row);
            add(p, at(v.first, j), slope);
            add(p, at(v.second, j), bend);
        }
        const V b = at(u.value, i), b1 = at(u.first, i);
        add(row, b, value), add(row, b1, du), add(row, at(u.second, i), duu);
        add(slope, b, dv), add(slope, b1, duv);
        add(bend, b, dvv);
    }
    // Sums in an array would be kept in memory.
    const auto store = [&](const Some& sum, std::size_t k) {
        for (std::size_t c = 0; c < count; ++c) hn::Store(sum[c], d, jets.at[k][first + c].data());
    };
    store(value, 0), store(du, 1), store(dv, 2);
    store(duu, 3), store(duv, 4), store(dvv, 5);
}

/// Finds the jets of hits on one sub-patch; weights that are all the same are left out.
template <class D>
void find_jets_on_sub_patch(const BezierPatchView& sub_patch, bool rational, const BasisJet<D>& u,
                            const BasisJet<D>& v, HomogeneousJets<D>& jets) {
    if (!rational) return find_jets_on_sub_patch<0, 3>(sub_patch, u, v, jets);
    // Half of the components at a time fill the registers.
    find_jets_on_sub_patch<0, 2>(sub_patch, u, v, jets);
    find_jets_on_sub_patch<2, 2>(sub_patch, u, v, jets);
}

/// True if all wanted hits, four at least, are on the sub-patch of the first lane.
bool are_many_on_sub_patch(const HitPacket& hits, std::size_t lane, LaneMask wanted) {
    constexpr int many = 4;
    const auto* points = hits.sub_patch[lane].points.data();
    int count = 0;
    for (; wanted != 0; wanted &= wanted - 1, ++count)
        if (hits.sub_patch[lane + static_cast<std::size_t>(std::countr_zero(wanted))]
                .points.data() != points)
            return false;
    return count >= many;
}

/// The control points' sums, of hits on several sub-patches one after the other; the bases of
/// sub-patches of the same degrees side by side.
template <class D>
HomogeneousJets<D> homogeneous_jets(D d, const HitPacket& hits, std::size_t lane, LaneMask wanted) {
    HomogeneousJets<D> jets;
    const bool one_sub_patch = are_many_on_sub_patch(hits, lane, wanted);
    if (!one_sub_patch) jets.at = {}; // numbers in lanes that no one wants, too
    while (wanted != 0) {
        const BezierPatchView& shape =
            hits.sub_patch[lane + static_cast<std::size_t>(std::countr_zero(wanted))];
        const BasisJet<D> u(static_cast<std::size_t>(shape.degree_u),
                            hn::Load(d, hits.u.data() + lane));
        const BasisJet<D> v(static_cast<std::size_t>(shape.degree_v),
                            hn::Load(d, hits.v.data() + lane));
        if (one_sub_patch) {
            find_jets_on_sub_patch(shape, hits.weight[lane] == 0, u, v, jets);
            return jets;
        }
        for (LaneMask left = wanted; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            const BezierPatchView& sub_patch = hits.sub_patch[lane + i];
            if (sub_patch.degree_u != shape.degree_u || sub_patch.degree_v != shape.degree_v)
                continue;
            jets.put(jet_at(sub_patch, u, v, i), i);
            wanted &= ~(LaneMask{1} << i);
        }
    }
    return jets;
}

/// SurfaceJet, one a lane.
template <class V>
struct SpaceJet {
    Space<V> position, du, dv, duu, duv, dvv; ///< by the parameters, mm
};

/// Lanes of `projected` in surface_interaction.h: by the quotient rule where weights differ, for
/// which `weight` is 0.
template <class D>
SpaceJet<hn::Vec<D>> projected(D d, const HomogeneousJets<D>& jets, hn::Vec<D> weight) {
    using V = hn::Vec<D>;
    const auto get = [&](std::size_t k, std::size_t c) {
        return hn::Load(d, jets.at[k][c].data());
    };
    const auto rational = hn::Eq(weight, hn::Zero(d));
    const bool none_rational = hn::AllFalse(d, rational);
    const V at_place = none_rational ? weight : hn::IfThenElse(rational, get(0, 3), weight);
    const V scale = hn::Div(hn::Set(d, 1), at_place);
    const auto over_weight = [&](std::size_t k) {
        return Space<V>{hn::Mul(get(k, 0), scale), hn::Mul(get(k, 1), scale),
                        hn::Mul(get(k, 2), scale)};
    };
    SpaceJet<V> s{over_weight(0), over_weight(1), over_weight(2),
                  over_weight(3), over_weight(4), over_weight(5)};
    if (none_rational) return s;
    const auto lower = [&](Space<V>& a, const Space<V>& by) {
        const Space<V> less = difference(a, by);
        for (std::size_t k = 0; k < 3; ++k) a[k] = hn::IfThenElse(rational, less[k], a[k]);
    };
    const auto weights = [&](std::size_t k) { return hn::Mul(get(k, 3), scale); };
    const V wu = weights(1), wv = weights(2), two = hn::Set(d, 2);
    lower(s.du, scaled(s.position, wu));
    lower(s.dv, scaled(s.position, wv));
    lower(s.duu, sum(scaled(s.du, hn::Mul(two, wu)), scaled(s.position, weights(3))));
    lower(s.dvv, sum(scaled(s.dv, hn::Mul(two, wv)), scaled(s.position, weights(5))));
    lower(s.duv, sum(sum(scaled(s.dv, wu), scaled(s.du, wv)), scaled(s.position, weights(4))));
    return s;
}

/// Turns what stands in lanes of placed parts into the world.
void place(HitPacket& hits) {
    for (std::size_t lane = 0; lane < hits.count; ++lane) {
        const Affine* to_world = hits.to_world[lane];
        if (!to_world) continue;
        const auto put = [&](HitPacket::Vectors& to, const Vec3& v) {
            for (unsigned k = 0; k < 3; ++k) to[k][lane] = v[k];
        };
        put(hits.position, to_world->point(HitPacket::at(hits.position, lane)));
        for (HitPacket::Vectors* a : {&hits.du, &hits.dv, &hits.duu, &hits.duv, &hits.dvv})
            put(*a, to_world->vector(HitPacket::at(*a, lane)));
    }
}

/// The surface in its part, by patch parameters.
template <class D>
void evaluate_in_part(D d, HitPacket& hits, std::size_t lane) {
    using V = hn::Vec<D>;
    const std::size_t count = std::min(hits.count - lane, hn::Lanes(d));
    const HomogeneousJets<D> jets = homogeneous_jets(d, hits, lane, (LaneMask{1} << count) - 1);
    const V weight =
        hn::IfThenElse(hn::FirstN(d, count), hn::Load(d, hits.weight.data() + lane), hn::Set(d, 1));
    const SpaceJet<V> s = projected(d, jets, weight);
    const V per_u = hn::Load(d, hits.per_u.data() + lane);
    const V per_v = hn::Load(d, hits.per_v.data() + lane);
    store(d, sum(load(d, hits.center, lane), s.position), hits.position, lane);
    store(d, scaled(s.du, per_u), hits.du, lane);
    store(d, scaled(s.dv, per_v), hits.dv, lane);
    store(d, scaled(s.duu, hn::Mul(per_u, per_u)), hits.duu, lane);
    store(d, scaled(s.duv, hn::Mul(per_u, per_v)), hits.duv, lane);
    store(d, scaled(s.dvv, hn::Mul(per_v, per_v)), hits.dvv, lane);
}

/// Normals, and how far a small step in parameters moves the point: the second order counted
/// twice, which covers what follows it.
template <class D>
void finish(D d, HitPacket& hits, std::size_t lane) {
    using V = hn::Vec<D>;
    const Space<V> du = load(d, hits.du, lane), dv = load(d, hits.dv, lane);
    const Space<V> across = cross(du, dv);
    const V area2 = square(across), u2 = square(du), v2 = square(dv);
    const V duv2 = square(load(d, hits.duv, lane));
    const V small = hn::Set(d, 1e-8);
    const auto plain = hn::And(hn::Gt(area2, hn::Mul(hn::Mul(small, u2), v2)),
                               hn::Gt(hn::Min(u2, v2), hn::Mul(small, duv2)));
    hits.plain |= lane_bits(d, plain, lane);
    const V length = hn::Sqrt(area2);
    store(d, {hn::Div(across[0], length), hn::Div(across[1], length), hn::Div(across[2], length)},
          hits.normal, lane);

    const V step_u = hn::Load(d, hits.error_u.data() + lane);
    const V step_v = hn::Load(d, hits.error_v.data() + lane);
    const V duu = hn::Sqrt(square(load(d, hits.duu, lane)));
    const V dvv = hn::Sqrt(square(load(d, hits.dvv, lane)));
    const V twist = hn::Mul(hn::Set(d, 2), hn::Sqrt(duv2));
    V reach = hn::Add(hn::Mul(hn::Sqrt(u2), step_u), hn::Mul(hn::Sqrt(v2), step_v));
    reach = hn::Add(reach, hn::Mul(hn::Mul(duu, step_u), step_u));
    reach = hn::Add(reach, hn::Mul(hn::Mul(twist, step_u), step_v));
    reach = hn::Add(reach, hn::Mul(hn::Mul(dvv, step_v), step_v));
    hn::Store(reach, d, hits.reach.data() + lane);
    const V away = hn::Sqrt(square(load(d, hits.position, lane)));
    hn::Store(away, d, hits.away.data() + lane);
}

/// Fills in a packet by vectors as wide as `d`.
template <class D>
void evaluate_by(D d, HitPacket& hits) {
    const std::size_t width = hn::Lanes(d);
    hits.plain = 0;
    for (std::size_t lane = 0; lane < hits.count; lane += width) evaluate_in_part(d, hits, lane);
    place(hits);
    for (std::size_t lane = 0; lane < hits.count; lane += width) finish(d, hits, lane);
}

/// Fills in what HitPacket says is there, for its first `count` lanes.
void evaluate_hits(HitPacket& hits) {
    // The bases of a single hit in a wide vector would be mostly memory that nobody asks for.
    if (hits.count == 1)
        evaluate_by(One(), hits);
    else
        evaluate_by(Wide(), hits);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
