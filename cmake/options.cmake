# Compiler and linker options of everything that the project builds: the interface target `atelier_options`.
add_library(atelier_options INTERFACE)
target_compile_options(atelier_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers
  -Wno-restrict        # GCC 12 sees overlaps in std::string that are not there
  # GCC 13 and newer take a reference that a function returns for one to the text that it was given beside
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
  -ffp-contract=off)  # the same arithmetic with and without fused multiply-add
if(ATELIER_WERROR AND NOT ATELIER_SANITIZE)  # GCC 12 sees uninitialised values in <regex> when it instruments it
  target_compile_options(atelier_options INTERFACE -Werror)
endif()
if(ATELIER_SANITIZE)
  target_compile_options(atelier_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                                   -fno-omit-frame-pointer)
  target_link_options(atelier_options INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(atelier_options INTERFACE ${PROJECT_SOURCE_DIR}/common)
target_compile_definitions(atelier_options INTERFACE GLM_FORCE_SILENT_WARNINGS)

# mold links in a fiftieth of the default linker's time.
find_program(ATELIER_MOLD mold)
mark_as_advanced(ATELIER_MOLD)
if(ATELIER_MOLD)
  target_link_options(atelier_options INTERFACE -fuse-ld=mold)
endif()

# For code that waits for files, drivers and other programs, and for tests: half of the time to compile, and nobody sees
# the difference. With ADDRESSES_ONLY it goes without the checks of undefined behaviour in a build with sanitizers and
# keeps AddressSanitizer: for what reads nothing from strangers. Call it before atelier_precompile: GCC 12 crashes over
# headers that were precompiled with other options.
function(atelier_compile_quickly target)
  cmake_parse_arguments(QUICKLY "ADDRESSES_ONLY" "" "" ${ARGN})
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" OR CMAKE_BUILD_TYPE STREQUAL Debug)
    return()
  endif()
  target_compile_options(${target} PRIVATE -O0)
  set_target_properties(${target} PROPERTIES ATELIER_LEVEL quick)
  if(ATELIER_SANITIZE AND QUICKLY_ADDRESSES_ONLY)
    target_compile_options(${target} PRIVATE -fno-sanitize=undefined)
    set_target_properties(${target} PROPERTIES ATELIER_LEVEL addresses)
  endif()
endfunction()

# Reading the headers that everyone includes takes a second a file, their precompiled form a tenth: one for all libraries
# of one level of optimisation, made by the first.
function(atelier_precompile target)
  get_target_property(level ${target} ATELIER_LEVEL)
  get_property(holder GLOBAL PROPERTY ATELIER_PRECOMPILED_${level})
  if(holder)
    target_precompile_headers(${target} REUSE_FROM ${holder})
  else()
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/parts.hpp)
    set_property(GLOBAL PROPERTY ATELIER_PRECOMPILED_${level} ${target})
  endif()
endfunction()

# A folder of common/: an object library that ends up in libatelier.so (see common/CMakeLists.txt). QUICKLY: as
# atelier_compile_quickly has it.
function(atelier_part name)
  cmake_parse_arguments(PART "QUICKLY" "" "" ${ARGN})
  add_library(atelier_${name} OBJECT ${PART_UNPARSED_ARGUMENTS})
  target_link_libraries(atelier_${name} PUBLIC atelier_options atelier_headers)
  if(PART_QUICKLY)
    atelier_compile_quickly(atelier_${name})
  endif()
  atelier_precompile(atelier_${name})
endfunction()
