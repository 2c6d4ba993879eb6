# atelier_step(NAME TITLE "..." FILES a.cpp a.glsl [USES 01-transforms ...]), called by steps/NAME/given/step.cmake
#
# NAME      the folder below steps/
# FILES     what the student writes; the solution has the same names
# USES      earlier steps whose functions are called or whose given code is used
#
# The contract is steps/NAME/*.hpp, which the student's files may include; the given code is steps/NAME/given/.
#
# Makes the executable NAME and the given program as a module that it loads. If solutions/NAME exists, also the
# solution's library, unless a release contains it already compiled (solutions/NAME/libstep.so). Students' files are not
# built here: the atelier command builds them with the same flags (step_flags.json), so that their errors do not stop
# the build.

set(ATELIER_STUDENT_FLAGS -std=c++20 -O2 -g1 -fPIC -ffp-contract=off -Wall -Wextra -Wno-unused-parameter -DGLM_FORCE_SILENT_WARNINGS)
if(ATELIER_SANITIZE)
  list(APPEND ATELIER_STUDENT_FLAGS -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
endif()
set(ATELIER_STUDENT_LINK -shared)
if(ATELIER_MOLD)
  list(APPEND ATELIER_STUDENT_LINK -fuse-ld=mold)
endif()

# The precompiled header of students' files; it saves a quarter of the time from an edit to a verdict.
set(ATELIER_PRELUDE ${CMAKE_BINARY_DIR}/student/prelude.hpp)
configure_file(${PROJECT_SOURCE_DIR}/cmake/prelude.hpp ${ATELIER_PRELUDE} COPYONLY)
add_custom_command(
  OUTPUT ${ATELIER_PRELUDE}.gch
  COMMAND ${CMAKE_CXX_COMPILER} ${ATELIER_STUDENT_FLAGS} -I${PROJECT_SOURCE_DIR}/common -x c++-header
          -MD -MF ${ATELIER_PRELUDE}.d -MT ${ATELIER_PRELUDE}.gch ${ATELIER_PRELUDE} -o ${ATELIER_PRELUDE}.gch
  DEPENDS ${ATELIER_PRELUDE} DEPFILE ${ATELIER_PRELUDE}.d VERBATIM COMMENT "Precompiling the students' prelude")
add_custom_target(atelier_prelude ALL DEPENDS ${ATELIER_PRELUDE}.gch)

# Checks that the given code includes files only from steps in USES; otherwise it would fail later with an undefined
# symbol.
function(atelier_check_uses name)
  set(stamp ${CMAKE_BINARY_DIR}/steps/${name}.uses)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${name}/given/*)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${CMAKE_COMMAND} "-DSTEP=${name}" "-DUSES=${ARGN}" -DSTEPS=${PROJECT_SOURCE_DIR}/steps -DSTAMP=${stamp}
            -P ${PROJECT_SOURCE_DIR}/cmake/check_uses.cmake
    DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/check_uses.cmake VERBATIM
    COMMENT "Checking the steps that ${name} uses")
  add_custom_target(uses-${name} DEPENDS ${stamp})
  add_dependencies(program-${name} uses-${name})
endfunction()

function(atelier_json_list out)
  set(quoted "")
  foreach(item IN LISTS ARGN)
    list(APPEND quoted "\"${item}\"")
  endforeach()
  list(JOIN quoted ", " joined)
  set(${out} "[${joined}]" PARENT_SCOPE)
endfunction()

function(atelier_step name)
  cmake_parse_arguments(STEP "" "TITLE" "FILES;USES" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/steps/${name})

  # Compile the given code once, to a static library that later steps' programs link too.
  file(GLOB given CONFIGURE_DEPENDS ${folder}/given/*.cpp)
  atelier_unseal(unsealed ${folder}/given ${name})
  list(APPEND given ${unsealed})
  set(program ${folder}/given/main.cpp)
  list(REMOVE_ITEM given ${program})
  add_library(program-${name} MODULE ${program})
  set(parts program-${name})
  if(given)
    add_library(given-${name} STATIC ${given})
    list(APPEND parts given-${name})
  endif()
  foreach(part IN LISTS parts)
    target_link_libraries(${part} PUBLIC atelier)
    target_include_directories(${part} PRIVATE ${PROJECT_SOURCE_DIR}/steps)
    target_compile_definitions(${part} PRIVATE ATELIER_STEP="${name}" "ATELIER_STEP_TITLE=\"${STEP_TITLE}\"")
    set_target_properties(${part} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    atelier_precompile(${part})
    foreach(step IN LISTS STEP_USES)
      if(TARGET given-${step})
        target_link_libraries(${part} PUBLIC given-${step})
      endif()
    endforeach()
  endforeach()
  if(given)
    target_link_libraries(program-${name} PRIVATE given-${name})
  endif()
  atelier_check_uses(${name} ${STEP_USES})

  # The steps with C++ files of the student, in loading order.
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
  set_property(GLOBAL PROPERTY ATELIER_LIBRARIES_${name} ${libraries})
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
      UNITY_BUILD OFF)  # as for students' files
    add_dependencies(${name} solution-${name})
  endif()

  # This step's lines in step_flags.json.
  file(GLOB STEP_HEADERS CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/steps ${folder}/*.hpp)
  foreach(used IN LISTS STEP_USES)
    get_property(earlier GLOBAL PROPERTY ATELIER_HEADERS_${used})
    list(APPEND STEP_HEADERS ${earlier})
  endforeach()
  list(REMOVE_DUPLICATES STEP_HEADERS)
  set_property(GLOBAL PROPERTY ATELIER_HEADERS_${name} ${STEP_HEADERS})
  foreach(list FILES HEADERS USES)
    atelier_json_list(json ${STEP_${list}})
    set_property(GLOBAL APPEND PROPERTY ATELIER_JSON_${list} "    \"${name}\": ${json}")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY ATELIER_JSON_TITLES "    \"${name}\": \"${STEP_TITLE}\"")
endfunction()

# Writes BUILD/step_flags.json, which tells the atelier command which files students write and how to compile them.

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
