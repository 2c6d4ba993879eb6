// The table of step 07, a function for each part of its contract.
#pragma once

#include <functional>
#include <tuple>

#include "07-stencil-portals/stencil_portals.hpp"
#include "stability/07-stencil-portals/frames.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_portal_rows(Table& table);
void add_mirror_rows(Table& table);
void add_view_rows(Table& table);
void add_plane_rows(Table& table);
void add_rectangle_rows(Table& table);
void add_through_rows(Table& table);
void add_carried_rows(Table& table);
void add_plane_in_view_rows(Table& table);
void add_oblique_rows(Table& table);
void add_cut_rows(Table& table, ShaderFunctions& shaders);
void add_crossing_rows(Table& table);
void add_oblique_order_rows(Table& table);
void add_image_rows(Table& table);
void add_body_rows(Table& table);
void add_light_rows(Table& table, ShaderFunctions& shaders);

inline constexpr const char* sums_of_products = "coordinates of that size through a matrix that is a product of three";

using Map = std::function<Exact(const Exact&)>;

/// The passage of a random portal, the exact map of its points, and where the entry stands. Both frames are
/// odd_frame(t, distance), or with `quarters` quarter_frame(t, distance).
std::tuple<glm::dmat4, Map, glm::dvec3> some_portal(Trial& t, double distance, bool quarters);
/// The same of a mirror.
std::tuple<glm::dmat4, Map, glm::dvec3> some_mirror(Trial& t, double distance, bool quarters);

}  // namespace atelier::stability
