#include "keiko/base/error.h"
#include "keiko/io/cad/cad_import.h"
#include "keiko/io/model_serialization.h"
#include "keiko/io/subdivision/subdivision_model.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>

// keiko-import FILE FORMAT MEMORY_LIMIT, started by load_model: reads a CAD file with OpenCASCADE
// or a cage with OpenSubdiv and answers on file descriptor 3 (stdout when that is closed), as
// worker_answer.h says.

namespace {

using namespace keiko;

/// Where the answer goes.
std::FILE* answer_stream() {
    std::FILE* stream = fdopen(3, "wb");
    return stream ? stream : stdout;
}

void limit_resources(const char* memory_limit) {
    // A worker must not outlive the program that asked, nor leave core files behind.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
#ifndef __SANITIZE_ADDRESS__ // which reserves terabytes of address space
    const rlim_t bytes = std::strtoull(memory_limit, nullptr, 10);
    const rlimit memory{bytes, bytes};
    if (bytes > 0) setrlimit(RLIMIT_AS, &memory);
#else
    (void)memory_limit;
#endif
}

ModelFormat format_named(const std::string& name) {
    for (const ModelFormat format :
         {ModelFormat::step, ModelFormat::iges, ModelFormat::brep, ModelFormat::cage})
        if (name == name_of(format)) return format;
    throw Error("", "", "keiko-import: unknown format " + name);
}

SurfaceModel read(const std::string& file, ModelFormat format,
                  const std::function<void(double)>& progress) {
    if (format != ModelFormat::cage) return cad::import_cad_file(file, format, progress);
    Job job;
    job.progress = [&](const Progress& part) { progress(part.fraction); };
    return read_subdivision_file(file, job);
}

void answer(std::FILE* out, const std::string& file, const std::string& format) {
    double told = 0;
    const auto progress = [&](double done) {
        if (done < told + 0.02) return;
        told = done;
        std::fprintf(out, "progress %.3f\n", done);
        std::fflush(out);
    };
    const std::string bytes = serialize(read(file, format_named(format), progress));
    std::fputs("model\n", out);
    std::fwrite(bytes.data(), 1, bytes.size(), out);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: keiko-import FILE STEP|IGES|BREP|OBJ MEMORY_LIMIT\n", stderr);
        return 2;
    }
    limit_resources(argv[3]);
    std::FILE* out = answer_stream();
    int code = 0;
    try {
        answer(out, argv[1], argv[2]);
    } catch (const Error& e) {
        if (!e.where().empty()) std::fprintf(out, "where %s\n", e.where().c_str());
        std::fprintf(out, "error %s\n", e.reason().c_str());
        code = 1;
    } catch (const std::bad_alloc&) {
        std::fputs("error needs more memory than the reader may use\n", out);
        code = 1;
    } catch (const std::exception& e) {
        std::fprintf(out, "error %s\n", e.what());
        code = 1;
    } catch (...) {
        std::fputs("error OpenCASCADE failed on it\n", out);
        code = 1;
    }
    std::fflush(out);
    // Skips OpenCASCADE's own clean-up, which costs time and crashes after some files.
    _exit(code);
}
