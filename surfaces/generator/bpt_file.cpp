#include "bpt_file.h"

#include "digits.h"

#include <fstream>
#include <stdexcept>
#include <string>

namespace keiko::fixtures {
void write_bpt(const std::filesystem::path& file, const std::vector<Net>& patches) {
    std::ofstream out(file, std::ios::binary);
    out << patches.size() << '\n';
    for (const Net& net : patches) {
        out << net.size_u() - 1 << ' ' << net.size_v() - 1 << '\n';
        for (int i = 0; i < net.size_u(); ++i)
            for (int j = 0; j < net.size_v(); ++j)
                out << digits(net(i, j).X()) << ' ' << digits(net(i, j).Y()) << ' '
                    << digits(net(i, j).Z()) << '\n';
    }
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

} // namespace keiko::fixtures
