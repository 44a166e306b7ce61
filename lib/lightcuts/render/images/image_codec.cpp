// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/image_codec.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <lightcuts/render/files/beside_program.h>
#include <lightcuts/render/files/text.h>

namespace lightcuts {

const ImageCodec& load_image_codec(const std::filesystem::path& module) {
  // Symbols are looked up when first called: that is most of the time it takes otherwise.
  void* library = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* symbol = library ? dlsym(library, image_codec_symbol) : nullptr;
  if (!symbol)
    throw InputError(InputFault::unreadable_file,
                     one_line(fmt::format("images cannot be read or written without the module "
                                          "{}, which cannot be loaded: {}",
                                          module.string(), dlerror())));
  return *reinterpret_cast<ImageCodecFunction>(symbol)();
}

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load_image_codec(beside_program(LIGHTCUTS_IMAGE_CODEC));
  return codec;
}

} // namespace lightcuts
