#include "compiler/scene/isolated_reader.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "runtime/base/write_all.h"

namespace aspect {
namespace {

constexpr rlim_t kMaxBytes = rlim_t{8} << 30, kMaxSeconds = 300;
constexpr char kMesh = 'M', kError = 'E';

void write_bytes(int descriptor, const void* data, std::size_t bytes) {
  if (!write_all(descriptor, {static_cast<const char*>(data), bytes})) ::_exit(1);
}

template <typename Value>
void write_list(int descriptor, const std::vector<Value>& list) {
  const std::uint64_t count = list.size();
  write_bytes(descriptor, &count, sizeof count);
  write_bytes(descriptor, list.data(), list.size() * sizeof(Value));
}

void write_text(int descriptor, const std::string& text) {
  write_list(descriptor, std::vector<char>(text.begin(), text.end()));
}

void write_mesh(int descriptor, const ColouredMesh& mesh) {
  write_bytes(descriptor, &kMesh, 1);
  write_list(descriptor, mesh.vertices);
  write_list(descriptor, mesh.triangles);
  write_list(descriptor, mesh.colours);
  write_list(descriptor, mesh.part_of);
  std::string names;
  for (const MeshPart& part : mesh.parts) names += part.name + '\0' + part.material + '\0';
  write_text(descriptor, names);
  std::string warnings;
  for (const std::string& warning : mesh.warnings) warnings += warning + '\0';
  write_text(descriptor, warnings);
  std::string missing;
  for (const MissingColour& colour : mesh.missing)
    missing += fmt::format("{0}{4}{1}{4}{2}{4}{3}{4}", colour.file, colour.line, colour.what,
                           colour.cure, '\0');
  write_text(descriptor, missing);
  for (const MissingColour& colour : mesh.missing) write_list(descriptor, colour.parts);
  std::string files;
  for (const std::string& file : mesh.files) files += file + '\0';
  write_text(descriptor, files);
}

[[noreturn]] void run_child(int descriptor, const std::function<ColouredMesh()>& read) {
#ifndef __SANITIZE_ADDRESS__  // which reserves far more
  const rlimit memory{kMaxBytes, kMaxBytes};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit time{kMaxSeconds, kMaxSeconds}, no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int chatter : {STDOUT_FILENO, STDERR_FILENO})
    if (nowhere >= 0) ::dup2(nowhere, chatter);
  std::string failure, file;
  std::uint64_t line = 0;
  try {
    write_mesh(descriptor, read());
    ::_exit(0);
  } catch (const MeshError& error) {
    failure = error.what();
    file = error.file();
    line = error.line();
  } catch (const std::exception& error) {
    failure = std::string("cannot be read (") + error.what() + "); export it again";
  }
  write_bytes(descriptor, &kError, 1);
  write_text(descriptor, failure);
  write_text(descriptor, file);
  write_list(descriptor, std::vector<std::uint64_t>{line});
  ::_exit(0);
}

std::string read_all(int descriptor) {
  std::string bytes;
  std::vector<char> buffer(1 << 20);
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

[[noreturn]] void fail_broken() {
  throw MeshError("breaks its reader, or needs too much memory or time; export it again");
}

// The child's answer from its front; a broken child may have sent anything.
class Answer {
 public:
  explicit Answer(const std::string& bytes) : bytes_(bytes) {}

  char mark() { return bytes_.empty() ? '\0' : bytes_[position_++]; }

  template <typename Value>
  std::vector<Value> list() {
    std::uint64_t count = 0;
    take(&count, sizeof count);
    if (count > (bytes_.size() - position_) / sizeof(Value)) fail_broken();
    std::vector<Value> values(count);
    take(values.data(), count * sizeof(Value));
    return values;
  }
  std::string text() {
    const std::vector<char> letters = list<char>();
    return {letters.begin(), letters.end()};
  }
  std::vector<std::string> texts() {
    std::vector<std::string> result(1);
    for (const char letter : text())
      if (letter == '\0')
        result.emplace_back();
      else
        result.back() += letter;
    result.pop_back();
    return result;
  }

 private:
  void take(void* to, std::size_t count) {
    if (bytes_.size() - position_ < count) fail_broken();
    if (count > 0) std::memcpy(to, bytes_.data() + position_, count);
    position_ += count;
  }

  const std::string& bytes_;
  std::size_t position_ = 0;
};

ColouredMesh mesh_in(Answer& answer) {
  ColouredMesh mesh;
  mesh.vertices = answer.list<Eigen::Vector3d>();
  mesh.triangles = answer.list<std::array<std::uint32_t, 3>>();
  mesh.colours = answer.list<Eigen::Vector3d>();
  mesh.part_of = answer.list<std::uint32_t>();
  const std::vector<std::string> names = answer.texts();
  for (std::size_t k = 0; k + 1 < names.size(); k += 2)
    mesh.parts.push_back({names[k], names[k + 1]});
  mesh.warnings = answer.texts();
  const std::vector<std::string> missing = answer.texts();
  for (std::size_t k = 0; k + 3 < missing.size(); k += 4)
    mesh.missing.push_back({missing[k], std::strtoull(missing[k + 1].c_str(), nullptr, 10),
                            missing[k + 2], missing[k + 3], answer.list<std::uint32_t>()});
  mesh.files = answer.texts();
  if (mesh.colours.size() != mesh.triangles.size() || mesh.part_of.size() != mesh.triangles.size())
    fail_broken();
  return mesh;
}

}  // namespace

ColouredMesh read_isolated(const std::function<ColouredMesh()>& read) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) throw MeshError("no pipe can be made; close other programs");
  const pid_t child = ::fork();
  if (child == 0) run_child(ends[1], read);
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    throw MeshError("no process can be started; close other programs");
  }
  const std::string bytes = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Answer answer(bytes);
  const char mark = answer.mark();
  if (status != 0 || (mark != kMesh && mark != kError)) fail_broken();
  if (mark == kMesh) return mesh_in(answer);
  const std::string failure = answer.text(), file = answer.text();
  const std::vector<std::uint64_t> line = answer.list<std::uint64_t>();
  throw MeshError(failure, line.empty() ? 0 : line.front(), file);
}

}  // namespace aspect
