// AlongPicture before an `in` or `out`: interpolated along the picture, not along the surface. GLSL ES 3.00 has no
// `noperspective`; there a vertex is divided by its w before the driver sees it (alongPicture), which makes all w 1: for
// surfaces that are wholly before the eye.
#ifdef GL_ES
#define AlongPicture
vec4 alongPicture(vec4 clip) { return vec4(clip.xyz / clip.w, 1.0); }
#else
#define AlongPicture noperspective
vec4 alongPicture(vec4 clip) { return clip; }
#endif
