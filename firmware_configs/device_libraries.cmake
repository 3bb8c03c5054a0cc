# The libraries of the device half, by the names that the workstation's packages give them. All of
# them are headers in /usr/include: nothing of another architecture has to be installed, and the
# packages' own CMake files, which name the build machine's libraries, are not read.
function(aspect_header_library name)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(${name} INTERFACE ${ARGN})
endfunction()

# Without these settings fmt and toml++ bring in the streams and locales of the C++ library, a third
# of a static program.
aspect_header_library(fmt::fmt FMT_HEADER_ONLY=1 "FMT_STATIC_THOUSANDS_SEPARATOR=','")
aspect_header_library(tomlplusplus::tomlplusplus TOML_HEADER_ONLY=1 TOML_ENABLE_FORMATTERS=0
  TOML_FLOAT_CHARCONV=1)
aspect_header_library(CLI11::CLI11)
aspect_header_library(Catch2::Catch2)
aspect_header_library(nlohmann_json::nlohmann_json)
aspect_header_library(Eigen3::Eigen)
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE /usr/include/eigen3)

# What is no header comes from packages of the device's architecture, unpacked by
# firmware_configs/rootfs/fetch_packages.sh.
set(ASPECT_DEVICE_PACKAGES "" CACHE PATH "Folder of unpacked packages for the device's processor; empty: only headers are used")

# Camera formats that are not ours, MJPEG above all.
file(GLOB V4LCONVERT_LIBRARY ${ASPECT_DEVICE_PACKAGES}/libv4l-dev/usr/lib/*/libv4lconvert.a)
file(GLOB jpeg_library ${ASPECT_DEVICE_PACKAGES}/libjpeg62-turbo-dev/usr/lib/*/libjpeg.a)
list(APPEND V4LCONVERT_LIBRARY ${jpeg_library})

# What the tests compare vision with; without it, vision is not tested.
if(EXISTS ${ASPECT_DEVICE_PACKAGES}/libopencv-core406)
  set(OpenCV_INCLUDE_DIRS /usr/include/opencv4)
  foreach(part core imgproc)
    file(GLOB library ${ASPECT_DEVICE_PACKAGES}/libopencv-${part}406/usr/lib/*/libopencv_${part}.so.406)
    add_library(opencv_${part} SHARED IMPORTED GLOBAL)
    set_target_properties(opencv_${part} PROPERTIES IMPORTED_LOCATION ${library}
      INTERFACE_LINK_OPTIONS -Wl,--allow-shlib-undefined)
    target_include_directories(opencv_${part} SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
  endforeach()
endif()

# Without the parts that nobody calls.
add_compile_options(-ffunction-sections -fdata-sections)
add_link_options(-Wl,--gc-sections)

# aspect_strip(PROGRAM): static, and what is copied to the board in bin/stripped/PROGRAM.
add_custom_target(stripped ALL)
function(aspect_strip program)
  target_link_options(${program} PRIVATE -static)
  set(folder ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/stripped)
  add_custom_command(OUTPUT ${folder}/${program}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${CMAKE_STRIP} -s -R .comment -o ${folder}/${program} $<TARGET_FILE:${program}>
    DEPENDS ${program}
    VERBATIM)
  add_custom_target(stripped-${program} DEPENDS ${folder}/${program})
  add_dependencies(stripped stripped-${program})
endfunction()
