# The installed package: libraries, headers, and what find_package(pliant) reads. Included once formats/ is known.

# All of it at once, for users of the installed package; the documents of formats/ come with it.
add_library(pliant INTERFACE)
add_library(pliant::pliant ALIAS pliant)
target_link_libraries(pliant INTERFACE pliant_evolve pliant_generate pliant_flow pliant_fem pliant_formats)

# The global smoother stays with its tool: who used the package would need Ceres, and its licence.
install(TARGETS pliant pliant_geometry pliant_boundary pliant_mesh pliant_ops pliant_quality pliant_flow pliant_fem pliant_evolve pliant_improve
                pliant_generate
        EXPORT pliantTargets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# In the tree and installed, these are included as "formats/document/mesh_document.h". Users need not have nlohmann-json.
install(TARGETS pliant_formats EXPORT pliantTargets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pliant)

include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pliant)
install(EXPORT pliantTargets NAMESPACE pliant:: DESTINATION ${config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pliantConfig.cmake.in ${PROJECT_BINARY_DIR}/pliantConfig.cmake
                              INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pliantConfig.cmake ${PROJECT_BINARY_DIR}/pliantConfigVersion.cmake
        DESTINATION ${config_dir})
