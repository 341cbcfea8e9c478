#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/base/parallel.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/stream/ray_lines.h"
#include "keiko/workflow/open_scene.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Sink of a stream of bytes; returns false if no reader is left.
using ByteSink = std::function<bool(std::string_view)>;

/// Options of trace_rays.
struct TraceOptions {
    std::string columns = "t,face,u,v,x,y,z,nx,ny,nz"; ///< names of HitColumn
    bool all = false; ///< every hit by rising t, after a column `ray`, rather than the first
};

/// Counts of the rays that trace_rays has processed.
struct TraceCounts {
    std::uint64_t rays = 0; ///< number of rays
    HitStatistics hits;     ///< how their hits were found
};

/// Throws Error, before the long work, for columns that trace_rays would refuse for any scene.
void require_columns(const TraceOptions& options);

/// Reads lines of rays (see rays_of) and writes hits as CSV: a header line, then for each ray in
/// order the row of its first hit, with empty fields if there is none. With `all` each hit has a
/// row, led by the number of its ray from 0; a ray without hits has one with that number alone.
/// Rows are written as rays come, in constant memory, and are the same bytes for any thread count.
/// Ends early if the sink accepts no more. Throws Error for the first malformed line, after the
/// rows of those before it.
TraceCounts trace_rays(const Scene& scene, const ByteSource& rays, const ByteSink& hits,
                       const TraceOptions& options = {}, const Job& job = {});

/// A piece of a stream of rays between lines and rows.
struct RowPiece {
    RayLines lines;             ///< that were read
    std::string rows;           ///< that are to be written
    std::optional<Error> fault; ///< of the first malformed line, behind the rows before it
};

/// Streams pieces (of a type derived from RowPiece) in constant memory and in order: `work(piece)`
/// fills one on any thread, `count(piece)` is called for each before its rows are written. Ends
/// early if the sink accepts no more; throws a piece's fault.
template <class Piece, class Work, class Count>
void stream_rows(RayLineReader& reader, const ByteSink& sink, const Job& job, const Work& work,
                 const Count& count) {
    std::vector<Piece> pieces(2 * thread_count(job) + 1);
    const auto write = [&](std::size_t slot) {
        const Piece& piece = pieces[slot];
        count(piece);
        if (!piece.rows.empty() && !sink(piece.rows)) return false;
        if (piece.fault) throw *piece.fault;
        return true;
    };
    parallel_stream(pieces.size(), job,
                    {.read = [&](std::size_t slot) { return reader.read(pieces[slot].lines); },
                     .work = [&](std::size_t slot) { work(pieces[slot]); },
                     .write = write});
}

} // namespace keiko
