"""three.js: the functions of the module that make the light of a map exact on every side of a thing."""

ENVIRONMENT = """
// The map as the light of physical materials (MeshStandardMaterial, MeshPhysicalMaterial). three.js blurs it by
// Gaussians, up to 23 % off in diffuse light; here the level that it reads for that gets the light over each normal,
// summed over the map. Later releases hold no such level: there its own filter stays.
export function environmentOf(sky, renderer) {
  const generator = new THREE.PMREMGenerator(renderer);
  const blurred = generator.fromEquirectangular(sky).texture;
  generator.dispose();
  if (blurred.mapping !== THREE.CubeUVReflectionMapping) return blurred;
  const level = new THREE.DataTexture(diffuseLevel(lightOf(sky)), 48, 32, THREE.RGBAFormat, THREE.HalfFloatType);
  level.needsUpdate = true;
  renderer.copyTextureToTexture(level, blurred, null, new THREE.Vector2(288, blurred.image.height - 64));
  return blurred;
}

// Directions (x, y, z) and light (RGB times solid angle) of 128 x 64 cells of a map of half floats.
function lightOf({ image: { width, height, data }, flipY }) {
  const cells = Array.from({ length: 128 * 64 }, () => [0, 0, 0, 0, 0, 0]);
  for (let row = 0; row < height; row++) {
    const y = flipY ? height - 1 - row : row, tilt = ((y + 0.5) / height - 0.5) * Math.PI;
    const solid = Math.cos(tilt) * 2 * Math.sin(Math.PI / 2 / height) * 2 * Math.PI / width;
    for (let column = 0; column < width; column++) {
      const turn = ((column + 0.5) / width - 0.5) * 2 * Math.PI;
      const cell = cells[128 * Math.floor(64 * y / height) + Math.floor(128 * column / width)];
      const toward = [Math.cos(tilt) * Math.cos(turn), Math.sin(tilt), Math.cos(tilt) * Math.sin(turn)];
      for (let k = 0; k < 3; k++) {
        cell[k] += toward[k] * solid;
        cell[3 + k] += THREE.DataUtils.fromHalfFloat(data[4 * (row * width + column) + k]) * solid;
      }
    }
  }
  for (const cell of cells) {
    const length = Math.hypot(cell[0], cell[1], cell[2]) || 1;
    for (let k = 0; k < 3; k++) cell[k] /= length;
  }
  return cells;
}

// Six faces of 16 x 16 texels, 3 x 2, whose outermost texels lie beyond the face's edges.
function diffuseLevel(cells) {
  const texels = new Uint16Array(4 * 48 * 32).fill(THREE.DataUtils.toHalfFloat(1));
  for (let face = 0; face < 6; face++) {
    const light = (i, j) => lightOver(towardTexel(face, i, j), cells);
    const grid = Array.from({ length: 18 }, (_, j) => Array.from({ length: 18 }, (_, i) => light(i - 1, j - 1)));
    for (let j = 1; j < 17; j++) for (let i = 1; i < 17; i++) for (let k = 0; k < 3; k++) {
      const bend = grid[j][i - 1][k] + grid[j][i + 1][k] + grid[j - 1][i][k] + grid[j + 1][i][k] - 4 * grid[j][i][k];
      const row = j - 1 + 16 * Math.floor(face / 3), column = i - 1 + 16 * (face % 3);   // half of what blending adds
      texels[4 * (48 * row + column) + k] = THREE.DataUtils.toHalfFloat(Math.max(grid[j][i][k] - bend / 16, 0));
    }
  }
  return texels;
}

function towardTexel(face, i, j) {
  const u = (i - 0.5) / 7 - 1, v = (j - 0.5) / 7 - 1;
  const toward = [[1, v, u], [-u, 1, -v], [-u, v, 1], [-1, v, -u], [-u, -1, v], [u, v, -1]][face];
  return new THREE.Vector3(...toward).normalize();
}

// Irradiance over pi on a surface with this normal, RGB.
function lightOver(normal, cells) {
  const light = [0, 0, 0];
  for (const [x, y, z, r, g, b] of cells) {
    const cosine = (normal.x * x + normal.y * y + normal.z * z) / Math.PI;
    if (cosine > 0) { light[0] += cosine * r; light[1] += cosine * g; light[2] += cosine * b; }
  }
  return light;
}
"""
"""JavaScript; `THREE` is imported before it."""
