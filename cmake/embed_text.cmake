# Writes OUTPUT, a C++ file that defines SYMBOL as the text of INPUT: see embed.cmake.
cmake_minimum_required(VERSION 3.25)
file(READ ${INPUT} text)
file(WRITE ${OUTPUT}
"#include \"${HEADER}\"

const std::string_view ${NAMESPACE}::${SYMBOL} = R\"embedded(${text})embedded\";
")
