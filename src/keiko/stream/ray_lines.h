#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/math/bounds.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Source of a stream of bytes: fills the front of the span with the available bytes, at least one,
/// and returns their number; 0: the end.
using ByteSource = std::function<std::size_t(std::span<char>)>;

/// The columns of a line of rays: origin and direction. The first line of a file may name them.
constexpr std::string_view ray_header = "ox,oy,oz,dx,dy,dz";
/// The columns of a line of points on surfaces: position and normal.
constexpr std::string_view point_header = "x,y,z,nx,ny,nz";
/// Longest line in bytes; six numbers need less than 200.
constexpr std::size_t longest_ray_line = 1024;

/// Whole lines of a file of rays.
struct RayLines {
    std::string text;             ///< the lines, with their breaks
    std::uint64_t first_line = 1; ///< number of its first line in the file
    std::uint64_t first_ray = 0;  ///< number of its first ray
};

/// Cuts a stream into pieces of whole lines, one piece for each read, so that a sender that waits
/// after a ray receives its answer. Leaves out a UTF-8 byte order mark, the first line if it is the
/// header, and blank lines at the end of the stream; a blank line before a ray stays, for rays_of
/// to refuse.
class RayLineReader {
public:
    /// Reader of a source whose first line may be the header.
    explicit RayLineReader(ByteSource source, std::string_view header = ray_header)
        : source_(std::move(source)), header_(header) {}

    /// Fills `lines` anew; false at the end. A line beyond the longest comes in several pieces;
    /// rays_of refuses the first one.
    bool read(RayLines& lines);

private:
    bool fill(std::string& text);
    void drop_header(RayLines& lines);
    void hold_blank_lines(RayLines& lines);

    ByteSource source_;
    std::string_view header_;
    std::string rest_; ///< the beginning of a line
    std::uint64_t next_line_ = 1, next_ray_ = 0;
    std::optional<std::uint64_t> blank_line_; ///< the first of the blank lines that may be the last
                                              ///< ones
    bool ended_ = false;
};

/// The rays of some lines, up to the first line that is no ray.
struct ParsedRays {
    std::vector<Ray> rays;      ///< in the order of the lines
    std::optional<Error> fault; ///< names the line and the field
};

/// One ray a line: six finite decimal numbers between commas, with or without blanks around them.
/// The origin is within 1e15 mm of zero, the direction no zero vector. Points are read as rays
/// along their normals; the header names the columns in errors.
ParsedRays rays_of(const RayLines& lines, std::string_view header = ray_header);

/// Throws FieldError, which names the field and the index of the ray, for the first ray that
/// rays_of would refuse, or that end_before_far_origins() would in the sight of a body with these
/// bounds.
void require_rays(std::span<const Ray> rays, const std::string& field, const Box3& body,
                  std::string_view header = ray_header);

/// Ends the rays of `lines` before one of them, for a `reason` about its origin.
void end_before(ParsedRays& parsed, const RayLines& lines, std::size_t ray,
                const std::string& reason, std::string_view header = ray_header);

/// Ends the rays of `lines` before the first whose origin is too far from a body with these bounds:
/// 1e8 times its size. At that distance doubles do not resolve the intersection, and a tracer finds
/// nothing.
void end_before_far_origins(ParsedRays& parsed, const RayLines& lines, const Box3& body);

} // namespace keiko
