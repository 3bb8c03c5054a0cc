#include "runtime/output/stream_readers.h"

#include <sys/socket.h>
#include <algorithm>
#include <cerrno>
#include <string>

namespace aspect {
namespace {

constexpr std::chrono::minutes kBetweenWarnings{1};

}  // namespace

void StreamReaders::add(Descriptor socket) {
  if (count_ == kMost) {
    ++counters_.readers_refused;
    return;
  }
  readers_[count_++] = {std::move(socket), ring_.published(), 0, false};
  counters_.readers = count_;
}

std::span<pollfd> StreamReaders::waits() {
  const std::uint64_t published = ring_.published();
  for (std::size_t k = 0; k < count_; ++k) {
    const Reader& reader = readers_[k];
    const int events = (reader.silent ? 0 : POLLIN) | (reader.line < published ? POLLOUT : 0);
    waits_[k] = {reader.socket.get(), static_cast<short>(events), 0};
  }
  return std::span(waits_).first(count_);
}

void StreamReaders::serve() {
  for (std::size_t k = 0; k < count_;) {
    Reader& reader = readers_[k];
    Outcome outcome = receive(reader);
    if (outcome == Outcome::stays) outcome = send(reader);
    if (outcome == Outcome::too_slow) count_dropped();
    if (outcome == Outcome::stays)
      ++k;
    else
      remove(k);
  }
}

bool StreamReaders::behind() const {
  const auto behind = [&](const Reader& reader) { return reader.line < ring_.published(); };
  return std::any_of(readers_.begin(), readers_.begin() + static_cast<std::ptrdiff_t>(count_),
                     behind);
}

StreamReaders::Outcome StreamReaders::receive(Reader& reader) {
  std::array<char, 512> thrown_away;
  if (reader.silent) return Outcome::stays;
  const ssize_t received =
      ::recv(reader.socket.get(), thrown_away.data(), thrown_away.size(), MSG_DONTWAIT);
  // Somebody who has nothing to say may still want to listen; if not, sending will tell.
  if (received == 0) reader.silent = true;
  const bool gone = received < 0 && errno != EAGAIN && errno != EINTR;
  return gone ? Outcome::left : Outcome::stays;
}

StreamReaders::Outcome StreamReaders::send(Reader& reader) {
  while (true) {
    const auto [state, line] = ring_.read(reader.line, line_);
    if (state == LineRing::Reading::State::not_yet) return Outcome::stays;
    if (state == LineRing::Reading::State::gone) return Outcome::too_slow;
    const std::string_view rest = line.substr(reader.sent);
    const ssize_t sent =
        ::send(reader.socket.get(), rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0) return errno == EAGAIN || errno == EINTR ? Outcome::stays : Outcome::left;
    reader.sent += static_cast<std::size_t>(sent);
    if (reader.sent < line.size()) return Outcome::stays;
    ++reader.line;
    reader.sent = 0;
  }
}

// One that comes back at once and is too slow again does not fill the log.
void StreamReaders::count_dropped() {
  const std::uint64_t dropped = ++counters_.readers_dropped;
  const auto now = std::chrono::steady_clock::now();
  if (now < warns_from_) return;
  warns_from_ = now + kBetweenWarnings;
  warn("a reader was too slow and is disconnected, the " + std::to_string(dropped) +
       ". since the start");
}

void StreamReaders::remove(std::size_t k) {
  readers_[k].socket.reset();
  readers_[k] = std::move(readers_[count_ - 1]);
  counters_.readers = --count_;
}

}  // namespace aspect
