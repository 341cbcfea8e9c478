#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace keiko {

/// Parser of the answer of a worker as it comes in. The answer is lines "progress FRACTION", then
/// "error REASON", "model", "curves" or "mesh". A line "where PLACE" comes before the reason if the
/// place is known. The bytes of the result follow the last three up to the end: a serialised model,
/// serialised curves, a file of curves, or a serialised mesh. The worker is not trusted: whatever
/// it writes, nothing but an Error naming `file` comes of it.
class WorkerAnswer {
public:
    /// `most_bytes` of a result are taken; 0: any number. Progress goes to `job` as "import".
    WorkerAnswer(std::string file, std::uint64_t most_bytes, const Job& job)
        : file_(std::move(file)), most_bytes_(most_bytes), job_(job) {}

    /// Throws Error for a line that is none of those, and for a result beyond `most_bytes`.
    void receive(std::string_view bytes);

    /// Whether the result, or a part of it, has come.
    bool has_result() const { return has_result_; }
    /// Fault of the file that the worker reports; empty: none.
    const std::string& reason() const { return reason_; }
    /// Bytes of the result. Throws Error with the worker's reason, or when there is no result.
    const std::string& result() const;
    /// The result as a model. Throws Error as result(), or when it is no sound model.
    SurfaceModel model() const;

private:
    void take_line();
    [[noreturn]] void fail(const std::string& reason) const;

    std::string file_;
    std::uint64_t most_bytes_;
    const Job& job_;
    std::string line_, reason_, where_, result_;
    bool has_result_ = false;
};

} // namespace keiko
