# The tests make archives of their own, broken ones too.
find_package(LibArchive REQUIRED)
target_link_libraries(unit-grade PRIVATE atelier_grade LibArchive::LibArchive)
