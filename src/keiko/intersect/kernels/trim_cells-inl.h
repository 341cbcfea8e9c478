// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_TRACE_TRIM_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_TRIM_CELLS_INL_H
#undef KEIKO_TRACE_TRIM_CELLS_INL_H
#else
#define KEIKO_TRACE_TRIM_CELLS_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/subpatch/trim_cells.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

template <class D>
using CellSets = hn::Vec<hn::RebindToUnsigned<D>>;

/// Column or row of a cell, as TrimCells::met counts them.
template <class D>
CellSets<D> cell_index(D d, hn::Vec<D> place) {
    const auto scaled = hn::Mul(hn::Set(d, 4), hn::Add(place, hn::Set(d, 1)));
    const auto index = hn::Floor(hn::Min(hn::Max(scaled, hn::Zero(d)), hn::Set(d, 7)));
    // The lowest bits of a number so large are units.
    const auto number = hn::Add(index, hn::Set(d, 0x1p52));
    const hn::RebindToUnsigned<D> u;
    return hn::And(hn::BitCast(u, number), hn::Set(u, 7));
}

/// TrimCells::met for boxes about (x, y).
template <class D>
CellSets<D> cells_met(D d, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> off_x, hn::Vec<D> off_y) {
    const hn::RebindToUnsigned<D> u;
    const auto from_last = [&](CellSets<D> index) { return hn::Sub(hn::Set(u, 7), index); };
    const auto eightfold = [](CellSets<D> index) { return hn::ShiftLeft<3>(index); };
    const auto left = cell_index(d, hn::Sub(x, off_x)), right = cell_index(d, hn::Add(x, off_x));
    const auto bottom = cell_index(d, hn::Sub(y, off_y)), top = cell_index(d, hn::Add(y, off_y));
    const auto eight = hn::Set(u, 0xff), all = hn::Set(u, ~TrimCells::Set{0});
    auto row = hn::And(hn::Shr(eight, from_last(right)), hn::Shl(eight, left));
    row = hn::Or(row, hn::ShiftLeft<8>(row));
    row = hn::Or(row, hn::ShiftLeft<16>(row));
    row = hn::Or(row, hn::ShiftLeft<32>(row));
    return hn::And(
        row, hn::And(hn::Shr(all, eightfold(from_last(top))), hn::Shl(all, eightfold(bottom))));
}

/// The boxes that lie in cells of a set alone.
template <class D>
hn::Mask<D> lie_in(D d, CellSets<D> met, TrimCells::Set cells) {
    const hn::RebindToUnsigned<D> u;
    const auto beyond = hn::AndNot(hn::Set(u, cells), met);
    return hn::RebindMask(d, hn::Eq(beyond, hn::Zero(u)));
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
