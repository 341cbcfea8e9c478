#pragma once

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/stream/ray_lines.h"
#include "keiko/stream/trace_rays.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// A piece of a stream of rays on its way from lines to rows.
struct RowPiece {
    RayLines lines;
    std::string rows;
    std::optional<Error> fault; ///< of the first malformed line, behind the rows before it
};

/// Streams pieces (of a type made from RowPiece) in constant memory and in order: `work(piece)`
/// fills one on any thread, `count(piece)` is told of each before its rows are written. Ends early
/// when the sink wants no more; throws a piece's fault.
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
