#include "keiko/base/error.h"
#include "keiko/files/model/curve_serialization.h"
#include "keiko/files/model/mesh_serialization.h"
#include "keiko/files/model/model_serialization.h"
#include "keiko/import/cad/cad_import.h"
#include "keiko/import/cad/curve_files.h"
#include "keiko/import/cad/face_meshes.h"
#include "keiko/import/subdivision/subdivision_model.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <vector>

// keiko-import FILE FORMAT MEMORY_LIMIT THREADS, started by load_model: reads a CAD file with
// OpenCASCADE or a cage with OpenSubdiv. It answers on file descriptor 3 (stdout when that is
// closed), as worker_answer.h says.
// With `write-curves` for FILE it answers with a STEP or IGES file of the serialised curves on
// stdin. With `read-curves` before FILE it answers with the serialised curves of a file. With
// `mesh` and a number of mm for FILE and FORMAT it answers with triangles of the serialised model
// on stdin, which leave its surfaces by about so much. With the one argument `versions` it answers
// with a line for each of the two libraries.

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

/// Request of the program that started this.
struct Request {
    enum class Kind { model, write_curves, read_curves, mesh };
    Kind kind = Kind::model;
    std::string file;   ///< to read
    std::string format; ///< of the file; of a mesh the deviation, mm
    std::string memory_limit;
    int threads = 0;
};

/// The whole of stdin.
std::string input() {
    std::string bytes;
    std::array<char, 1 << 16> piece;
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), stdin))
        bytes.append(piece.data(), count);
    return bytes;
}

void answer_with_curves(std::FILE* out, const Request& request) {
    const ModelFormat format = format_named(request.format);
    const std::string bytes =
        request.kind == Request::Kind::read_curves
            ? serialize(cad::read_curves(request.file, format))
            : cad::curve_file(deserialize_curves(input(), "keiko-import"), format);
    std::fputs("curves\n", out);
    std::fwrite(bytes.data(), 1, bytes.size(), out);
}

void answer_with_mesh(std::FILE* out, const Request& request, const Job& job) {
    const SurfaceModel model = deserialize(input(), "keiko-import");
    const double deviation = std::strtod(request.format.c_str(), nullptr);
    const std::string bytes = serialize(cad::mesh_faces(model, deviation, job));
    std::fputs("mesh\n", out);
    std::fwrite(bytes.data(), 1, bytes.size(), out);
}

void answer(std::FILE* out, const Request& request) {
    double told = 0;
    Job job;
    job.threads = request.threads;
    job.progress = [&](const Progress& progress) {
        if (progress.fraction < told + 0.02) return;
        told = progress.fraction;
        std::fprintf(out, "progress %.3f\n", told);
        std::fflush(out);
    };
    if (request.kind == Request::Kind::mesh) return answer_with_mesh(out, request, job);
    if (request.kind != Request::Kind::model) return answer_with_curves(out, request);
    const SurfaceModel model = read(request.file, format_named(request.format), job);
    std::fputs("model\n", out);
    serialize(model,
              [&](std::string_view piece) { std::fwrite(piece.data(), 1, piece.size(), out); });
}

/// The request of the command line; nullopt for another one.
std::optional<Request> request_of(std::vector<std::string> words) {
    Request request;
    if (words.size() == 5 && words[0] == "read-curves") {
        request.kind = Request::Kind::read_curves;
        words.erase(words.begin());
    } else if (words.size() == 4 && words[0] == "write-curves") {
        request.kind = Request::Kind::write_curves;
    } else if (words.size() == 4 && words[0] == "mesh") {
        request.kind = Request::Kind::mesh;
    }
    if (words.size() != 4) return std::nullopt;
    request.file = words[0], request.format = words[1], request.memory_limit = words[2];
    request.threads = std::atoi(words[3].c_str());
    return request;
}

int tell_versions() {
    std::FILE* out = answer_stream();
    std::fputs("OpenCASCADE " KEIKO_OPENCASCADE "\nOpenSubdiv " KEIKO_OPENSUBDIV "\n", out);
    return std::fflush(out) == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "versions") return tell_versions();
    const auto request = request_of({argv + 1, argv + argc});
    if (!request) {
        std::fputs(
            "usage: keiko-import [read-curves] FILE STEP|IGES|BREP|OBJ MEMORY_LIMIT THREADS\n"
            "       keiko-import write-curves STEP|IGES MEMORY_LIMIT THREADS\n"
            "       keiko-import mesh DEVIATION MEMORY_LIMIT THREADS\n",
            stderr);
        return 2;
    }
    limit_resources(request->memory_limit.c_str());
    std::FILE* out = answer_stream();
    int code = 0;
    try {
        answer(out, *request);
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
