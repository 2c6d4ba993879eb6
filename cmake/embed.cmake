# atelier_embed(TARGET FILE HEADER NAMESPACE SYMBOL): compiles the text of FILE into TARGET as the std::string_view
# SYMBOL, which HEADER declares.
function(atelier_embed target file header namespace symbol)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.cpp)
  set(input ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${input} -DOUTPUT=${source} -DHEADER=${header} -DNAMESPACE=${namespace}
            -DSYMBOL=${symbol} -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
    DEPENDS ${input} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake VERBATIM COMMENT "Embedding ${file}")
  target_sources(${target} PRIVATE ${source})
endfunction()
