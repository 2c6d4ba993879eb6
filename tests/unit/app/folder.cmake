# The parts of the window that need no window are tested directly; the rest through a program under xvfb-run.
foreach(part IN ITEMS orbit controls viewer presenter restart)
  target_sources(unit-app PRIVATE ${PROJECT_SOURCE_DIR}/common/app/window/${part}.cpp)
endforeach()
add_dependencies(unit-app atelier-window atelier-image-io)
