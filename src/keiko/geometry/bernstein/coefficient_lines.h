#pragma once

#include <cstddef>

namespace keiko {

/// Polynomials side by side in one array: coefficient i of line k is c[i * step + k * stride].
/// Coefficients are numbers or control points.
struct CoefficientLines {
    std::size_t count;  ///< coefficients of a line, one at least
    std::size_t step;   ///< from a coefficient of a line to the next
    std::size_t lines;  ///< how many
    std::size_t stride; ///< from a line to the next

    /// The lines along u, or else v, of a tensor with u outer.
    static CoefficientLines of_tensor(std::size_t rows, std::size_t columns, bool along_u) {
        return along_u ? CoefficientLines{rows, columns, columns, 1}
                       : CoefficientLines{columns, 1, rows, columns};
    }
};

/// A step of de Casteljau's algorithm on all lines: coefficient `to` becomes the point at t between
/// two of them.
template <class T>
void blend_lines(T* c, const CoefficientLines& at, std::size_t to, std::size_t from,
                 std::size_t with, double t) {
    for (std::size_t k = 0; k < at.lines; ++k) {
        T* const line = c + k * at.stride;
        line[to * at.step] = line[from * at.step] * (1 - t) + line[with * at.step] * t;
    }
}

/// Makes the polynomials over [0, t] of those over [0, 1], in place.
template <class T>
void keep_before(T* c, const CoefficientLines& at, double t) {
    for (std::size_t level = 1; level < at.count; ++level)
        for (std::size_t i = at.count - 1; i >= level; --i) blend_lines(c, at, i, i - 1, i, t);
}

/// Makes the polynomials over [t, 1] of those over [0, 1], in place.
template <class T>
void keep_beyond(T* c, const CoefficientLines& at, double t) {
    for (std::size_t level = 1; level < at.count; ++level)
        for (std::size_t i = 0; i + level < at.count; ++i) blend_lines(c, at, i, i, i + 1, t);
}

/// Makes the polynomials over [a, b] of those over [0, 1], in place. Requires b > 0.
template <class T>
void restrict_lines(T* c, const CoefficientLines& at, double a, double b) {
    if (b != 1) keep_before(c, at, b);
    if (a != 0) keep_beyond(c, at, a / b);
}

/// Splits polynomials at t: `before`, of the same size, becomes those over [0, t], and `c` those
/// over [t, 1].
template <class T>
void split_lines(T* c, T* before, const CoefficientLines& at, double t) {
    for (std::size_t level = 0; level < at.count; ++level) {
        for (std::size_t k = 0; k < at.lines; ++k)
            before[level * at.step + k * at.stride] = c[k * at.stride];
        for (std::size_t i = 0; i + level + 1 < at.count; ++i) blend_lines(c, at, i, i, i + 1, t);
    }
}

} // namespace keiko
