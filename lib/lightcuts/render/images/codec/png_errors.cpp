// SPDX-License-Identifier: MIT
// libpng prints an error that it has reported already, unless the function that it reports it to
// does not return; OpenImageIO's does. This module comes before libpng where OpenImageIO's symbols
// are looked up, so it is told of that function, and hands on one that does not return.
#include <atomic>
#include <cstring>

#include <dlfcn.h>

namespace {

// As in png.h.
using Report = void (*)(void* png, const char* message);
using SetReports = void (*)(void* png, void* pointer, Report error, Report warning);
using Jump = void (*)(void* png, int value);

template <class Function>
Function of_libpng(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

std::atomic<Report> reported_to; ///< OpenImageIO's, which has one for all that it reads

void report_and_leave(void* png, const char* message) {
  reported_to.load()(png, message);
  static const auto jump = of_libpng<Jump>("png_longjmp");
  if (jump != nullptr) jump(png, 1);
}

/// Others that OpenImageIO brings along read PNGs, too.
bool is_of_open_image_io(Report report) {
  Dl_info info{};
  return report != nullptr && dladdr(reinterpret_cast<void*>(report), &info) != 0 &&
         std::strstr(info.dli_fname, "libOpenImageIO") != nullptr;
}

} // namespace

extern "C" void png_set_error_fn(void* png, void* pointer, Report error, Report warning) {
  static const auto set = of_libpng<SetReports>("png_set_error_fn");
  if (set == nullptr) return; // libpng has its own
  Report before = nullptr;
  const bool first =
      is_of_open_image_io(error) && reported_to.compare_exchange_strong(before, error);
  set(png, pointer, first || (error != nullptr && before == error) ? report_and_leave : error,
      warning);
}
