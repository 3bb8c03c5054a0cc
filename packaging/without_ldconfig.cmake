# Run by cpack when packages are made: cpack gives packages with a library, or a module that only a
# program of theirs loads, scripts that call ldconfig,
# which Debian has had a trigger for since 2015 (packaging/lib/triggers). Without scripts it can also be
# installed into a root file system of another processor.
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  if(NOT package MATCHES "/(libaspect|aspect-compiler)_[^/]*\\.deb$")
    continue()
  endif()
  set(tree ${package}.tree)
  file(REMOVE_RECURSE ${tree})
  execute_process(COMMAND dpkg-deb -R ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
  execute_process(COMMAND dpkg-deb -Zxz --root-owner-group -b ${tree} ${package}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${tree})
endforeach()
