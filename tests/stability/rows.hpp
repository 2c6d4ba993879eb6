// What the rows of every table are written with: include this, and begin.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "stability/extremes.hpp"
#include "stability/nan_row.hpp"
#include "stability/random.hpp"
#include "stability/shader_function.hpp"
#include "stability/table.hpp"
