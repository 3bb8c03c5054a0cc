#include "runtime/capture/control_words.h"

#include <algorithm>
#include <array>

namespace aspect {
namespace {

// Names: the kernel's Documentation/userspace-api/media/v4l (user and camera control classes), as
// v4l2-ctl writes those of its v4l2-ctrls-defs.c. Older kernels have
// white_balance_temperature_auto, exposure_auto and exposure_absolute.
constexpr std::array kWords = {
    ControlWords{"auto_exposure", "who chooses the exposure",
                 "manual, so that light changes do not move colours"},
    ControlWords{"exposure_auto", "who chooses the exposure, in older kernels",
                 "manual, so that light changes do not move colours"},
    ControlWords{"exposure_dynamic_framerate",
                 "the camera may take fewer frames a second to expose longer",
                 "off, so that frames come in time"},
    ControlWords{"exposure_time_absolute", "time that a frame is exposed for, in 100 microseconds",
                 "as short as light allows: nothing blurs, and no channel may reach 255"},
    ControlWords{"exposure_absolute",
                 "time that a frame is exposed for, in 100 microseconds, in older kernels",
                 "as short as light allows: nothing blurs, and no channel may reach 255"},
    ControlWords{"exposure", "time that a frame is exposed for, in the camera's own unit",
                 "as short as light allows: nothing blurs, and no channel may reach 255"},
    ControlWords{"gain_automatic", "the camera chooses the gain", "off, and a fixed gain"},
    ControlWords{"gain", "amplification of what the sensor gives",
                 "low: noise grows with it, and chroma_step has to"},
    ControlWords{"white_balance_automatic", "the camera chooses what is white",
                 "off: it moves all colours when something large and coloured comes into view"},
    ControlWords{"white_balance_temperature_auto",
                 "the camera chooses what is white, in older kernels",
                 "off: it moves all colours when something large and coloured comes into view"},
    ControlWords{"white_balance_temperature", "colour of the light, in kelvin",
                 "so that something grey is grey: about 3000 for warm lamps, 6500 for daylight"},
    ControlWords{"red_balance", "amplification of red", "so that something grey is grey"},
    ControlWords{"blue_balance", "amplification of blue", "so that something grey is grey"},
    ControlWords{"power_line_frequency", "mains frequency that lamps flicker with",
                 "that of the place: 1 is 50 Hz, 2 is 60 Hz"},
    ControlWords{"brightness", "added to every value", "so that black is just above 0"},
    ControlWords{"contrast", "every value is multiplied by it", "so that nothing reaches 255"},
    ControlWords{"saturation", "how far colours are from grey",
                 "as the camera is; higher parts alike colours, and their noise"},
    ControlWords{"hue", "turns all colours", "as the camera is"},
    ControlWords{"gamma", "curve from light to values", "as the camera is: shares follow it"},
    ControlWords{"sharpness", "how much the camera stresses edges",
                 "low: it draws fringes of other colours along edges"},
    ControlWords{"backlight_compensation", "brightens what stands before something bright", "off"},
    ControlWords{"focus_automatic_continuous", "the camera chooses the focus",
                 "off: searching blurs frames and changes the size of what is seen"},
    ControlWords{"focus_auto", "the camera chooses the focus, in older kernels",
                 "off: searching blurs frames and changes the size of what is seen"},
    ControlWords{"focus_absolute", "distance that is in focus, in the camera's own unit",
                 "where the parts are"},
    ControlWords{"zoom_absolute", "focal length, in the camera's own unit",
                 "as it was calibrated with: poses follow it"},
    ControlWords{"pan_absolute", "turn to the side, in arc seconds", ""},
    ControlWords{"tilt_absolute", "turn up or down, in arc seconds", ""},
    ControlWords{"horizontal_flip", "mirrors the picture from left to right",
                 "off: a mirrored object is another one"},
    ControlWords{"vertical_flip", "mirrors the picture from top to bottom",
                 "off, or together with horizontal_flip, which is half a turn"},
};

}  // namespace

std::span<const ControlWords> control_words() {
  return kWords;
}

const ControlWords* find_control_words(std::string_view name) {
  const auto* const found = std::ranges::find(kWords, name, &ControlWords::name);
  return found == kWords.end() ? nullptr : found;
}

}  // namespace aspect
