// Step 01 once more, in double precision and by other ways than the contract's formulas: what its rows are held
// against. None of these functions shares a line with a solution.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/transforms.hpp"

namespace atelier::stability::exact {

/// Turns `v` about `axis`, of any length but zero, by `angle` radians: q v q*, with q the quaternion
/// (cos angle/2, sin angle/2 axis) (W. R. Hamilton), where the contract has Rodrigues' matrix.
glm::dvec3 rotated(const glm::dvec3& axis, double angle, const glm::dvec3& v);

/// The matrix whose columns are the turned axes.
glm::dmat3 rotation(const glm::dvec3& axis, double angle);

/// Where a point lies for a camera: its components along right, up and backwards. `up` must not be parallel to the
/// view. By projecting `up` onto the picture plane, where the contract has cross products.
glm::dvec3 in_view(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, const glm::dvec3& point);

/// Depth -1..1 at distance z before the eye: 1/z, stretched so that the planes become -1 and +1.
double depth(double near, double far, double z);
/// Depth 1..0; `far` may be infinite.
double depth_reversed(double near, double far, double z);

/// Where a surface with the tangents t1 and t2 has its normal once `model` has moved them: their cross product, on the
/// side that t1 x t2 was on (a mirror swaps the sides).
glm::dvec3 normal(const glm::dmat3& model, const glm::dvec3& t1, const glm::dvec3& t2);

/// World matrices of joints in double precision, by walking up from each: slow, without memory of what is done.
std::vector<glm::dmat4> world_matrices(const std::vector<Joint>& joints);

}  // namespace atelier::stability::exact
