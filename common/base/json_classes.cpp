// The JSON library's two classes, compiled here for all other files: see cmake/parts.hpp.
#include <nlohmann/json.hpp>

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;
