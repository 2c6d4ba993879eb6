# The tests of picture files load the module at run time, so nothing links it.
add_dependencies(unit-image atelier-image-io)
