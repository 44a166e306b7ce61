// SPDX-License-Identifier: MIT
#include <oracle/properties/shading/picture_case.h>

namespace lightcuts::oracle {

const PropertyInfo property::pixels_equal_points{
    .name = "pixels-equal-points",
    .statement = "A picture's pixel is what a cut for the point it sees gives.",
    .formula = "radiance of the pixel = radiance of the cut, to the last bit; 0 where it sees "
               "nothing",
    .needs = only(Part::pictures),
    .of_picture =
        [](const PictureCase& of, const Recorder& record) {
          of.for_each_pixel([&](glm::uvec2 pixel) {
            record(of.shown(pixel) == of.expected(pixel), [&] { return of.text(pixel); });
          });
        },
};

} // namespace lightcuts::oracle
