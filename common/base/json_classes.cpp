// Explicit instantiations of the JSON library's two classes, for all other files: see cmake/parts.hpp.
#include <nlohmann/json.hpp>

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;
