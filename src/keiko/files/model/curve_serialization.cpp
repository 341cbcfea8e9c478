#include "keiko/files/model/curve_serialization.h"

#include "keiko/base/error.h"
#include "keiko/files/model/byte_stream.h"
#include "keiko/geometry/model/curve_fault.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr std::string_view magic = "KEIKO-CS";
constexpr std::uint32_t version = 1;

void write(ByteWriter& out, const NurbsCurve<Vec4>& piece) {
    out.put(static_cast<std::uint32_t>(piece.degree));
    out.put(static_cast<std::uint64_t>(piece.knots.size()));
    for (const double knot : piece.knots) out.put(knot);
    out.put(static_cast<std::uint64_t>(piece.points.size()));
    for (const Vec4& p : piece.points)
        for (const double part : {p.x, p.y, p.z, p.w}) out.put(part);
}

void write(ByteWriter& out, const NamedCurve& curve) {
    out.put(std::string_view(curve.name));
    out.put(static_cast<std::uint8_t>(curve.color.has_value()));
    const Rgb color = curve.color.value_or(Rgb{});
    for (const double part : {color.r, color.g, color.b, curve.deviation}) out.put(part);
    out.put(static_cast<std::uint64_t>(curve.pieces.size()));
    for (const NurbsCurve<Vec4>& piece : curve.pieces) write(out, piece);
}

double take_number(ByteReader& in) {
    const auto number = in.take<double>();
    if (!std::isfinite(number)) throw DamagedBytes("a number that is not finite");
    return number;
}

NurbsCurve<Vec4> take_piece(ByteReader& in) {
    NurbsCurve<Vec4> piece;
    piece.degree = static_cast<int>(std::min(in.take<std::uint32_t>(), 1000u));
    piece.knots.resize(in.take_count(sizeof(double)));
    for (double& knot : piece.knots) knot = take_number(in);
    piece.points.resize(in.take_count(4 * sizeof(double)));
    for (Vec4& p : piece.points)
        for (double* part : {&p.x, &p.y, &p.z, &p.w}) *part = take_number(in);
    if (const std::string fault = fault_of(piece); !fault.empty()) throw DamagedBytes(fault);
    return piece;
}

NamedCurve take_curve(ByteReader& in) {
    NamedCurve curve;
    curve.name = in.take_text();
    const bool colored = in.take<std::uint8_t>() != 0;
    Rgb color;
    for (double* part : {&color.r, &color.g, &color.b, &curve.deviation}) *part = take_number(in);
    if (colored) curve.color = color;
    constexpr std::size_t least_piece = 3 * sizeof(std::uint64_t) - sizeof(std::uint32_t);
    const std::size_t pieces = in.take_count(least_piece);
    for (std::size_t i = 0; i < pieces; ++i) curve.pieces.push_back(take_piece(in));
    return curve;
}

CurveSet take_set(ByteReader in) {
    for (const char expected : magic)
        if (in.take<char>() != expected) throw DamagedBytes("it does not begin as one");
    if (in.take<std::uint32_t>() != version) throw DamagedBytes("it is of another version");
    CurveSet set{in.take_text()};
    constexpr std::size_t least_curve = 6 * sizeof(double) + 1;
    const std::size_t curves = in.take_count(least_curve);
    for (std::size_t i = 0; i < curves; ++i) set.curves.push_back(take_curve(in));
    if (in.remaining() != 0) throw DamagedBytes("bytes follow its end");
    return set;
}

} // namespace

std::string serialize(const CurveSet& set) {
    std::string bytes;
    ByteWriter out([&](std::string_view piece) { bytes += piece; });
    out.put_bytes(magic);
    out.put(version);
    out.put(std::string_view(set.name));
    out.put(static_cast<std::uint64_t>(set.curves.size()));
    for (const NamedCurve& curve : set.curves) write(out, curve);
    out.flush();
    return bytes;
}

CurveSet deserialize_curves(std::string_view bytes, const std::string& file) {
    try {
        return take_set(ByteReader(bytes));
    } catch (const DamagedBytes& damage) {
        throw Error(file, "", std::string("not a sound set of curves: ") + damage.what());
    }
}

} // namespace keiko
