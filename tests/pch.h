// Precompiled for the tests: the engine's, and GoogleTest.
#pragma once
#include <gtest/gtest.h>

#include "engine/pch.h"
