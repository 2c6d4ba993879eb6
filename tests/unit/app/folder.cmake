# The parts of the window that need no window are tested directly; the rest through a program under xvfb-run.
foreach(part IN ITEMS orbit colour_codes controls viewer presenter restart)
  target_sources(unit-app PRIVATE ${PROJECT_SOURCE_DIR}/common/app/window/${part}.cpp)
endforeach()
add_dependencies(unit-app atelier-window atelier-image-io)

# The panel's controls by Dear ImGui, which needs no window either.
if(TARGET PkgConfig::imgui)
  target_sources(unit-app PRIVATE ${PROJECT_SOURCE_DIR}/common/app/window/settings_editor.cpp
                                  ${CMAKE_CURRENT_LIST_DIR}/panel/settings_editor_test.cpp)
  target_link_libraries(unit-app PRIVATE PkgConfig::imgui)
endif()
