# What `cmake --install` puts where, and the package that find_package(sundrape) finds.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sundrape)
set(data_folder ${CMAKE_INSTALL_DATADIR}/sundrape)

install(TARGETS sundrape_library EXPORT sundrape-targets)
if(TARGET sundrape)
  install(TARGETS sundrape)
endif()
install(DIRECTORY include/sundrape TYPE INCLUDE)
install(DIRECTORY cases DESTINATION ${data_folder}
        FILES_MATCHING PATTERN "*.toml" PATTERN "*.obj" PATTERN "*.md" PATTERN "fabrics" EXCLUDE)
install(DIRECTORY cases/fabrics DESTINATION ${data_folder} FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY postproc DESTINATION ${data_folder}
        PATTERN "tests" EXCLUDE PATTERN "__pycache__" EXCLUDE PATTERN "*.egg-info" EXCLUDE PATTERN ".*" EXCLUDE)
install(FILES LICENSE CHANGELOG.md CITATION.cff docs/dependencies.md TYPE DOC)

get_target_property(library_type sundrape_library TYPE)
configure_package_config_file(cmake/sundrape-config.cmake.in sundrape-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(sundrape-config-version.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT sundrape-targets NAMESPACE sundrape:: DESTINATION ${package_folder})
install(FILES ${PROJECT_BINARY_DIR}/sundrape-config.cmake ${PROJECT_BINARY_DIR}/sundrape-config-version.cmake
              cmake/dependencies.cmake
        DESTINATION ${package_folder})
