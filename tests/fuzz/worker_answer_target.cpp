// what the import worker hands over: progress, then an error or a model
#include "keiko/import/worker/worker_answer.h"

#include "tests/fuzz/sound_model.h"

#include <cmath>
#include <optional>

namespace {

using namespace keiko;

constexpr std::uint64_t most_bytes = 1 << 16;

/// The model that arrives in pieces of at most `piece` bytes, or the reason why none does.
struct Outcome {
    std::string error;
    std::string model; ///< serialised
};

Outcome outcome_of(std::string_view text, std::size_t piece) {
    const Job job{.progress = [](const Progress& progress) {
        fuzz::require(progress.fraction >= 0 && progress.fraction <= 1, "progress is a share");
    }};
    WorkerAnswer answer("part.step", most_bytes, job);
    Outcome outcome;
    try {
        for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
            answer.receive(text.substr(0, piece));
        const SurfaceModel model = answer.model();
        fuzz::require_sound(model);
        outcome.model = serialize(model);
    } catch (const Error& error) {
        fuzz::require_clear(error);
        outcome.error = error.what();
    }
    return outcome;
}

} // namespace

/// The first byte tells how large the pieces are in which the answer arrives.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text = fuzz::text_of(data, size).substr(1);
    const Outcome whole = outcome_of(text, text.size() + 1);
    const Outcome parts = outcome_of(text, data[0] + std::size_t{1});
    fuzz::require(whole.error == parts.error && whole.model == parts.model,
                  "the answer does not depend on the pieces it arrives in");
    return 0;
}
