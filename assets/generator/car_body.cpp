#include "assets/generator/car_body.h"

#include <cmath>

#include "assets/generator/body_shape.h"
#include "assets/generator/curve.h"
#include "assets/generator/panel_mesh.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3;

namespace {

constexpr double elsewhere = 0.5; // what a field says where its view does not look: far outside

double side_view(const Outline& outline, dvec3 p) {
  return p.x > 0.35 ? outline.distance({p.z, p.y}) : elsewhere;
}

double top_view(const Outline& outline, dvec3 p) {
  return p.y > 0.45 ? outline.distance({p.z, std::abs(p.x)}) : elsewhere;
}

double front_view(const Outline& outline, dvec3 p) {
  return p.z > 1.3 ? outline.distance({std::abs(p.x), p.y}) : elsewhere;
}

double rear_view(const Outline& outline, dvec3 p) {
  return p.z < -1.5 ? outline.distance({std::abs(p.x), p.y}) : elsewhere;
}

// Both the wheel's circle and how far in the well reaches.
double arch(dvec3 p, double axle) {
  const double circle = std::hypot(p.z - axle, p.y - Chassis::wheel_radius) - Chassis::arch_radius;
  return std::max(circle, Chassis::well_x - p.x);
}

void cut_glass(PanelMesh& mesh) {
  const Outline side = Outline::smooth({{0.60, 0.935},
                                        {0.42, 1.018},
                                        {0.20, 1.108},
                                        {-0.05, 1.158},
                                        {-0.35, 1.172},
                                        {-0.70, 1.148},
                                        {-1.02, 1.088},
                                        {-1.28, 1.012},
                                        {-1.27, 0.985},
                                        {-0.95, 0.972},
                                        {-0.35, 0.952},
                                        {0.20, 0.938},
                                        {0.50, 0.925}});
  const Outline screen = Outline::rounded({{0.83, -0.8},
                                           {0.83, 0.0},
                                           {0.795, 0.35},
                                           {0.69, 0.64},
                                           {0.44, 0.575},
                                           {0.05, 0.475},
                                           {0.075, 0.25},
                                           {0.09, 0.0},
                                           {0.09, -0.8}});
  const Outline back = Outline::rounded({{-0.98, -0.6},
                                         {-0.98, 0.0},
                                         {-0.99, 0.25},
                                         {-1.02, 0.44},
                                         {-1.40, 0.425},
                                         {-1.72, 0.36},
                                         {-1.78, 0.15},
                                         {-1.79, 0.0},
                                         {-1.79, -0.6}});
  for (const Outline* view : {&screen, &back})
    mesh.cut([&](dvec3 p) { return top_view(*view, p); }, Panel::paint, Panel::trim);
  mesh.cut([&](dvec3 p) { return side_view(side, p); }, Panel::paint, Panel::trim);
  for (const Outline* view : {&screen, &back})
    mesh.cut([&](dvec3 p) { return top_view(*view, p) + 0.016; }, Panel::trim, Panel::glass);
  mesh.cut([&](dvec3 p) { return side_view(side, p) + 0.012; }, Panel::trim, Panel::glass);
  const Outline pillar({{-0.42, 0.8}, {-0.48, 1.3}, {-0.53, 1.3}, {-0.47, 0.8}});
  mesh.cut([&](dvec3 p) { return side_view(pillar, p); }, Panel::glass, Panel::trim);
}

void cut_ends(PanelMesh& mesh) {
  const Outline lamp = Outline::smooth({{0.47, 0.574},
                                        {0.58, 0.556},
                                        {0.70, 0.566},
                                        {0.79, 0.600},
                                        {0.832, 0.650},
                                        {0.80, 0.668},
                                        {0.68, 0.640},
                                        {0.56, 0.612}});
  const Outline mouth =
      Outline::rounded({{-0.5, 0.47}, {0.42, 0.47}, {0.56, 0.40}, {0.50, 0.27}, {-0.5, 0.27}});
  const Outline duct = Outline::rounded({{0.67, 0.40}, {0.80, 0.42}, {0.79, 0.27}, {0.62, 0.27}});
  const Outline band = Outline::rounded({{-0.5, 0.805},
                                         {0.60, 0.805},
                                         {0.80, 0.812},
                                         {0.855, 0.79},
                                         {0.83, 0.705},
                                         {0.62, 0.700},
                                         {-0.5, 0.715}},
                                        2);
  const Outline tail = Outline::rounded({{-0.5, 0.775},
                                         {0.50, 0.775},
                                         {0.62, 0.792},
                                         {0.83, 0.797},
                                         {0.80, 0.722},
                                         {0.62, 0.718},
                                         {0.50, 0.750},
                                         {-0.5, 0.750}},
                                        2);
  const Outline diffuser =
      Outline::rounded({{-0.5, 0.37}, {0.52, 0.37}, {0.64, 0.30}, {0.70, 0.1}, {-0.5, 0.1}}, 2);
  mesh.cut([&](dvec3 p) { return front_view(lamp, p); }, Panel::paint, Panel::lamp);
  mesh.cut([&](dvec3 p) { return front_view(lamp, p) + 0.009; }, Panel::lamp, Panel::lamp_bowl);
  mesh.cut([&](dvec3 p) { return front_view(mouth, p); }, Panel::paint, Panel::grille);
  mesh.cut([&](dvec3 p) { return front_view(duct, p); }, Panel::paint, Panel::duct);
  mesh.cut([&](dvec3 p) { return rear_view(band, p); }, Panel::paint, Panel::trim);
  mesh.cut([&](dvec3 p) { return rear_view(tail, p); }, Panel::trim, Panel::tail_lamp);
  mesh.cut([&](dvec3 p) { return rear_view(diffuser, p); }, Panel::paint, Panel::plastic);
}

void score_seams(PanelMesh& mesh) {
  const double width = 0.007;
  const auto score = [&](const PanelMesh::Field& field) {
    mesh.score(field, width, Panel::paint, Panel::gap);
  };
  const Outline door = Outline::rounded({{0.60, 0.94},
                                         {0.665, 0.80},
                                         {0.61, 0.55},
                                         {0.57, 0.33},
                                         {-0.42, 0.33},
                                         {-0.50, 0.45},
                                         {-0.62, 0.72},
                                         {-0.60, 0.95},
                                         {-0.50, 1.10},
                                         {0.0, 1.08}});
  const Outline bonnet = Outline::rounded({{0.86, -0.9},
                                           {0.86, 0.60},
                                           {0.80, 0.685},
                                           {1.35, 0.625},
                                           {1.86, 0.50},
                                           {2.00, 0.30},
                                           {2.03, 0.0},
                                           {2.03, -0.9}},
                                          2);
  const Outline boot =
      Outline::rounded({{-1.84, -0.9}, {-1.84, 0.45}, {-1.90, 0.60}, {-2.6, 0.60}, {-2.6, -0.9}}, 2);
  score([&](dvec3 p) { return side_view(door, p); });
  score([&](dvec3 p) { return p.z > 0 ? top_view(bonnet, p) : elsewhere; });
  score([&](dvec3 p) { return p.z < 0 && p.y > 0.86 ? top_view(boot, p) : elsewhere; });
}

PanelMesh panels() {
  PanelMesh mesh;
  for (const double axle : {Chassis::axle_z, -Chassis::axle_z})
    mesh.cut([axle](dvec3 p) { return arch(p, axle); }, Panel::paint, Panel::nothing);
  mesh.cut([](dvec3 p) { return p.y - 0.225; }, Panel::paint, Panel::plastic);
  cut_glass(mesh);
  cut_ends(mesh);
  score_seams(mesh);
  mesh.simplify(0.0015);
  return mesh;
}

// From a rim of the bodywork inwards: the lip that gives the panel its thickness, then the well as far as it
// goes.
Triangles wheel_wells(const PanelMesh& mesh) {
  Triangles half;
  for (const auto& [a, b] : mesh.rims()) {
    if (std::min(a.x, b.x) < Chassis::well_x + 0.02 || std::max(a.y, b.y) < 0.17) continue;
    const double axle = a.z > 0 ? Chassis::axle_z : -Chassis::axle_z;
    const dvec3 hub(0, Chassis::wheel_radius, axle);
    const auto inwards = [&](dvec3 p) { return glm::normalize(dvec3(0, hub.y - p.y, hub.z - p.z)); };
    const dvec3 a_in(Chassis::well_x, a.y, a.z), b_in(Chassis::well_x, b.y, b.z);
    const uint32_t first = half.add(a, inwards(a));
    half.add(b, inwards(b));
    half.add(b_in, inwards(b));
    half.add(a_in, inwards(a));
    half.quad(first + 1, first, first + 3, first + 2);
    const uint32_t disc = half.add(a_in, {1, 0, 0});
    half.add(b_in, {1, 0, 0});
    half.add({Chassis::well_x, hub.y - 0.17, hub.z}, {1, 0, 0});
    half.triangle(disc + 1, disc, disc + 2);
  }
  Triangles both = half;
  both.append(mirrored(half));
  return both;
}

} // namespace

std::vector<Part> car_body(const CarMaterials& m) {
  PanelMesh mesh = panels();
  const Triangles wells = wheel_wells(mesh);
  mesh.sink(Panel::grille, {-0.02, 0, -0.05}, Panel::plastic);
  mesh.sink(Panel::duct, {-0.035, 0, -0.045}, Panel::plastic);
  mesh.sink(Panel::lamp_bowl, {-0.012, -0.012, -0.045}, Panel::trim);
  Triangles black = mesh.both_sides(Panel::trim);
  black.append(mesh.both_sides(Panel::lamp_bowl));
  Triangles plastic = mesh.both_sides(Panel::plastic);
  plastic.append(mesh.both_sides(Panel::grille));
  plastic.append(mesh.both_sides(Panel::duct));
  plastic.append(mesh.both_sides(Panel::gap));
  plastic.append(wells);
  return {{m.paint, mesh.both_sides(Panel::paint)},
          {m.glass, mesh.both_sides(Panel::glass)},
          {m.gloss_black, black},
          {m.plastic, plastic},
          {m.lamp, mesh.both_sides(Panel::lamp)},
          {m.tail_lamp, mesh.both_sides(Panel::tail_lamp)}};
}

} // namespace unghost::author
