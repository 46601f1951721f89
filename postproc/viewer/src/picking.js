// Which node is meant by a place on the screen.
import { Matrix4, Raycaster, Vector2, Vector3 } from 'three';

const NEAR_MISS = { mouse: 12, touch: 26 }; // pixels beside the cloth that still count for a node of it

/**
 * @param {{x: number, y: number, width: number, height: number, touch: boolean}} at pixels from the upper left of the canvas
 * @returns {number | null} the node of the quad under the pixel that is nearest to it on the screen; null where a body or nothing is
 */
export function pick(at, camera, cloth, bodies) {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((2 * at.x) / at.width - 1, 1 - (2 * at.y) / at.height), camera);
  const { origin, direction } = ray.ray;
  const hit = quadHit(cloth, origin, direction);
  const wall = Math.min(...bodies.map((body) => bodyHit(body, origin, direction)), Infinity);
  const slack = 0.01 * origin.distanceTo(new Vector3().fromArray(cloth.position));
  if (hit !== null && hit.distance > wall + slack) return null;
  const nodes = hit === null ? cloth.position.length / 3 : 4;
  let best = null;
  let nearest = hit === null ? NEAR_MISS[at.touch ? 'touch' : 'mouse'] : Infinity;
  for (let k = 0; k < nodes; k += 1) {
    const node = hit === null ? k : cloth.quads[hit.quad + k];
    const place = toScreen(cloth.position, node, camera, at.width, at.height);
    const distance = Math.hypot(place.x - at.x, place.y - at.y);
    if (distance < nearest) [nearest, best] = [distance, node];
  }
  return best;
}

/** Pixels from the upper left of the canvas. */
export function toScreen(position, node, camera, width, height) {
  const point = new Vector3().fromArray(position, 3 * node).project(camera);
  return { x: ((point.x + 1) / 2) * width, y: ((1 - point.y) / 2) * height, front: point.z < 1 };
}

function quadHit(cloth, origin, direction) {
  const { quads, position } = cloth;
  let found = null;
  for (let q = 0; q < quads.length; q += 4) {
    for (const [second, third] of [[1, 2], [2, 3]]) {
      const distance = triangleHit(position, quads[q], quads[q + second], quads[q + third], origin, direction);
      if (distance < (found?.distance ?? Infinity)) found = { quad: q, distance };
    }
  }
  return found;
}

function bodyHit(body, origin, direction) {
  const inverse = new Matrix4().copy(body.mesh.matrix).invert();
  const start = origin.clone().applyMatrix4(inverse);
  const along = direction.clone().transformDirection(inverse);
  let distance = Infinity;
  const { triangles, points } = body;
  for (let k = 0; k < triangles.length; k += 3) {
    distance = Math.min(distance, triangleHit(points, triangles[k], triangles[k + 1], triangles[k + 2], start, along));
  }
  return distance;
}

/** Distance along a ray to a triangle, Infinity where it passes by: by the volumes of the tetrahedra of ray and sides. */
function triangleHit(p, a, b, c, origin, direction) {
  const ax = p[3 * a] - origin.x;
  const ay = p[3 * a + 1] - origin.y;
  const az = p[3 * a + 2] - origin.z;
  const bx = p[3 * b] - origin.x;
  const by = p[3 * b + 1] - origin.y;
  const bz = p[3 * b + 2] - origin.z;
  const cx = p[3 * c] - origin.x;
  const cy = p[3 * c + 1] - origin.y;
  const cz = p[3 * c + 2] - origin.z;
  const { x, y, z } = direction;
  const ab = x * (ay * bz - az * by) + y * (az * bx - ax * bz) + z * (ax * by - ay * bx);
  const bc = x * (by * cz - bz * cy) + y * (bz * cx - bx * cz) + z * (bx * cy - by * cx);
  const ca = x * (cy * az - cz * ay) + y * (cz * ax - cx * az) + z * (cx * ay - cy * ax);
  if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0))) return Infinity;
  const sum = ab + bc + ca;
  if (sum === 0) return Infinity;
  const distance = (x * (bc * ax + ca * bx + ab * cx) + y * (bc * ay + ca * by + ab * cy) + z * (bc * az + ca * bz + ab * cz)) / sum;
  return distance > 0 ? distance : Infinity;
}
