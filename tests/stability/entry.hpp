// What each table's module defines. It is a module because it calls a step's functions, which are loaded before it.
#pragma once

#include "stability/shader_function.hpp"
#include "stability/table.hpp"

namespace atelier::stability {

/// extern "C" void atelier_stability_table(Table&, ShaderFunctions&): fills in the table. The rows keep a reference to
/// the shader functions.
using MakeTable = void(Table& table, ShaderFunctions& shaders);

}  // namespace atelier::stability

extern "C" void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders);
