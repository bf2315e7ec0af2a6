#include "loosefit/base/build_id.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace loosefit {
namespace {

struct Search {
  ElfW(Addr) inside;  ///< an address of the object that is looked for
  std::string found;
};

bool holds(const dl_phdr_info& object, ElfW(Addr) address) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object.dlpi_phdr[i];
    const ElfW(Addr) begin = object.dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && address >= begin && address < begin + part.p_memsz) return true;
  }
  return false;
}

/// Notes stand one after another: head, name and content, each padded to four bytes.
std::string build_id_among(const unsigned char* notes, std::size_t size) {
  constexpr std::size_t kPadding = 4;
  const auto padded = [](std::size_t n) { return (n + kPadding - 1) / kPadding * kPadding; };
  std::size_t at = 0;
  while (at + sizeof(ElfW(Nhdr)) <= size) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes + at, sizeof head);
    const std::size_t content = at + sizeof head + padded(head.n_namesz);
    if (content + head.n_descsz > size) break;
    const std::string_view owner(reinterpret_cast<const char*>(notes + at + sizeof head),
                                 head.n_namesz);
    if (head.n_type == NT_GNU_BUILD_ID && owner == std::string_view("GNU", 4)) {
      std::string digits;
      for (std::size_t i = 0; i < head.n_descsz; ++i)
        digits += fmt::format("{:02x}", notes[content + i]);
      return digits;
    }
    at = content + padded(head.n_descsz);
  }
  return {};
}

int look(dl_phdr_info* object, std::size_t, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (!holds(*object, search.inside)) return 0;
  for (int i = 0; i < object->dlpi_phnum && search.found.empty(); ++i) {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    if (part.p_type == PT_NOTE)
      search.found = build_id_among(
          reinterpret_cast<const unsigned char*>(object->dlpi_addr + part.p_vaddr), part.p_memsz);
  }
  return 1;
}

}  // namespace

std::string build_id() {
  Search search{reinterpret_cast<ElfW(Addr)>(&build_id), {}};
  dl_iterate_phdr(look, &search);
  return search.found;
}

}  // namespace loosefit
