#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace keiko {

/// Parser of the answer of a worker as it comes in. The answer is lines "progress FRACTION", then
/// "error REASON" or "model". A line "where PLACE" comes before the reason if the place is known.
/// The serialised model follows "model" up to the end. The worker is not trusted: whatever it
/// writes, nothing but an Error naming `file` comes of it.
class WorkerAnswer {
public:
    /// `most_bytes` of a model are taken; 0: any number. Progress goes to `job` as "import".
    WorkerAnswer(std::string file, std::uint64_t most_bytes, const Job& job)
        : file_(std::move(file)), most_bytes_(most_bytes), job_(job) {}

    /// Throws Error for a line that is none of those, and for a model beyond `most_bytes`.
    void receive(std::string_view bytes);

    /// Whether the model, or a part of it, has come.
    bool has_model() const { return has_model_; }
    /// Fault of the file that the worker reports; empty: none.
    const std::string& reason() const { return reason_; }
    /// Throws Error with the worker's reason, or when there is no sound model.
    SurfaceModel model() const;

private:
    void take_line();
    [[noreturn]] void fail(const std::string& reason) const;

    std::string file_;
    std::uint64_t most_bytes_;
    const Job& job_;
    std::string line_, reason_, where_, model_;
    bool has_model_ = false;
};

} // namespace keiko
