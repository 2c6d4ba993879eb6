# Loaded, not linked: nothing else says that the tests need it.
add_dependencies(unit-gl atelier-window-context)
