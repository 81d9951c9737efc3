#include "assets/generator/car.h"

#include "assets/generator/body_shape.h"
#include "assets/generator/car_body.h"
#include "assets/generator/car_fittings.h"
#include "assets/generator/car_wheel.h"
#include "assets/generator/materials.h"

namespace unghost::author {

namespace {

// One primitive a material: fewer draws.
std::vector<Part> merged(const std::vector<Part>& parts) {
  std::vector<Part> out;
  for (const Part& part : parts) {
    Part* same = nullptr;
    for (Part& other : out)
      if (other.material == part.material) same = &other;
    same ? same->triangles.append(part.triangles) : out.push_back(part);
  }
  return out;
}

} // namespace

int add_car(Glb& glb) {
  const CarMaterials materials = add_car_materials(glb);
  const int car = glb.add_node("car", -1, {}, {{"extras", {{"vehicle", true}, {"tag", 1}}}});
  std::vector<Part> body = car_body(materials);
  for (Part& part : car_fittings(materials)) body.push_back(std::move(part));
  glb.add_node("car_body", car, {}, {{"mesh", glb.add_mesh("car_body", merged(body))}});
  const int wheel = glb.add_mesh("wheel", merged(car_wheel(materials)));
  for (const bool front : {true, false}) {
    // Calipers sit towards the middle of the car; a right-hand one is the other mesh, turned.
    const int leading = glb.add_mesh(front ? "caliper_front_left" : "caliper_rear_left",
                                     brake_caliper(materials, front ? -1 : 1));
    const int trailing = glb.add_mesh(front ? "caliper_front_right" : "caliper_rear_right",
                                      brake_caliper(materials, front ? 1 : -1));
    for (const bool left : {true, false}) {
      const std::string place = std::string(front ? "front" : "rear") + (left ? "_left" : "_right");
      const Placement hub{.translation = {left ? Chassis::wheel_x : -Chassis::wheel_x, Chassis::wheel_radius,
                                          front ? Chassis::axle_z : -Chassis::axle_z}};
      const Placement outwards{.rotation = left ? glm::dquat(1, 0, 0, 0) : glm::dquat(0, 0, 1, 0)};
      const int pivot =
          glb.add_node("wheel_" + place, car, hub,
                       {{"extras", {{"wheel", {{"radius", Chassis::wheel_radius}, {"steers", front}}}}}});
      glb.add_node("wheel_mesh_" + place, pivot, outwards, {{"mesh", wheel}});
      glb.add_node("caliper_" + place, car, {hub.translation, outwards.rotation},
                   {{"mesh", left ? leading : trailing}});
    }
  }
  return car;
}

} // namespace unghost::author
