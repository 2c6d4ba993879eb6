# The tests make archives of their own, broken ones too, and pictures for reports.
find_package(LibArchive REQUIRED)
target_link_libraries(unit-grade PRIVATE atelier_grade LibArchive::LibArchive)
add_dependencies(unit-grade atelier-image-io)
