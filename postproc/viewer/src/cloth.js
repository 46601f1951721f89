// The cloth: positions between two frames, normals and colours, in buffers that are filled anew for every picture.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

export class Cloth {
  /**
   * @param {object} about the description
   * @param {Uint16Array} codes positions, frames × 3 × nodes
   * @param {Uint32Array} quads four nodes each
   * @param {Float32Array | null} threads warp and weft coordinate of each node over the spacing of the lines
   */
  constructor(about, codes, quads, threads) {
    this.about = about;
    this.codes = codes;
    this.quads = quads;
    this.nodes = about.nodes;
    this.position = new Float32Array(3 * this.nodes); // [m]
    this.normal = new Float32Array(3 * this.nodes); // of any length
    this.value = new Float32Array(this.nodes); // of the field, 0 to 1 over the range of its colours

    this.surface = new BufferGeometry();
    this.buffers = { position: [this.position, 3], normal: [this.normal, 3], value: [this.value, 1] };
    for (const [name, [array, size]] of Object.entries(this.buffers)) {
      const attribute = new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
      this.surface.setAttribute(name, attribute);
    }
    this.surface.setAttribute('thread', new BufferAttribute(threads ?? new Float32Array(2 * this.nodes), 2));
    this.surface.setIndex(new BufferAttribute(triangles(quads), 1));
    this.hem = new BufferGeometry();
    this.hem.setAttribute('position', this.surface.getAttribute('position'));
    this.hem.setIndex(new BufferAttribute(hemOf(quads, this.nodes), 1));
  }

  /** Positions between a frame and the next one into `this.position`. */
  place(frame, fraction) {
    const { nodes, codes, position } = this;
    const { low, quantum } = this.about;
    const next = fraction > 0 ? 3 * nodes : 0;
    for (let axis = 0; axis < 3; axis += 1) {
      let from = (3 * frame + axis) * nodes;
      const origin = low[axis];
      for (let k = axis; k < 3 * nodes; k += 3, from += 1) {
        const code = codes[from];
        position[k] = origin + quantum * (code + fraction * (codes[from + next] - code));
      }
    }
    this.touch('position');
  }

  /** Normals of the nodes from `this.position`: sums over the quads, weighted by area; the shader makes them units. */
  turn() {
    const { quads, position: p, normal: n } = this;
    n.fill(0);
    for (let q = 0; q < quads.length; q += 4) {
      const a = 3 * quads[q];
      const b = 3 * quads[q + 1];
      const c = 3 * quads[q + 2];
      const d = 3 * quads[q + 3];
      const ux = p[c] - p[a];
      const uy = p[c + 1] - p[a + 1];
      const uz = p[c + 2] - p[a + 2];
      const vx = p[d] - p[b];
      const vy = p[d + 1] - p[b + 1];
      const vz = p[d + 2] - p[b + 2];
      const x = uy * vz - uz * vy;
      const y = uz * vx - ux * vz;
      const z = ux * vy - uy * vx;
      n[a] += x; n[a + 1] += y; n[a + 2] += z;
      n[b] += x; n[b + 1] += y; n[b + 2] += z;
      n[c] += x; n[c + 1] += y; n[c + 2] += z;
      n[d] += x; n[d + 1] += y; n[d + 2] += z;
    }
    this.touch('normal');
  }

  /** Values of a field between a frame and the next one into `this.value`. @param {Uint8Array} field frames × nodes */
  paint(field, frame, fraction) {
    const { nodes, value } = this;
    const next = fraction > 0 ? nodes : 0;
    for (let k = 0, from = frame * nodes; k < nodes; k += 1, from += 1) {
      const code = field[from];
      value[k] = (code + fraction * (field[from + next] - code)) / 255;
    }
    this.touch('value');
  }

  touch(name) { this.surface.getAttribute(name).needsUpdate = true; }

  /** Position of one node at a stored frame [m]. */
  at(frame, node) {
    const { low, quantum } = this.about;
    return [0, 1, 2].map((axis) => low[axis] + quantum * this.codes[(3 * frame + axis) * this.nodes + node]);
  }
}

function triangles(quads) {
  const corners = new Uint32Array((quads.length / 4) * 6);
  for (let q = 0, k = 0; q < quads.length; q += 4, k += 6) {
    corners.set([quads[q], quads[q + 1], quads[q + 2], quads[q], quads[q + 2], quads[q + 3]], k);
  }
  return corners;
}

/** The sides that only one quad has. */
function hemOf(quads, nodes) {
  const sides = new Map();
  for (let q = 0; q < quads.length; q += 4) {
    for (let k = 0; k < 4; k += 1) {
      const a = quads[q + k];
      const b = quads[q + ((k + 1) % 4)];
      const key = Math.min(a, b) * nodes + Math.max(a, b);
      if (sides.has(key)) sides.delete(key);
      else sides.set(key, [a, b]);
    }
  }
  return new Uint32Array([...sides.values()].flat());
}
