// Small scenes for shadows, each with its light and its camera: so that demos, studies and tests look at the same thing.
//
// Lengths are metres where that makes sense, y is up, and the floor is y = 0. Casters are closed; floor and wall only
// receive. The camera suits a picture of this aspect, width/height: everything is in view at any, and composed for 4:3.
// Refused: an aspect that is not above 0 and finite.
#pragma once
#include "mv/geometry/scene.h"

namespace mv {

// A cube of side 1 on a floor that fills most of the picture, under a point light: the plainest shadow there is.
// Objects: floor, cube.
Scene cubeOnPlane(double aspect);
inline constexpr ObjectId cubeOnThePlane{1};

// That floor under that light and camera, with nothing on it. Objects: floor.
Scene floorAlone(double aspect);

// Boxes in boxes over that floor, under that light: as many shadows over one another as there are boxes.
// Objects: floor, shell 1 (the innermost) to shell `shells`.
Scene nestedShells(double aspect, int shells);

// The scene of WebGLFundamentals' lessons on shadows: a pink sphere of radius 1 that hangs over a floor, and a green cube
// on the floor, under a point light just above the sphere. Composed for 1:1, with sky. Objects: floor, sphere, cube.
Scene sphereAndCube(double aspect);
inline constexpr ObjectId sphereOfSphereAndCube{1};

// A pawn, a sphere, a box and a ring that leans on the wall, under a point light: shadows on a floor, on a wall, over an
// edge, through a hole, of a body on itself. Objects: floor, wall, pawn, ring, sphere, box.
Scene stillLife(double aspect);

// A table on four legs with a vase, an apple and a book, under a square lamp of 40 cm: the shadow of a leg is
// sharp at its foot and grows softer from there. Objects: floor, top, leg 1 to leg 4, vase, apple, book.
Scene table(double aspect);
inline constexpr ObjectId topOfTheTable{1};

// The course's cube, of side 2 about the origin and with a colour on each face, or the still life's things in its place,
// before a floor at z = -1.0125 and a wall at x = -3 that meet in an edge. Here z is up, and there is neither light nor
// camera. For floor and wall, column 1 of worldFromObject is the unit normal and column 3 the middle of that edge, so
// that worldFromObject * rotateX(-angle) leans them back. Objects: cube, floor, wall; pawn, ring, sphere, box, floor, wall.
Scene cubeInRoom();
Scene stillLifeInRoom();
namespace cubeInRoomScene {
inline constexpr ObjectId cube{0}, floor{1}, wall{2};
}
namespace stillLifeInRoomScene {
inline constexpr ObjectId pawn{0}, ring{1}, sphere{2}, box{3}, floor{4}, wall{5};
}

// A small house, 8 m wide and 6 m deep, with a garage on its right (+x), a chimney behind the ridge and its door on the
// left of the front (+z): no two of its six sides look alike. The house stands on y = 0, with its ridge along x; there
// is neither floor nor light nor camera. All of it lies within 8 m of (1.5, 3, 0). Objects: walls, roof front, roof
// back, chimney, garage, gate, door, window 1 to window 3.
Scene house();

// That house at (-1.5, 0, -20), and on either side of it two rows of trees 5 m high, from z = -4 to z = -40, 6 m apart:
// for a camera at (0, 3, 0) that looks along -z. Each object has the colours of its parts at its vertices, and all trees
// have the same mesh. There is neither floor nor light nor camera. Objects: house, tree 1 to tree 28.
Scene garden();

}  // namespace mv
