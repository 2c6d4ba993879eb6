target_link_libraries(unit-cli PRIVATE atelier_commands)
