# Reports belong to the judge; HTML is checked with the pictures that the image module writes.
target_link_libraries(unit-reports PRIVATE atelier_judge)
add_dependencies(unit-reports atelier-image-io)
