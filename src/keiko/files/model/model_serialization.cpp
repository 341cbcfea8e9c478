#include "keiko/files/model/model_serialization.h"

#include "keiko/base/error.h"
#include "keiko/files/model/byte_stream.h"

#include <concepts>
#include <tuple>

namespace keiko {
namespace {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

// The members of each record of a SurfaceModel in the order in which they are written. One list
// serves reading and writing, so that the two cannot differ.

auto members(Is<Vec2> auto& v) {
    return std::tie(v.x, v.y);
}
auto members(Is<Vec3> auto& v) {
    return std::tie(v.x, v.y, v.z);
}
auto members(Is<Vec4> auto& v) {
    return std::tie(v.x, v.y, v.z, v.w);
}
auto members(Is<Rgb> auto& c) {
    return std::tie(c.r, c.g, c.b);
}
auto members(Is<Affine> auto& a) {
    return std::tie(a.rows[0], a.rows[1], a.rows[2], a.translation);
}
auto members(Is<ParameterMap> auto& m) {
    return std::tie(m.kind, m.begin, m.end);
}
auto members(Is<Patch> auto& p) {
    return std::tie(p.face, p.first_point, p.degree_u, p.degree_v, p.map_u, p.map_v);
}
auto members(Is<TrimCurve> auto& c) {
    return std::tie(c.first_point, c.degree, c.edge);
}
auto members(Is<TrimLoop> auto& l) {
    return std::tie(l.first_curve, l.curve_count);
}
auto members(Is<Face> auto& f) {
    return std::tie(f.id, f.name, f.layer, f.color, f.surface_kind, f.part, f.first_patch,
                    f.patch_count, f.first_loop, f.loop_count, f.reversed, f.approximated, f.line);
}
auto members(Is<Edge> auto& e) {
    return std::tie(e.tolerance, e.use_count, e.degenerate);
}
auto members(Is<Part> auto& p) {
    return std::tie(p.name, p.first_face, p.face_count);
}
auto members(Is<Instance> auto& i) {
    return std::tie(i.part, i.name, i.transform);
}
auto members(Is<LostFace> auto& f) {
    return std::tie(f.id, f.name, f.reason);
}
auto members(Is<IrregularPatch> auto& p) {
    return std::tie(p.face, p.center, p.radius);
}
auto members(Is<Repair> auto& r) {
    return std::tie(r.face, r.kind, r.count, r.size, r.detail);
}
auto members(Is<Diagnostic> auto& d) {
    return std::tie(d.severity, d.entity, d.message);
}
auto members(Is<SurfaceModel> auto& m) {
    return std::tie(m.source, m.format, m.unit, m.control_points, m.trim_points, m.patches,
                    m.trim_curves, m.trim_loops, m.faces, m.edges, m.parts, m.instances,
                    m.lost_faces, m.irregular_patches, m.repairs, m.diagnostics);
}

constexpr std::string_view magic = "KEIKO-SM";

template <class T>
constexpr std::uint8_t last_value = 0;
template <>
constexpr std::uint8_t last_value<ParameterMap::Kind> =
    static_cast<std::uint8_t>(ParameterMap::Kind::hyperbolic);
template <>
constexpr std::uint8_t last_value<RepairKind> = static_cast<std::uint8_t>(RepairKind::by_reader);
template <>
constexpr std::uint8_t last_value<Severity> = static_cast<std::uint8_t>(Severity::error);

struct Writer {
    ByteWriter out;

    template <class T>
    void operator()(const T& value) {
        if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
            out.put(static_cast<std::uint8_t>(value));
        } else if constexpr (std::is_arithmetic_v<T>) {
            out.put(value);
        } else {
            std::apply([this](const auto&... member) { ((*this)(member), ...); }, members(value));
        }
    }
    void operator()(const std::string& text) { out.put(std::string_view(text)); }
    template <class T>
    void operator()(const std::vector<T>& values) {
        out.put(static_cast<std::uint64_t>(values.size()));
        for (const T& value : values) (*this)(value);
    }
    template <class T>
    void operator()(const std::optional<T>& value) {
        (*this)(value.has_value());
        if (value) (*this)(*value);
    }
};

/// Bytes that every value of a type takes at least.
template <class T>
constexpr std::size_t least_size = [] {
    if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>)
        return std::size_t{1};
    else if constexpr (std::is_arithmetic_v<T>)
        return sizeof(T);
    else
        return []<class... M>(std::type_identity<std::tuple<M&...>>) {
            return (least_size<M> + ...);
        }(std::type_identity<decltype(members(std::declval<T&>()))>{});
}();
template <>
constexpr std::size_t least_size<std::string> = 8;
template <class T>
constexpr std::size_t least_size<std::vector<T>> = 8;
template <class T>
constexpr std::size_t least_size<std::optional<T>> = 1;

struct Reader {
    ByteReader in;

    template <class T>
    void operator()(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            value = small(1) == 1;
        } else if constexpr (std::is_arithmetic_v<T>) {
            value = in.take<T>();
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(small(last_value<T>));
        } else {
            std::apply([this](auto&... member) { ((*this)(member), ...); }, members(value));
        }
    }
    void operator()(std::string& text) { text = in.take_text(); }
    template <class T>
    void operator()(std::vector<T>& values) {
        values.resize(in.take_count(least_size<T>));
        for (T& value : values) (*this)(value);
    }
    template <class T>
    void operator()(std::optional<T>& value) {
        if (small(1) == 1) (*this)(value.emplace());
    }

    std::uint8_t small(std::uint8_t last) {
        const auto number = in.take<std::uint8_t>();
        if (number > last) throw DamagedBytes("an unknown kind");
        return number;
    }
};

std::string_view checked_payload(std::string_view bytes) {
    if (bytes.substr(0, magic.size()) != magic) throw DamagedBytes("it does not begin as one");
    ByteReader header(bytes.substr(magic.size()));
    if (const auto found = header.take<std::uint32_t>(); found != model_serialization_version)
        throw DamagedBytes("its version is " + std::to_string(found) + ", not " +
                           std::to_string(model_serialization_version));
    const auto sum = header.take<std::uint64_t>();
    const std::size_t size = header.take_count(1);
    if (size != header.remaining()) throw DamagedBytes("bytes follow its end");
    const std::string_view payload = bytes.substr(bytes.size() - size);
    if (checksum(payload) != sum) throw DamagedBytes("its checksum is wrong");
    return payload;
}

} // namespace

void serialize(const SurfaceModel& model, const TakeBytes& sink) {
    // The header tells what comes after it, so the model is gone through twice.
    Checksum sum;
    std::uint64_t size = 0;
    Writer measure{ByteWriter([&](std::string_view piece) {
        sum.add(piece);
        size += piece.size();
    })};
    measure(model);
    measure.out.flush();

    Writer writer{ByteWriter(sink)};
    writer.out.put_bytes(magic);
    writer.out.put(model_serialization_version);
    writer.out.put(sum.value());
    writer.out.put(size);
    writer(model);
    writer.out.flush();
}

std::string serialize(const SurfaceModel& model) {
    std::string bytes;
    serialize(model, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

SurfaceModel deserialize(std::string_view bytes, const std::string& file) {
    try {
        Reader reader{ByteReader(checked_payload(bytes))};
        SurfaceModel model;
        reader(model);
        if (reader.in.remaining() != 0) throw DamagedBytes("bytes follow its end");
        if (const auto fault = structural_fault(model)) throw DamagedBytes(*fault);
        return model;
    } catch (const DamagedBytes& damage) {
        throw Error(file, "", std::string("not a sound serialised model: ") + damage.what());
    }
}

} // namespace keiko
