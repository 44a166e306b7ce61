#include <cstdio>

#include <lightcuts/cut_selector.h>
#include <lightcuts/tree_builder.h>

int main() {
  lightcuts::LightSet lights; // positions in metres, radiant intensities in W/sr
  for (int i = 0; i < 10000; ++i)
    lights.add_omni({float(i % 100), 30, float(i / 100)}, {1, 0.9F, 0.8F});

  const lightcuts::LightTree tree = lightcuts::build(lights);
  lightcuts::CutSelector select(tree, {.threshold = 0.02F, .max_size = 1000});

  const lightcuts::Material grey{.diffuse = {0.5F, 0.5F, 0.5F}};
  const lightcuts::ShadingPoint point({50, 0, 50}, /*normal*/ {0, 1, 0}, /*to_viewer*/ {0, 1, 0},
                                      grey);
  const auto visible = [](std::uint32_t /*light*/) { return true; }; // your shadow ray
  const lightcuts::Cut cut = select(point, visible);

  std::printf("radiance %g +- %g from %zu of %zu lights\n", double(cut.radiance.g),
              double(cut.certified_error.g), cut.clusters.size(), lights.size());
}
