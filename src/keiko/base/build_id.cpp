#include "keiko/base/build_id.h"

#include "keiko/base/error.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace keiko {
namespace {

/// Any address in the file that this code was linked into.
constexpr char own_data = 0;

bool is_loaded_from(const dl_phdr_info& object, ElfW(Addr) address) {
    for (const ElfW(Phdr)* part = object.dlpi_phdr; part != object.dlpi_phdr + object.dlpi_phnum;
         ++part) {
        const ElfW(Addr) begin = object.dlpi_addr + part->p_vaddr;
        if (part->p_type == PT_LOAD && address >= begin && address - begin < part->p_memsz)
            return true;
    }
    return false;
}

std::string hexadecimal(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        text += digits[byte >> 4], text += digits[byte & 15];
    }
    return text;
}

/// Build id among the notes of a segment; empty: none. A note is a header, its owner's name and its
/// description, both padded to the segment's alignment.
std::string id_among(std::string_view notes, std::size_t alignment) {
    constexpr std::string_view owner("GNU\0", 4);
    const auto padded = [&](std::size_t size) { return (size + alignment - 1) & ~(alignment - 1); };
    while (notes.size() >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note;
        std::memcpy(&note, notes.data(), sizeof note);
        notes.remove_prefix(sizeof note);
        const std::size_t begin = padded(note.n_namesz), end = begin + padded(note.n_descsz);
        if (end > notes.size()) break;
        if (note.n_type == NT_GNU_BUILD_ID && notes.substr(0, note.n_namesz) == owner)
            return hexadecimal(notes.substr(begin, note.n_descsz));
        notes.remove_prefix(end);
    }
    return "";
}

/// For dl_iterate_phdr: takes the build id of the object with `own_data`, and stops there.
int find_own_id(dl_phdr_info* object, std::size_t, void* id) {
    if (!is_loaded_from(*object, reinterpret_cast<ElfW(Addr)>(&own_data))) return 0;
    for (const ElfW(Phdr)* part = object->dlpi_phdr; part != object->dlpi_phdr + object->dlpi_phnum;
         ++part) {
        if (part->p_type != PT_NOTE) continue;
        // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader tells addresses as integers
        const auto* begin = reinterpret_cast<const char*>(object->dlpi_addr + part->p_vaddr);
        const std::string found = id_among({begin, part->p_memsz}, part->p_align == 8 ? 8 : 4);
        if (!found.empty()) *static_cast<std::string*>(id) = found;
    }
    return 1;
}

} // namespace

std::filesystem::path binary_path() {
    Dl_info info;
    link_map* map = nullptr;
    std::error_code failure;
    const bool found =
        dladdr1(&own_data, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    // The program itself has no name in the list of what is loaded. Its link holds where it was
    // started from even if it was built anew meanwhile.
    if (!found || !map || !*map->l_name)
        return std::filesystem::read_symlink("/proc/self/exe", failure);
    const std::filesystem::path file = map->l_name;
    const std::filesystem::path real = std::filesystem::canonical(file, failure);
    return failure ? file : real;
}

std::string build_id() {
    std::string id;
    dl_iterate_phdr(find_own_id, &id);
    if (id.empty()) throw Error("", "", "Keiko was linked without a build id");
    return id;
}

} // namespace keiko
