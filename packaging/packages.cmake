# Debian packages, one a component: `cpack -G DEB` in a build folder that was configured with
# CMAKE_INSTALL_PREFIX=/usr, which tools/package.sh does. What only packages have (changelog,
# copyright, /etc/aspect) is laid into the tree by finish_tree.cmake before it is packed.
get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
set(known compiler lib dev aspectd python doc)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  if(NOT component IN_LIST known AND NOT component STREQUAL Unspecified)
    message(FATAL_ERROR "No package is known for the component ${component}: see packaging/packages.cmake")
  endif()
endforeach()
list(REMOVE_ITEM CPACK_COMPONENTS_ALL Unspecified)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME aspect)
set(CPACK_PACKAGE_VENDOR Aspect)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_SOURCE_DIR}/build/packages)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/finish_tree.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/without_ldconfig.cmake)

# No person: who packs this for others puts in who answers for it.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Aspect developers <aspect@example.org>")
set(CPACK_DEBIAN_PACKAGE_SOURCE aspect)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
# By processor's name, as dpkg has it.
set(architecture_x86_64 amd64)
set(architecture_aarch64 arm64)
set(architecture_armv7 armhf)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${architecture_${CMAKE_SYSTEM_PROCESSOR}})

# aspect_package(COMPONENT NAME name SECTION section SUMMARY text ...): the long description is
# packaging/description/NAME.
set(same "(= ${PROJECT_VERSION})")
function(aspect_package component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAME;SECTION;SUMMARY;DEPENDS;RECOMMENDS;SUGGESTS" "")
  string(TOUPPER ${component} upper)
  file(READ ${CMAKE_CURRENT_SOURCE_DIR}/description/${arg_NAME} description)
  string(STRIP "${description}" description)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/description/${arg_NAME})
  set(prefix CPACK_DEBIAN_${upper}_PACKAGE)
  set(${prefix}_NAME ${arg_NAME} PARENT_SCOPE)
  set(${prefix}_SECTION ${arg_SECTION} PARENT_SCOPE)
  set(${prefix}_DEPENDS "${arg_DEPENDS}" PARENT_SCOPE)
  set(${prefix}_RECOMMENDS "${arg_RECOMMENDS}" PARENT_SCOPE)
  set(${prefix}_SUGGESTS "${arg_SUGGESTS}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${arg_SUMMARY}\n${description}" PARENT_SCOPE)
endfunction()

aspect_package(compiler NAME aspect-compiler SECTION science
  SUMMARY "compiles coloured CAD models for object recognition"
  SUGGESTS "aspectd, aspect-doc")
aspect_package(lib NAME libaspect SECTION libs
  SUMMARY "names objects and their poses in colour frames")
aspect_package(dev NAME libaspect-dev SECTION libdevel
  SUMMARY "names objects and their poses in colour frames - C header"
  DEPENDS "libaspect ${same}")
aspect_package(aspectd NAME aspectd SECTION science
  SUMMARY "recognises objects in what a camera sees"
  DEPENDS "systemd | systemd-standalone-sysusers | systemd-sysusers"
  SUGGESTS "aspect-compiler")
aspect_package(python NAME python3-aspect SECTION python
  SUMMARY "names objects and their poses in colour frames - Python 3"
  DEPENDS "libaspect ${same}, python3 (>= 3.11~), python3 (<< 3.12), python3-numpy"
  RECOMMENDS "aspect-compiler"
  SUGGESTS "python3-opencv")
aspect_package(doc NAME aspect-doc SECTION doc
  SUMMARY "object recognition by CAD models - documentation")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)

# Which packages have what is needed: dpkg's own answer where it runs for its own processor. Boards'
# daemon is static; what their library needs are the newest symbols that it names (readelf -V).
if(ASPECT_DEVICE)
  set(CPACK_DEBIAN_LIB_PACKAGE_DEPENDS "libc6 (>= 2.33), libgcc-s1 (>= 4.5), libstdc++6 (>= 11)")
else()
  foreach(component COMPILER LIB ASPECTD PYTHON)
    set(CPACK_DEBIAN_${component}_PACKAGE_SHLIBDEPS ON)
  endforeach()
  # Ours is not installed, and is stated above.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/runtime/c_interface)
endif()
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

foreach(component aspectd lib python)
  string(TOUPPER ${component} upper)
  file(GLOB CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/${component}/*)
endforeach()

# For finish_tree.cmake.
set(CPACK_ASPECT_PACKAGING ${CMAKE_CURRENT_SOURCE_DIR})
set(CPACK_ASPECT_STRIP ${CMAKE_STRIP})
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(CPACK_ASPECT_NAME_${component} ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
endforeach()
include(CPack)
