// The store between processes: locked, killed, short of space, without permission. SQLite must not
// be carried across a fork, so every child is forked while no store is open.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstring>
#include <functional>
#include <thread>
#include <utility>

#include "compiler/store/store.h"
#include "tests/compiler/store/store_samples.h"

namespace aspect {
namespace {

using Catch::Contains;
using Clock = std::chrono::steady_clock;

// A forked process that runs one function and can talk to us.
class Child {
 public:
  explicit Child(const std::function<void(Child&)>& run) {
    REQUIRE(pipe(to_parent_.data()) == 0);
    REQUIRE(pipe(to_child_.data()) == 0);
    id_ = fork();
    REQUIRE(id_ >= 0);
    if (id_ == 0) {
      run(*this);
      _exit(0);
    }
    close(std::exchange(to_parent_[1], -1));
  }
  ~Child() {
    if (id_ > 0) end(SIGKILL);
    for (const int end : {to_parent_[0], to_parent_[1], to_child_[0], to_child_[1]}) close(end);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // In the child.
  void wait_for_start() {
    char start = 0;
    if (read(to_child_[0], &start, 1) != 1) _exit(1);
  }
  void say(const void* bytes, std::size_t size) {
    if (write(to_parent_[1], bytes, size) != static_cast<ssize_t>(size)) _exit(1);
  }

  // In the parent.
  void start() { REQUIRE(write(to_child_[1], "s", 1) == 1); }
  void end(int signal_number) {
    if (signal_number != 0) kill(id_, signal_number);
    waitpid(std::exchange(id_, -1), nullptr, 0);
  }
  std::string all_said() {
    std::string said;
    char buffer[4096];
    for (ssize_t got = 0; (got = read(to_parent_[0], buffer, sizeof buffer)) > 0;) {
      said.append(buffer, static_cast<std::size_t>(got));
    }
    return said;
  }

 private:
  pid_t id_ = -1;
  std::array<int, 2> to_parent_{};
  std::array<int, 2> to_child_{};
};

void become_unprivileged() {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && seteuid(kNobody) != 0) _exit(1);
}

// What opening the store says to a process without privileges.
std::string refusal_unprivileged(const std::filesystem::path& path) {
  Child child([&](Child& self) {
    become_unprivileged();
    const std::string said = attempt(path, sample_key());
    self.say(said.data(), said.size());
  });
  return child.all_said();
}

// Adds views and matches without end, and tells when each had been added.
void add_for_ever(Child& self, const std::filesystem::path& path) {
  Result<Store> store = Store::open(path, sample_key());
  if (!store) _exit(1);
  for (int i = 0;; ++i) {
    if (!store.value().add_view(sample_direction(i), sample_bytes(i)).ok()) _exit(1);
    if (i > 0 &&
        !store.value().add_match(sample_direction(i - 1), sample_direction(i), i, {}).ok()) {
      _exit(1);
    }
    const Clock::time_point added = Clock::now();
    self.say(&added, sizeof added);
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
}

// Opens what a killed writer left and gives back the number of its views, which must be the first
// ones, whole, with all matches between them but possibly the last.
std::size_t count_survivors(const std::filesystem::path& path) {
  const Store store = open_sound(path);
  const std::vector<StoredView> views = views_of(store);
  for (std::size_t i = 0; i < views.size(); ++i) {
    REQUIRE(views[i].direction == sample_direction(static_cast<int>(i)));
    REQUIRE(views[i].view == sample_bytes(static_cast<int>(i)));
  }
  CHECK(matches_of(store).size() + 2 >= views.size());
  return views.size();
}

TEST_CASE("a second process is refused while a store is open, new or old") {
  const TemporaryFolder folder;
  for (int round = 0; round < 2; ++round) {
    Child child([&](Child& self) {
      self.wait_for_start();
      const std::string said = attempt(folder / "a.store", sample_key());
      self.say(said.data(), said.size());
    });
    Store store = open_sound(folder / "a.store");
    child.start();
    CHECK_THAT(child.all_said(), Contains("a.store: in use by another aspectc"));
    CHECK(store.add_view(sample_direction(round), {}).ok());
    CHECK(store.flush().ok());
  }
  CHECK(views_of(open_sound(folder / "a.store")).size() == 2);
}

TEST_CASE("a second opener in the same process is refused") {
  const TemporaryFolder folder;
  const Store store = open_sound(folder / "a.store");
  CHECK_THAT(refusal(folder / "a.store", sample_key()), Contains("in use by another aspectc"));
}

TEST_CASE("a killed writer loses at most its last second") {
  for (const int lifetime_ms : {1300, 2400}) {
    const TemporaryFolder folder;
    Child child([&](Child& self) { add_for_ever(self, folder / "a.store"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(lifetime_ms));
    child.end(SIGKILL);
    const std::string said = child.all_said();
    std::vector<Clock::time_point> added(said.size() / sizeof(Clock::time_point));
    std::memcpy(added.data(), said.data(), added.size() * sizeof(Clock::time_point));

    const std::size_t survivors = count_survivors(folder / "a.store");
    REQUIRE(survivors > 0);
    CHECK(survivors <= added.size() + 1);
    if (survivors < added.size()) {
      CHECK(added.back() - added[survivors] <= std::chrono::seconds(1));
    }
  }
}

TEST_CASE("a writer killed at any time in its first moments leaves a store that opens") {
  for (int round = 0; round < 30; ++round) {
    const TemporaryFolder folder;
    Child child([&](Child& self) { add_for_ever(self, folder / "a.store"); });
    std::this_thread::sleep_for(std::chrono::microseconds(300 * round));
    child.end(SIGKILL);
    count_survivors(folder / "a.store");
  }
}

TEST_CASE("a store that cannot grow says so and keeps what it had") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  Child child([&](Child& self) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 20, 1 << 20};
    setrlimit(RLIMIT_FSIZE, &limit);
    Result<Store> store = Store::open(folder / "a.store", sample_key());
    if (!store) _exit(1);
    for (int i = 1000; i < 10000; ++i) {
      const Result<Done> added = store.value().add_view(sample_direction(i), sample_bytes(i));
      const Result<Done> kept = added.ok() ? store.value().flush() : added;
      if (kept.ok()) continue;
      self.say(kept.error().data(), kept.error().size());
      return;
    }
  });
  const std::string said = child.all_said();
  child.end(0);
  CHECK_THAT(said, Contains("a.store: cannot be read or written (disk I/O error)"));
  CHECK(views_of(open_sound(folder / "a.store")).size() >= 300);
}

TEST_CASE("a read-only folder is refused") {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  CHECK_THAT(refusal_unprivileged(folder / "a.store"),
             Contains("a.store: its folder cannot be written (Permission denied)"));
}

TEST_CASE("a read-only store is refused") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0777));
  std::filesystem::permissions(folder / "a.store", std::filesystem::perms(0444));
  CHECK_THAT(refusal_unprivileged(folder / "a.store"),
             Contains("a.store: cannot be written (Permission denied)"));
}

}  // namespace
}  // namespace aspect
