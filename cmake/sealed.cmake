# Releases have some given sources sealed (common/base/sealed.hpp): those that compute a student's answer in another way.
add_executable(atelier-unseal EXCLUDE_FROM_ALL common/base/unseal.cpp common/base/sealed.cpp)
target_link_libraries(atelier-unseal PRIVATE atelier_options)

# atelier_unseal(OUT FOLDER NAME): in OUT, the C++ files that the build makes from FOLDER/*.cpp.sealed of the step NAME.
function(atelier_unseal out folder name)
  file(GLOB sealed CONFIGURE_DEPENDS ${folder}/*.cpp.sealed)
  set(sources "")
  foreach(file IN LISTS sealed)
    get_filename_component(source ${file} NAME_WLE)
    set(source ${CMAKE_BINARY_DIR}/steps/${name}/${source})
    add_custom_command(OUTPUT ${source} COMMAND atelier-unseal ${file} ${source} DEPENDS ${file} VERBATIM
      COMMENT "Unsealing ${name}")
    list(APPEND sources ${source})
  endforeach()
  set(${out} ${sources} PARENT_SCOPE)
endfunction()
