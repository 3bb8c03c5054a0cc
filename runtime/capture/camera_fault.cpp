#include "runtime/capture/camera_fault.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace aspect {
namespace {

CameraState state_after(int error) noexcept {
  switch (error) {
    case ENODEV:
    case ENXIO:
    case ENOENT:
      return CameraState::absent;
    case EBUSY:
      return CameraState::busy;
    case ENOLINK:
    case ENOLCK:
      return CameraState::no_signal;
    case EIO:
    case EPIPE:
      return CameraState::stalled;
    default:
      return CameraState::failed;
  }
}

const char* advice(int error) noexcept {
  switch (error) {
    case EACCES:
    case EPERM:
      return "; add the user to the group of the node, usually video";
    case EBUSY:
      return "; another process uses it";
    case ENOMEM:
      return "; ask for a smaller size";
    default:
      return "";
  }
}

}  // namespace

CameraFault camera_fault(CameraState state, const char* format, ...) noexcept {
  CameraFault fault;
  fault.state = state;
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(fault.reason.data(), fault.reason.size(), format, arguments);
  va_end(arguments);
  return fault;
}

CameraFault call_fault(const char* call, int error) noexcept {
  const char* what = strerrordesc_np(error);
  return camera_fault(state_after(error), "%s: %s%s", call, what ? what : "unknown error",
                      advice(error));
}

}  // namespace aspect
