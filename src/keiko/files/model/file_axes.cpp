#include "keiko/files/model/file_axes.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"

namespace keiko {
namespace {

/// One of x, y, z, -x, -y, -z; of length 0 for any other word.
Vec3 axis_named(std::string_view word) {
    const bool other_end = word.starts_with('-');
    if (other_end) word.remove_prefix(1);
    Vec3 axis(0);
    if (word == "x" || word == "y" || word == "z") axis[word[0] - 'x'] = other_end ? -1 : 1;
    return axis;
}

Affine frame_of(std::string_view axes) {
    Affine frame;
    std::string_view rest = axes;
    for (Vec3& row : frame.rows) {
        const auto end = std::min(rest.find(','), rest.size());
        row = axis_named(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool three_words = rest.empty() && !axes.ends_with(',');
    if (!three_words || frame.determinant() == 0)
        throw Error("", "",
                    "axes " + in_quotes(std::string(axes)) +
                        ": not three words of x, y, z, -x, -y and -z with each letter once");
    if (frame.mirrored())
        throw Error("", "",
                    "axes " + in_quotes(std::string(axes)) +
                        ": would mirror the body; one of them points the other way");
    return frame;
}

} // namespace

void turn_axes(SurfaceModel& model, std::string_view axes) {
    try {
        const Affine frame = frame_of(axes);
        for (Instance& instance : model.instances) instance.transform = frame * instance.transform;
    } catch (const Error& e) {
        throw Error(model.source, "", e.reason());
    }
    model.diagnostics.push_back(
        {Severity::note, "",
         "turned: its " + std::string(axes) + " point rearwards, to the right and up"});
}

} // namespace keiko
