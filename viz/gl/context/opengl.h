// SPDX-License-Identifier: MIT
#pragma once

// The only place that includes OpenGL: this header and <GL/gl.h> exclude each other. Functions are
// linked, not loaded, so prototypes are wanted.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>
