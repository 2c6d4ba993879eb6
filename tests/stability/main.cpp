// Tries one table and writes down what came out. The build says which table it is and whose code it needs.
//
//   stability-02-blinn-phong SEARCH_PATH FILE
//
// SEARCH_PATH (case/implementations.hpp) says whose functions are tried. FILE becomes JSON:
//   {"table": "02-blinn-phong",
//    "rows": [{"function", "extreme", "demand", "error", "bound", "unit", "reason", "held", "words"}],
//    "sweeps": [{"name", "title", "x", "y", "log_x", "log_y", "curves": [{"name", "points": [[x, y]]}]}]}
// An error of null is infinite: nothing sensible came out. The exit status is 0 whatever the rows say.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/load.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/module.hpp"
#include "gl/context.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const Row& row, const Result& result) {
  return {{"function", row.function},   {"extreme", row.extreme},   {"demand", to_string(row.demand)},
          {"error", result.error},      {"bound", row.bound.value}, {"unit", row.bound.unit},
          {"reason", row.bound.reason}, {"held", result.held},      {"words", result.words}};
}

OrderedJson to_json(const Sweep& sweep) {
  OrderedJson curves = OrderedJson::array();
  for (const Curve& curve : sweep.curves) {
    OrderedJson points = OrderedJson::array();
    for (const glm::dvec2& p : curve.points) points.push_back({p.x, p.y});
    curves.push_back({{"name", curve.name}, {"points", std::move(points)}});
  }
  return {{"name", sweep.name},   {"title", sweep.title}, {"x", sweep.x_label},         {"y", sweep.y_label},
          {"log_x", sweep.log_x}, {"log_y", sweep.log_y}, {"curves", std::move(curves)}};
}

OrderedJson try_table(const Table& table) {
  OrderedJson rows = OrderedJson::array(), sweeps = OrderedJson::array();
  for (const Row& row : table.rows) rows.push_back(to_json(row, try_row(row)));
  for (const auto& sweep : table.sweeps) sweeps.push_back(to_json(sweep()));
  return {{"table", ATELIER_TABLE}, {"rows", std::move(rows)}, {"sweeps", std::move(sweeps)}};
}

void run(const std::string& search_path, const std::filesystem::path& file) {
  const StepIdentity identity{.name = ATELIER_TABLE, .libraries = {ATELIER_TABLE_LIBRARIES}};
  const Implementations implementations = with_given_files(Implementations::parse(search_path));
  load_libraries(identity, implementations);
  const auto make = reinterpret_cast<MakeTable*>(module_symbol("stability-" ATELIER_TABLE, "atelier_stability_table"));

  const auto context = make_headless_context();
  ShaderFunctions shaders(context->gl(), [&](const std::string& name) { return implementations.find(name); });
  Table table;
  make(table, shaders);
  write_file(file, try_table(table).dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
}

}  // namespace
}  // namespace atelier::stability

int main(int count, char** arguments) {
  if (count != 3) {
    fmt::print(stderr, "error: usage: stability-{} SEARCH_PATH FILE\n", ATELIER_TABLE);
    return atelier::exit_usage;
  }
  try {
    atelier::stability::run(arguments[1], arguments[2]);
    return atelier::exit_ok;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return atelier::exit_usage;
  }
}
