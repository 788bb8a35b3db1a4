// All that a demo needs to draw with.
#pragma once
#include "mv/gl/depth_map.h"
#include "mv/gl/drawing.h"
#include "mv/gl/feedback.h"
#include "mv/gl/functions.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/target.h"
#include "mv/gl/text.h"
#include "mv/gl/text_column.h"
#include "mv/gl/texture.h"
#include "mv/gl/triangle_count.h"
