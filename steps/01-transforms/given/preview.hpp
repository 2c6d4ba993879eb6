// A placeholder for lighting until step 02: brighter where the surface faces the eye, with a checker pattern of the
// texture coordinates. Given.
#pragma once

#include "render/feature.hpp"

namespace atelier {

class Preview : public Feature {
 public:
  Need need(const Scene&, const View&, const Node&) const override { return {.wanted = true}; }
  std::map<Slot, SlotCode> slots() const override {
    return {{Slot::shade, {"01-transforms/given/preview.glsl", "preview"}}};
  }
  void bind_material(Binder& binder, const Scene&, const Material& material) override {
    binder.set("u_colour", material.diffuse);
  }
};

}  // namespace atelier
