#include "tools/aspectc/record/program_identity.h"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "tools/aspectc/record/content_hash.h"

namespace aspect {
namespace {

// Sizes of a note's name and contents are rounded up to whole words.
std::size_t padded(std::size_t bytes) {
  return (bytes + 3) & ~std::size_t{3};
}

// Empty where there is none among these notes.
std::string_view build_id_in(std::string_view notes) {
  ElfW(Nhdr) head{};
  while (notes.size() >= sizeof head) {
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t name = sizeof head, id = name + padded(head.n_namesz);
    if (id > notes.size() || head.n_descsz > notes.size() - id) return {};
    if (head.n_type == NT_GNU_BUILD_ID && notes.substr(name, head.n_namesz).starts_with("GNU"))
      return notes.substr(id, head.n_descsz);
    notes.remove_prefix(std::min(notes.size(), id + padded(head.n_descsz)));
  }
  return {};
}

int add_object(dl_phdr_info* object, std::size_t /*size*/, void* to) {
  auto& identity = *static_cast<std::string*>(to);
  const std::string_view file = object->dlpi_name;
  if (file.starts_with("linux-")) return 0;  // the kernel's, in which no work is done
  for (int k = 0; k < object->dlpi_phnum; ++k) {
    const auto& part = object->dlpi_phdr[k];
    if (part.p_type != PT_NOTE) continue;
    const auto* first = reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr);
    const std::string_view id = build_id_in({first, part.p_memsz});
    if (id.empty()) continue;
    identity += id;
    return 0;
  }
  identity += content_hash_of_file(file.empty() ? "/proc/self/exe" : std::string(file));
  return 0;
}

}  // namespace

std::string program_identity() {
  std::string identity;
  ::dl_iterate_phdr(add_object, &identity);
  return content_hash(identity);
}

}  // namespace aspect
