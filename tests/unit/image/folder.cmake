# The tests of picture files load the module at run time, so nothing links it.
add_dependencies(unit-image atelier-image-io)
# Libraries behind OpenImageIO end threads at exit. LeakSanitizer's tracer has crashed on one of them (once in some fifty
# runs, "Tracer caught signal 11"); addresses and undefined behaviour are checked all the same.
set_property(TEST unit-image APPEND PROPERTY ENVIRONMENT ASAN_OPTIONS=detect_leaks=0)
