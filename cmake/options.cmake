# Compiler and linker options for all targets: the interface target `atelier_options`.
add_library(atelier_options INTERFACE)
target_compile_options(atelier_options INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wno-missing-field-initializers
  $<$<CXX_COMPILER_ID:GNU>:-Wshadow>  # Clang's also means names of other files in one unity source
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false positives of GCC 12 in std::string
  # False positives of GCC 13 and newer: they assume that a returned reference refers to a temporary string argument
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
  -ffp-contract=off)  # the same arithmetic with and without fused multiply-add
if(ATELIER_WERROR AND NOT ATELIER_SANITIZE)  # with sanitizers GCC 12 warns falsely of uninitialised values in <regex>
  target_compile_options(atelier_options INTERFACE -Werror)
endif()
if(ATELIER_SANITIZE)
  target_compile_options(atelier_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                                   -fno-omit-frame-pointer)
  target_link_options(atelier_options INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(atelier_options INTERFACE ${PROJECT_SOURCE_DIR}/common)
target_compile_definitions(atelier_options INTERFACE GLM_FORCE_SILENT_WARNINGS)

# mold links fifty times as fast as the default linker.
find_program(ATELIER_MOLD mold)
mark_as_advanced(ATELIER_MOLD)
if(ATELIER_MOLD)
  target_link_options(atelier_options INTERFACE -fuse-ld=mold)
endif()

# Compiles without optimisation, which takes half the time. For tests, and for code that mostly waits for files, drivers
# and other programs. With ADDRESSES_ONLY a sanitizer build uses AddressSanitizer but not UndefinedBehaviorSanitizer:
# for code that reads no untrusted input. Call it before atelier_precompile: GCC 12 crashes if headers were precompiled
# with other options.
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

# Precompiles the common headers, which take a second per file (precompiled: a tenth). The first target of each
# optimisation level makes the precompiled header; the others reuse it.
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

# A folder of common/: an object library, part of libatelier.so (see common/CMakeLists.txt). QUICKLY: see
# atelier_compile_quickly.
function(atelier_part name)
  cmake_parse_arguments(PART "QUICKLY" "" "" ${ARGN})
  add_library(atelier_${name} OBJECT ${PART_UNPARSED_ARGUMENTS})
  target_link_libraries(atelier_${name} PUBLIC atelier_options atelier_headers)
  if(PART_QUICKLY)
    atelier_compile_quickly(atelier_${name})
  endif()
  atelier_precompile(atelier_${name})
endfunction()
