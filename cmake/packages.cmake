# The packages that the project needs, all from the system (./atelier lists them by distribution).
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(glfw3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(imgui IMPORTED_TARGET imgui)  # optional: without it windows have no settings panel

# Debian's OpenImageIO lists include folders of packages that may not be installed; CMake refuses missing folders.
function(atelier_drop_missing_include_folders target)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  set(present "")
  foreach(folder IN LISTS folders)
    if(EXISTS "${folder}")
      list(APPEND present "${folder}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${present}")
endfunction()
atelier_drop_missing_include_folders(OpenImageIO::OpenImageIO)
if(TARGET OpenImageIO::OpenImageIO_Util)
  atelier_drop_missing_include_folders(OpenImageIO::OpenImageIO_Util)
endif()

# The header-only and small libraries that every part may use.
add_library(atelier_headers INTERFACE)
target_link_libraries(atelier_headers INTERFACE glm::glm fmt::fmt nlohmann_json::nlohmann_json Threads::Threads)
