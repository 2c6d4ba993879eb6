# Traces the pictures of its tests, thousands of them: without optimisation most of the time goes there.
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/synthetic.cpp PROPERTIES
  COMPILE_OPTIONS -O2
  SKIP_PRECOMPILE_HEADERS ON)  # GCC refuses headers precompiled with other options
