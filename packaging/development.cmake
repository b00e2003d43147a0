# SPDX-License-Identifier: LGPL-2.1-or-later
# What those install who write plug-ins, or programs with the library: the component dev, which is the
# package chaindrive-dev. Headers, a static library of all rooms, and a package for find_package().
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/chaindrive)

# The objects of all rooms once more, in one archive, as Debian strips its own.
get_property(objects GLOBAL PROPERTY CHAINDRIVE_ROOM_OBJECTS)
add_library(chaindrive_library STATIC EXCLUDE_FROM_ALL
  $<TARGET_OBJECTS:chaindrive_terms> $<TARGET_OBJECTS:chaindrive_quantities> ${objects})
set_target_properties(chaindrive_library PROPERTIES OUTPUT_NAME chaindrive LINKER_LANGUAGE CXX)
if(CMAKE_STRIP)
  add_custom_command(TARGET chaindrive_library POST_BUILD
    COMMAND ${CMAKE_STRIP} --strip-debug --remove-section=.comment $<TARGET_FILE:chaindrive_library> VERBATIM)
endif()

string(TOUPPER ${CMAKE_BUILD_TYPE} CHAINDRIVE_BUILD)
include(CMakePackageConfigHelpers)
configure_package_config_file(chaindriveConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/chaindriveConfig.cmake
  INSTALL_DESTINATION ${package}
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/chaindriveConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)

install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${PROJECT_BINARY_DIR}\" --target chaindrive_library
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR \"The library cannot be built.\")
endif()" COMPONENT dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/chaindrive DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(FILES ${PROJECT_BINARY_DIR}/source/include/chaindrive/abi.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/chaindrive COMPONENT dev)
install(TARGETS chaindrive_library ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/chaindriveConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/chaindriveConfigVersion.cmake DESTINATION ${package} COMPONENT dev)

chaindrive_packages(dev names)
list(JOIN names ", " depends)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME chaindrive-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "chaindrive (= ${PROJECT_VERSION}-${release}), ${depends}")
set(CPACK_DEBIAN_DEV_DESCRIPTION "dynamics of roller chain drives (development files)
Headers, library and CMake package of chaindrive: for plug-ins, which add
quantities, forces and other things to the program, and for programs of
one's own.")
