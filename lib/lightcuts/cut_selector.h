// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/cut/cut_selector.h>
