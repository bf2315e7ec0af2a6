# `cpack -G DEB` in a build folder of preset package: one Debian package with program, library and
# data. It depends on what its binaries are linked with; the body data are fetched by `loosefit setup`.
set(CPACK_PACKAGE_NAME loosefit)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Loosefit contributors")
set(CPACK_PACKAGE_CONTACT "The Loosefit contributors <loosefit@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "sensor performance maps of draped garments")
set(CPACK_PACKAGE_DESCRIPTION "Drapes a sewn garment on a human body until forces balance, and maps
how well sensors sewn into it would measure: strain, distance from the skin, angular deviation.
 .
Run `loosefit setup` once: it fetches and bakes the body data.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};loosefit;ALL;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Scripts call these by name; npm only fetches the body, and the screen only serves where none is.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "bash, tar, coreutils")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "npm, xvfb, xauth")
include(CPack)
