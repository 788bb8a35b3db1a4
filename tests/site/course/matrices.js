// 4 x 4, by columns.
function product(a, b) {
  return a.map((none, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[4 * (i >> 2) + k], 0));
}

// A turn in the plane of the axes i and j.
function turned(degrees, i, j) {
  const m = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], angle = (degrees * Math.PI) / 180;
  m[5 * i] = m[5 * j] = Math.cos(angle);
  m[4 * i + j] = Math.sin(angle);
  m[4 * j + i] = -Math.sin(angle);
  return m;
}

function perspective(degrees, near, far) {
  const scale = 1 / Math.tan((degrees * Math.PI) / 360), depth = near - far;
  return [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, (far + near) / depth, -1, 0, 0, (2 * far * near) / depth, 0];
}
