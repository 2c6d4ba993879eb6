# The judge's half of a case is tested beside the program's.
target_link_libraries(unit-case PRIVATE atelier_judge)
