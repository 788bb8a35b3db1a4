// The values that a vertex hands on from stage to stage, in world space. A block is known by its own name, and its
// members by an instance's: so a stage may take `from[]` and give the same names. ES 3.0 has two stages, and no blocks
// between them.
#ifdef GL_ES
#define VERTEX(direction) \
    direction vec3 place; \
    direction vec3 facing
#else
#define VERTEX(direction)     \
    direction Vertex {        \
        vec3 place, facing;   \
    }
#endif
