# Features of steps beside each other: their given parts, and the solutions of what students write.
target_link_libraries(unit-compose PRIVATE given-04-point-shadows given-06-parallax-mapping)  # with those of the steps that it uses
file(GLOB solutions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solutions/0[1-6]-*/*.cpp)
target_sources(unit-compose PRIVATE ${solutions})
set_source_files_properties(${solutions} PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "-Wno-unused-parameter")
file(GLOB contracts CONFIGURE_DEPENDS LIST_DIRECTORIES true ${PROJECT_SOURCE_DIR}/steps/0[1-6]-*)
target_include_directories(unit-compose PRIVATE ${PROJECT_SOURCE_DIR}/steps ${contracts})
