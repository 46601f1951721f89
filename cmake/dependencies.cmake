# Every library that sundrape uses; docs/dependencies.md says why each.
# The installed package configuration includes this file too, so that what the build finds and what a user of the
# static library must find are one list.
find_package(SUNDIALS 6.4 REQUIRED COMPONENTS cvode ida arkode nvecserial)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(assimp REQUIRED)
find_package(muparser REQUIRED)

# SuiteSparse 5 and UDUNITS ship no CMake package. Makes the imported target sundrape::<name>.
function(sundrape_find_library name header header_folder)
  find_path(SUNDRAPE_${name}_INCLUDE_DIR ${header} PATH_SUFFIXES ${header_folder})
  find_library(SUNDRAPE_${name}_LIBRARY ${name})
  mark_as_advanced(SUNDRAPE_${name}_INCLUDE_DIR SUNDRAPE_${name}_LIBRARY)
  if(NOT SUNDRAPE_${name}_INCLUDE_DIR OR NOT SUNDRAPE_${name}_LIBRARY)
    message(FATAL_ERROR "sundrape needs ${header} and lib${name}; docs/dependencies.md names the packages that have them")
  endif()
  if(NOT TARGET sundrape::${name})
    add_library(sundrape::${name} INTERFACE IMPORTED)
    set_target_properties(sundrape::${name} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${SUNDRAPE_${name}_INCLUDE_DIR}"
                                                       INTERFACE_LINK_LIBRARIES "${SUNDRAPE_${name}_LIBRARY}")
  endif()
endfunction()

sundrape_find_library(klu klu.h suitesparse)
sundrape_find_library(udunits2 udunits2.h udunits2)
if(SUNDRAPE_WITH_CHOLMOD)
  sundrape_find_library(cholmod cholmod.h suitesparse)
endif()
