#include "keiko/cli/print.h"

#include "keiko/base/text.h"

#include <iostream>

namespace keiko::cli {

void print(std::string_view lines) {
    std::cout << terminal_text(lines);
}

} // namespace keiko::cli
