# The parts of OpenCV that are used, by the names that its own CMake file gives them. That file wants
# every part installed, 87 MB and 119 packages more. Videos are read where videoio is found;
# boards and
# lenses are measured where calib3d is.
find_path(OpenCV_INCLUDE_DIRS opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(part core imgproc imgcodecs videoio calib3d)
  find_library(ASPECT_OPENCV_${part} opencv_${part})
  mark_as_advanced(ASPECT_OPENCV_${part})
  if(ASPECT_OPENCV_${part})
    add_library(opencv_${part} SHARED IMPORTED GLOBAL)
    set_target_properties(opencv_${part} PROPERTIES
      IMPORTED_LOCATION ${ASPECT_OPENCV_${part}}
      INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
  elseif(NOT part MATCHES "videoio|calib3d")
    message(FATAL_ERROR "OpenCV's ${part} is not found: run tools/setup.sh, or install libopencv-${part}-dev")
  endif()
endforeach()
