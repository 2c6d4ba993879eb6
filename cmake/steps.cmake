# atelier_step(NAME TITLE "..." FILES a.cpp a.glsl [HEADERS a.hpp] [USES 01-transforms ...]
#              PROGRAM main.cpp ... [SHARED feature.cpp ...] [SHARES 02-blinn-phong ...])
#
# NAME      the folder below steps/
# FILES     what the student writes; the solution has the same names
# HEADERS   the contract: what the student's files may include
# USES      earlier steps whose functions are called
# PROGRAM   the given sources that no other step needs
# SHARED    the given sources that later steps build on: compiled once for all
# SHARES    steps whose SHARED sources this program takes in beside its own
#
# Makes the executable NAME, the given program as a module that it loads, and, where solutions/NAME is there, the
# solution's library, unless a release has brought it compiled: solutions/NAME/libstep.so. Students' own files are not
# built here: the atelier command does that with the same flags (step_flags.json), so that what a student breaks stops
# nothing else.

set(ATELIER_STUDENT_FLAGS -std=c++20 -O2 -g1 -fPIC -ffp-contract=off -Wall -Wextra -Wno-unused-parameter -DGLM_FORCE_SILENT_WARNINGS)
if(ATELIER_SANITIZE)
  list(APPEND ATELIER_STUDENT_FLAGS -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
endif()
set(ATELIER_STUDENT_LINK -shared)
if(ATELIER_MOLD)
  list(APPEND ATELIER_STUDENT_LINK -fuse-ld=mold)
endif()

# The precompiled header of students' files: a quarter of the time from an edit to a verdict.
set(ATELIER_PRELUDE ${CMAKE_BINARY_DIR}/student/prelude.hpp)
configure_file(${PROJECT_SOURCE_DIR}/cmake/prelude.hpp ${ATELIER_PRELUDE} COPYONLY)
add_custom_command(
  OUTPUT ${ATELIER_PRELUDE}.gch
  COMMAND ${CMAKE_CXX_COMPILER} ${ATELIER_STUDENT_FLAGS} -I${PROJECT_SOURCE_DIR}/common -x c++-header
          -MD -MF ${ATELIER_PRELUDE}.d -MT ${ATELIER_PRELUDE}.gch ${ATELIER_PRELUDE} -o ${ATELIER_PRELUDE}.gch
  DEPENDS ${ATELIER_PRELUDE} DEPFILE ${ATELIER_PRELUDE}.d VERBATIM COMMENT "Precompiling the students' prelude")
add_custom_target(atelier_prelude ALL DEPENDS ${ATELIER_PRELUDE}.gch)

function(atelier_json_list out)
  set(quoted "")
  foreach(item IN LISTS ARGN)
    list(APPEND quoted "\"${item}\"")
  endforeach()
  list(JOIN quoted ", " joined)
  set(${out} "[${joined}]" PARENT_SCOPE)
endfunction()

function(atelier_step name)
  cmake_parse_arguments(STEP "" "TITLE" "FILES;HEADERS;USES;PROGRAM;SHARED;SHARES" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/steps/${name})
  if(EXISTS ${PROJECT_SOURCE_DIR}/skeletons AND NOT EXISTS ${folder}/main.cpp)
    return()  # a step that has not been released yet
  endif()

  list(TRANSFORM STEP_PROGRAM PREPEND ${folder}/)
  set(parts program-${name})
  add_library(program-${name} MODULE ${STEP_PROGRAM})
  if(STEP_SHARED)
    list(TRANSFORM STEP_SHARED PREPEND ${folder}/)
    add_library(shared-${name} OBJECT ${STEP_SHARED})
    list(APPEND parts shared-${name})
    list(APPEND STEP_SHARES ${name})
  endif()
  foreach(part IN LISTS parts)
    target_link_libraries(${part} PRIVATE atelier)
    target_include_directories(${part} PRIVATE ${PROJECT_SOURCE_DIR}/steps)
    set_target_properties(${part} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    atelier_precompile(${part})
  endforeach()
  foreach(step IN LISTS STEP_SHARES)
    target_sources(program-${name} PRIVATE $<TARGET_OBJECTS:shared-${step}>)
  endforeach()

  # Which of the steps have C++ of the student's, in the order of loading.
  set(libraries "")
  foreach(step IN LISTS STEP_USES)
    if(step IN_LIST ATELIER_STEPS_WITH_CPP)
      list(APPEND libraries ${step})
    endif()
  endforeach()
  if("${STEP_FILES}" MATCHES "\\.cpp")
    set(ATELIER_STEPS_WITH_CPP ${ATELIER_STEPS_WITH_CPP} ${name} PARENT_SCOPE)
    list(APPEND libraries ${name})
  endif()
  list(JOIN libraries "\",\"" libraries_c)
  if(libraries)
    set(libraries_c "\"${libraries_c}\"")
  endif()
  add_executable(${name} ${PROJECT_SOURCE_DIR}/common/app/launch.cpp)
  target_link_libraries(${name} PRIVATE atelier)
  target_compile_definitions(${name} PRIVATE ATELIER_STEP="${name}" "ATELIER_STEP_LIBRARIES=${libraries_c}")
  add_dependencies(${name} program-${name} atelier_prelude)

  set(solution ${PROJECT_SOURCE_DIR}/solutions/${name})
  set(sources ${STEP_FILES})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(TRANSFORM sources PREPEND ${solution}/)
  if(sources AND EXISTS ${solution} AND NOT EXISTS ${solution}/libstep.so)
    add_library(solution-${name} MODULE ${sources})
    target_link_libraries(solution-${name} PRIVATE atelier_options)
    target_compile_options(solution-${name} PRIVATE -Wno-unused-parameter)
    target_include_directories(solution-${name} PRIVATE ${PROJECT_SOURCE_DIR}/steps ${folder})
    set_target_properties(solution-${name} PROPERTIES OUTPUT_NAME step
      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/implementations/solutions/${name}
      UNITY_BUILD OFF)  # as a student's files are compiled
    add_dependencies(${name} solution-${name})
  endif()

  # This step's lines of step_flags.json.
  list(TRANSFORM STEP_HEADERS PREPEND ${name}/)
  foreach(used IN LISTS STEP_USES)
    get_property(earlier GLOBAL PROPERTY ATELIER_HEADERS_${used})
    list(APPEND STEP_HEADERS ${earlier})
  endforeach()
  set_property(GLOBAL PROPERTY ATELIER_HEADERS_${name} ${STEP_HEADERS})
  foreach(list FILES HEADERS USES)
    atelier_json_list(json ${STEP_${list}})
    set_property(GLOBAL APPEND PROPERTY ATELIER_JSON_${list} "    \"${name}\": ${json}")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY ATELIER_JSON_TITLES "    \"${name}\": \"${STEP_TITLE}\"")
endfunction()

# Writes BUILD/step_flags.json: how the atelier command builds students' files, and which files those are.
function(atelier_write_step_flags)
  set(compile ${ATELIER_STUDENT_FLAGS} -I${PROJECT_SOURCE_DIR}/common -I${PROJECT_SOURCE_DIR}/steps
              -include ${ATELIER_PRELUDE})
  atelier_json_list(compile ${compile})
  atelier_json_list(link ${ATELIER_STUDENT_LINK})
  foreach(list FILES HEADERS USES TITLES)
    get_property(lines GLOBAL PROPERTY ATELIER_JSON_${list})
    list(JOIN lines ",\n" ${list})
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/step_flags.json @ONLY CONTENT [[
{
  "compiler": "@CMAKE_CXX_COMPILER@",
  "compiler_version": "@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@",
  "compile": @compile@,
  "link": @link@,
  "titles": {
@TITLES@
  },
  "files": {
@FILES@
  },
  "headers": {
@HEADERS@
  },
  "uses": {
@USES@
  }
}
]])
endfunction()
