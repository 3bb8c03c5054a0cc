#include "tools/aspectc/record/content_hash.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cerrno>
#include <memory>
#include <set>
#include <vector>

namespace aspect {
namespace {

struct StateDeleter {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& file)
      : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

std::string lower_case(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

// Of the first step of the path that is not there.
std::string absence(std::filesystem::path file) {
  std::error_code fault;
  while (file.has_parent_path() && file != file.parent_path() &&
         !std::filesystem::exists(file.parent_path(), fault))
    file = file.parent_path();
  const std::string name = file.filename().string(), wanted = lower_case(name);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::set<std::string> alike;
  std::filesystem::directory_iterator entry(folder, fault);
  for (; !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
    std::string other = entry->path().filename().string();
    if (other != name && lower_case(other) == wanted) alike.insert(std::move(other));
  }
  std::string names;
  for (const std::string& other : alike) names += other + '\0';
  return names.empty() ? kAbsent : fmt::format("{}:{}", kAbsent, content_hash(names));
}

std::string text_of(XXH128_hash_t hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string content_hash(std::string_view bytes) {
  return text_of(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string content_hash_of_file(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return absence(file);
  const OpenFile open(file);
  const std::unique_ptr<XXH3_state_t, StateDeleter> state(XXH3_createState());
  if (open.descriptor() < 0 || state == nullptr) return "unreadable";
  XXH3_128bits_reset(state.get());
  std::vector<char> buffer(1 << 20);
  for (;;) {
    const ssize_t count = ::read(open.descriptor(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return "unreadable";
    if (count == 0) return text_of(XXH3_128bits_digest(state.get()));
    XXH3_128bits_update(state.get(), buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace aspect
