// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/tree/tree_builder.h>
