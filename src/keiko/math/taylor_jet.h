#pragma once

#include <cmath>

namespace keiko {

/// A function of (u, v) with its derivatives to the second order, as numbers or as ranges over a
/// box: what Jet<Jet<T>> holds without its mixed derivative twice, which is a third of the work.
template <class T>
struct TaylorJet {
    T f{}, u{}, v{}, uu{}, uv{}, vv{};
};

template <class T>
TaylorJet<T> operator+(const TaylorJet<T>& a, const TaylorJet<T>& b) {
    return {a.f + b.f, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
}
template <class T>
TaylorJet<T> operator-(const TaylorJet<T>& a, const TaylorJet<T>& b) {
    return {a.f - b.f, a.u - b.u, a.v - b.v, a.uu - b.uu, a.uv - b.uv, a.vv - b.vv};
}
template <class T>
TaylorJet<T> operator*(const TaylorJet<T>& a, double b) {
    return {a.f * b, a.u * b, a.v * b, a.uu * b, a.uv * b, a.vv * b};
}
template <class T>
TaylorJet<T> operator*(const TaylorJet<T>& a, const TaylorJet<T>& b) {
    return {a.f * b.f,
            a.u * b.f + a.f * b.u,
            a.v * b.f + a.f * b.v,
            a.uu * b.f + a.u * b.u * 2.0 + a.f * b.uu,
            a.uv * b.f + a.u * b.v + a.v * b.u + a.f * b.uv,
            a.vv * b.f + a.v * b.v * 2.0 + a.f * b.vv};
}
template <class T>
TaylorJet<T> square(const TaylorJet<T>& a) {
    const T twice = a.f * 2.0;
    return {square(a.f),
            twice * a.u,
            twice * a.v,
            square(a.u) * 2.0 + twice * a.uu,
            a.u * a.v * 2.0 + twice * a.uv,
            square(a.v) * 2.0 + twice * a.vv};
}
template <class T>
TaylorJet<T> operator/(const TaylorJet<T>& a, const TaylorJet<T>& b) {
    TaylorJet<T> q;
    q.f = a.f / b.f;
    q.u = (a.u - q.f * b.u) / b.f;
    q.v = (a.v - q.f * b.v) / b.f;
    q.uu = (a.uu - q.u * b.u * 2.0 - q.f * b.uu) / b.f;
    q.uv = (a.uv - q.u * b.v - q.v * b.u - q.f * b.uv) / b.f;
    q.vv = (a.vv - q.v * b.v * 2.0 - q.f * b.vv) / b.f;
    return q;
}
template <class T>
TaylorJet<T> sqrt(const TaylorJet<T>& a) {
    using std::sqrt;
    TaylorJet<T> root;
    root.f = sqrt(a.f);
    const T twice = root.f * 2.0;
    root.u = a.u / twice;
    root.v = a.v / twice;
    root.uu = (a.uu - square(root.u) * 2.0) / twice;
    root.uv = (a.uv - root.u * root.v * 2.0) / twice;
    root.vv = (a.vv - square(root.v) * 2.0) / twice;
    return root;
}

} // namespace keiko
