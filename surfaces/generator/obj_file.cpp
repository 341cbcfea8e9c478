#include "obj_file.h"

#include "digits.h"

#include <fstream>
#include <stdexcept>

namespace keiko::fixtures {

void write_obj(const std::filesystem::path& file, const CageFixture& cage) {
    std::ofstream out(file, std::ios::binary);
    for (const gp_XYZ& p : cage.vertices)
        out << "v " << digits(p.X()) << ' ' << digits(p.Y()) << ' ' << digits(p.Z()) << '\n';
    std::string group;
    for (const CageFixture::Face& face : cage.faces) {
        if (face.group != group) out << "g " << face.group << '\n';
        group = face.group;
        out << 'f';
        for (const int corner : face.corners) out << ' ' << corner + 1;
        out << '\n';
    }
    for (const std::string& tag : cage.tags) out << "t " << tag << '\n';
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

} // namespace keiko::fixtures
