function contextOf(canvas) {
  const gl = canvas.getContext('webgl');
  if (!gl) throw new Error('this browser has no WebGL');
  return gl;
}
