#include "keiko/base/error.h"
#include "keiko/files/model/model_serialization.h"
#include "keiko/import/cad/cad_import.h"
#include "keiko/import/subdivision/subdivision_model.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

// keiko-import FILE FORMAT MEMORY_LIMIT THREADS, started by load_model: reads a CAD file with
// OpenCASCADE or a cage with OpenSubdiv and answers on file descriptor 3 (stdout when that is
// closed), as worker_answer.h says.
// With the one argument `versions` it answers with a line for each of the two libraries.

namespace {

using namespace keiko;

/// Stream of the answer.
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

SurfaceModel read(const std::string& file, ModelFormat format, const Job& job) {
    return format == ModelFormat::cage ? read_subdivision_file(file, job)
                                       : cad::import_cad_file(file, format, job);
}

void answer(std::FILE* out, const std::string& file, const std::string& format, int threads) {
    double told = 0;
    Job job;
    job.threads = threads;
    job.progress = [&](const Progress& progress) {
        if (progress.fraction < told + 0.02) return;
        told = progress.fraction;
        std::fprintf(out, "progress %.3f\n", told);
        std::fflush(out);
    };
    const SurfaceModel model = read(file, format_named(format), job);
    std::fputs("model\n", out);
    serialize(model,
              [&](std::string_view piece) { std::fwrite(piece.data(), 1, piece.size(), out); });
}

int tell_versions() {
    std::FILE* out = answer_stream();
    std::fputs("OpenCASCADE " KEIKO_OPENCASCADE "\nOpenSubdiv " KEIKO_OPENSUBDIV "\n", out);
    return std::fflush(out) == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "versions") return tell_versions();
    if (argc != 5) {
        std::fputs("usage: keiko-import FILE STEP|IGES|BREP|OBJ MEMORY_LIMIT THREADS\n", stderr);
        return 2;
    }
    limit_resources(argv[3]);
    std::FILE* out = answer_stream();
    int code = 0;
    try {
        answer(out, argv[1], argv[2], std::atoi(argv[4]));
    } catch (const Error& e) {
        if (!e.where().empty()) std::fprintf(out, "where %s\n", shortened(e.where()).c_str());
        std::fprintf(out, "error %s\n", shortened(e.reason()).c_str());
        code = 1;
    } catch (const std::bad_alloc&) {
        std::fputs("error needs more memory than the reader may use\n", out);
        code = 1;
    } catch (const std::exception& e) {
        std::fprintf(out, "error %s\n", shortened(e.what()).c_str());
        code = 1;
    } catch (...) {
        std::fputs("error the reader failed on it\n", out);
        code = 1;
    }
    std::fflush(out);
    // Skips OpenCASCADE's own clean-up, which costs time and crashes after some files.
    _exit(code);
}
