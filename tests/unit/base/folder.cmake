# A module to load: what common/base/module.hpp is tried on.
add_library(atelier-test-module MODULE ${CMAKE_CURRENT_LIST_DIR}/module/test_module.cpp)
add_dependencies(unit-base atelier-test-module)
