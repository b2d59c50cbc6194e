# What is installed, as a Debian package that uses the system's libraries and fonts, or (GABARIT_BUNDLE) as a folder
# that runs wherever it is put: it brings every library but the C library's own, and the fonts.
option(GABARIT_BUNDLE "Install the libraries and fonts as well" OFF)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON CACHE INTERNAL "only the program is installed")

set(packs DIRECTORY ${CMAKE_SOURCE_DIR}/rules/library/ DESTINATION share/gabarit/rules)
install(${packs} FILES_MATCHING PATTERN "*.yaml")
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION share/doc/gabarit)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION share/doc/gabarit)

# A program with its libraries and fonts; more words: of the component that it is.
function(install_with_libraries program)
  set(c_library "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util)[.]so")
  # The old kind of run path also holds for what the libraries themselves need.
  target_link_options(${program} PRIVATE -Wl,--disable-new-dtags)
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
  install(TARGETS ${program} RUNTIME_DEPENDENCY_SET needed DESTINATION bin ${ARGN})
  install(RUNTIME_DEPENDENCY_SET needed PRE_EXCLUDE_REGEXES ${c_library} LIBRARY DESTINATION lib ${ARGN})
  find_path(dejavu_folder DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu REQUIRED)
  install(FILES ${dejavu_folder}/DejaVuSans.ttf ${dejavu_folder}/DejaVuSans-Bold.ttf ${dejavu_folder}/DejaVuSansMono.ttf
          DESTINATION share/gabarit/fonts ${ARGN})
endfunction()

if(GABARIT_BUNDLE)
  install_with_libraries(gabarit)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/gabarit)
else()
  install(TARGETS gabarit DESTINATION bin)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/gabarit RENAME copyright)
endif()
# The same program linked as a bundle wants it, for the test that packs it.
if(GABARIT_TESTS AND NOT GABARIT_BUNDLE AND NOT GABARIT_SANITIZE)
  add_executable(gabarit_in_bundle)
  target_link_libraries(gabarit_in_bundle PRIVATE gabarit_cli)
  set_target_properties(gabarit_in_bundle PROPERTIES
    OUTPUT_NAME gabarit RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/in_bundle)
  install_with_libraries(gabarit_in_bundle COMPONENT bundle EXCLUDE_FROM_ALL)
  install(${packs} COMPONENT bundle EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.yaml")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Gabarit developers")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_PACKAGE_DESCRIPTION "Measures CAD models against rules of product safety, such as the rounding of what a
column can touch or the thickness of walls, and writes evidence: a report, the facets that fail, and data.")
include(CPack)
