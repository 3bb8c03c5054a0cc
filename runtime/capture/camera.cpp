// A camera is closed, open (waiting for a signal or for its stream to be started anew) or
// streaming. Whatever goes wrong becomes a CameraFault, whose state is at once what is reported
// and what is done:
//   absent, busy, failed  everything is closed; opened again after kRetry, and so on
//   no_signal             the stream ends, the node stays open: chips forget their signal otherwise
//   stalled               the stream is started anew on the open node; the second time without a
//                         frame in between the node is closed, too
// A state is reported when it is entered; streaming begins with the first frame that comes, not
// with the first promise, so that a camera that fails over and over is reported once.
#include "runtime/capture/camera.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <optional>
#include <utility>

#include "runtime/capture/camera_controls.h"
#include "runtime/capture/camera_decoder.h"
#include "runtime/capture/camera_fault.h"
#include "runtime/capture/camera_input.h"
#include "runtime/capture/camera_negotiation.h"
#include "runtime/capture/camera_search.h"
#include "runtime/capture/camera_stream.h"
#include "runtime/capture/v4l2_text.h"

namespace aspect {
namespace {

constexpr std::chrono::milliseconds kRetry{250};
constexpr std::chrono::milliseconds kSignalCheck{1000};
// Sensors and USB cameras take their time for the first frame.
constexpr std::chrono::milliseconds kFirstFrame{2000};

}  // namespace

std::string_view name_of(CameraState state) {
  switch (state) {
    case CameraState::streaming:
      return "streaming";
    case CameraState::absent:
      return "absent";
    case CameraState::busy:
      return "busy";
    case CameraState::no_signal:
      return "no_signal";
    case CameraState::stalled:
      return "stalled";
    case CameraState::failed:
      return "failed";
  }
  return "failed";
}

class Camera::Link {
 public:
  Link(CameraSettings settings, V4l2Calls& calls, DeviceFolders folders)
      : settings_(std::move(settings)),
        calls_(calls),
        folders_(std::move(folders)),
        stream_(calls) {}
  ~Link() { close(); }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  Result<CameraPlan> check();
  CameraEvent next(std::chrono::milliseconds timeout, int wake_descriptor) noexcept;
  const CameraPlan& plan() const { return plan_; }
  void adopt_controls(const std::vector<CameraControl>& controls) { settings_.controls = controls; }

 private:
  using Time = V4l2Calls::Time;

  bool open() const { return camera_.descriptor >= 0; }
  void close() noexcept;
  CameraFault negotiate(CameraPlan& plan);
  CameraFault start();
  CameraFault try_start() noexcept;
  std::optional<CameraEvent> enter(const CameraFault& fault) noexcept;
  Time due(Time deadline) const noexcept;
  std::optional<CameraEvent> answer(short revents) noexcept;
  std::optional<CameraEvent> frames(short revents) noexcept;
  std::optional<CameraEvent> look_at_signal() noexcept;
  CameraEvent hand_out() noexcept;
  CameraEvent event(CameraEvent::Kind kind) const noexcept;

  CameraSettings settings_;
  V4l2Calls& calls_;
  const DeviceFolders folders_;

  FoundCamera camera_;
  CameraInput input_;
  StreamFormat format_;
  CameraStream stream_;
  CameraDecoder decoder_;
  CameraPlan plan_;

  bool streaming_ = false;       // STREAMON has succeeded
  bool stalled_before_ = false;  // and no frame has come since
  CameraFault reported_;         // the state that was reported last, with its reason
  bool reported_any_ = false;
  std::chrono::milliseconds stall_{};
  Time retry_at_{}, stalls_at_{}, signal_at_{};
  std::uint64_t sequence_ = 0;
};

void Camera::Link::close() noexcept {
  streaming_ = false;
  stream_.stop();
  decoder_.close();
  if (open()) calls_.close(camera_.descriptor);
  camera_.descriptor = -1;
}

// Everything up to the buffers.
CameraFault Camera::Link::negotiate(CameraPlan& plan) {
  if (!open())
    if (CameraFault fault = find_camera(calls_, folders_, settings_.device, camera_)) return fault;
  plan = {};
  plan.node = camera_.node;
  plan.driver = camera_.driver;
  plan.card = camera_.card;
  plan.bus = camera_.bus;
  plan.multiplanar = camera_.multiplanar();
  const int descriptor = camera_.descriptor;
  if (CameraFault fault = read_input(calls_, descriptor, input_)) return fault;
  const bool decoder = CameraDecoder::available();
  if (CameraFault fault = negotiate_format(calls_, camera_, settings_, decoder, format_,
                                           plan.rate_hz, plan.warnings))
    return fault;
  plan.fourcc = fourcc_text(format_.format.fourcc);
  plan.width_px = format_.width_px;
  plan.height_px = format_.height_px;
  plan.format = format_.format.pixels;
  plan.decoded = format_.format.decoded;
  if (plan.rate_hz == 0) plan.rate_hz = input_.rate_hz;
  if (CameraFault fault =
          set_controls(calls_, descriptor, settings_.controls, plan.controls, plan.warnings))
    return fault;
  if (format_.format.decoded && !decoder_.open(calls_, descriptor, format_))
    return camera_fault(CameraState::failed, "libv4lconvert does not read %s of this camera",
                        plan.fourcc.c_str());
  return stream_.prepare(descriptor, format_);
}

CameraFault Camera::Link::start() {
  CameraPlan plan;
  if (CameraFault fault = negotiate(plan)) return fault;
  if (CameraFault fault = stream_.start()) return fault;
  plan_ = std::move(plan);
  // However short a silence is allowed, a slow camera may take its time.
  stall_ = settings_.stall;
  if (plan_.rate_hz > 1e-3) {
    const std::chrono::duration<double> frames(3 / plan_.rate_hz);
    stall_ = std::max(stall_, std::chrono::ceil<std::chrono::milliseconds>(frames));
  }
  const Time now = calls_.now();
  stalls_at_ = now + stall_ + kFirstFrame;
  signal_at_ = now + kSignalCheck;
  streaming_ = true;
  return {};
}

CameraFault Camera::Link::try_start() noexcept {
  try {
    return start();
  } catch (const std::bad_alloc&) {
    return camera_fault(CameraState::failed, "not enough memory; ask for a smaller size");
  }
}

CameraEvent Camera::Link::event(CameraEvent::Kind kind) const noexcept {
  CameraEvent result;
  result.kind = kind;
  result.state = reported_any_ ? reported_.state : CameraState::absent;
  if (result.state != CameraState::streaming) result.reason = reported_.text();
  return result;
}

// Does what the fault demands; an event where it is another one than before.
std::optional<CameraEvent> Camera::Link::enter(const CameraFault& fault) noexcept {
  streaming_ = false;
  const bool again = fault.state == CameraState::stalled && stalled_before_;
  const bool keep_open =
      fault.state == CameraState::no_signal || (fault.state == CameraState::stalled && !again);
  stalled_before_ = fault.state == CameraState::stalled;
  if (keep_open)
    stream_.stop();
  else
    close();
  const bool at_once = fault.state == CameraState::stalled && !again;
  retry_at_ = at_once ? calls_.now() : calls_.now() + kRetry;
  if (reported_any_ && reported_.state == fault.state) return std::nullopt;
  reported_ = fault;
  reported_any_ = true;
  return event(CameraEvent::Kind::changed);
}

CameraEvent Camera::Link::hand_out() noexcept {
  const StreamFrame taken = stream_.take();
  sequence_ += taken.step;
  CameraEvent result = event(CameraEvent::Kind::frame);
  result.frame = taken.frame;
  result.sequence = sequence_;
  result.late = taken.late;
  result.lost = taken.lost;
  result.captured = taken.captured;
  if (format_.format.decoded && !decoder_.decode(taken.bytes, result.frame)) {
    result.kind = CameraEvent::Kind::damaged;
    result.reason = "the frame cannot be decoded";
  }
  return result;
}

std::optional<CameraEvent> Camera::Link::frames(short revents) noexcept {
  const char* damage = nullptr;
  if (const CameraFault fault = stream_.drain(damage)) return enter(fault);
  const bool alive = damage || stream_.has_frame();
  if (!alive && (revents & (POLLHUP | POLLNVAL)) != 0)
    return enter(camera_fault(CameraState::absent, "the camera hung up"));
  if (!alive && (revents & POLLERR) != 0)
    return enter(camera_fault(CameraState::stalled, "the driver reports an error"));
  if (!alive) return std::nullopt;

  stalls_at_ = calls_.now() + stall_;
  stalled_before_ = false;
  if (damage) {
    CameraEvent result = event(CameraEvent::Kind::damaged);
    result.reason = damage;
    return result;
  }
  if (reported_any_ && !reported_) return hand_out();
  reported_ = {};
  reported_any_ = true;
  return event(CameraEvent::Kind::changed);
}

std::optional<CameraEvent> Camera::Link::look_at_signal() noexcept {
  signal_at_ = calls_.now() + kSignalCheck;
  const CameraFault fault = check_signal(calls_, camera_.descriptor, input_);
  return fault ? enter(fault) : std::nullopt;
}

std::optional<CameraEvent> Camera::Link::answer(short revents) noexcept {
  const bool changed = (revents & POLLPRI) != 0 && source_changed(calls_, camera_.descriptor);
  const Time now = calls_.now();
  if (changed || (input_.digital_video && now >= signal_at_)) {
    if (auto result = look_at_signal()) return result;
    if (!streaming_) return std::nullopt;
  }
  if ((revents & ~POLLPRI) != 0 || stream_.has_frame()) return frames(revents);
  if (now >= stalls_at_)
    return enter(camera_fault(CameraState::stalled, "the camera stopped sending"));
  return std::nullopt;
}

Camera::Link::Time Camera::Link::due(Time deadline) const noexcept {
  if (!streaming_) return std::min(deadline, retry_at_);
  if (stream_.has_frame()) return Time{};
  const Time first = std::min(deadline, stalls_at_);
  return input_.digital_video ? std::min(first, signal_at_) : first;
}

CameraEvent Camera::Link::next(std::chrono::milliseconds timeout, int wake_descriptor) noexcept {
  const Time deadline = calls_.now() + timeout;
  if (streaming_)
    if (const CameraFault fault = stream_.release())
      if (auto result = enter(fault)) return *result;
  for (;;) {
    if (!streaming_ && calls_.now() >= retry_at_)
      if (const CameraFault fault = try_start())
        if (auto result = enter(fault)) return *result;
    // Negative descriptors are passed over.
    pollfd waits[] = {{wake_descriptor, POLLIN, 0},
                      {streaming_ ? camera_.descriptor : -1, POLLIN | POLLPRI, 0}};
    calls_.poll(waits, due(deadline));
    if (waits[0].revents != 0) return event(CameraEvent::Kind::woken);
    if (streaming_)
      if (auto result = answer(waits[1].revents)) return *result;
    if (calls_.now() >= deadline) return event(CameraEvent::Kind::nothing);
  }
}

Result<CameraPlan> Camera::Link::check() {
  if (streaming_) return plan_;
  CameraPlan plan;
  const CameraFault fault = negotiate(plan);
  close();
  const bool named = fault.text().starts_with(settings_.device);
  if (fault)
    return Error{"camera " + (named ? "" : settings_.device + ": ") + std::string(fault.text())};
  return plan;
}

Camera::Camera(CameraSettings settings)
    : Camera(std::move(settings), kernel_calls(), DeviceFolders{}) {}

Camera::Camera(CameraSettings settings, V4l2Calls& calls, const DeviceFolders& folders)
    : link_(std::make_unique<Link>(std::move(settings), calls, folders)) {}

Camera::~Camera() = default;

Result<CameraPlan> Camera::check() {
  return link_->check();
}

CameraEvent Camera::next(std::chrono::milliseconds timeout, int wake_descriptor) noexcept {
  return link_->next(timeout, wake_descriptor);
}

void Camera::adopt_controls(const std::vector<CameraControl>& controls) {
  link_->adopt_controls(controls);
}

const CameraPlan& Camera::plan() const {
  return link_->plan();
}

}  // namespace aspect
