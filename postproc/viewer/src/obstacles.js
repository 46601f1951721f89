// The rigid bodies of the scene, and patches of its planes. Those that move have a place for every frame.
import { BufferAttribute, BufferGeometry, Matrix4, Mesh, PlaneGeometry, Quaternion, Vector3 } from 'three';
import { floats, has, indices } from './data.js';
import { bodyMaterial, dark, patchMaterial } from './look.js';
import { Shadow } from './shadow.js';

const PATCH = 4; // half side of the floor, over the radius of what is shown
const SHADE = 1.8; // half side of the part of it that takes the shadow
const SUNK = 0.002; // of planes below themselves: cloth that lies on them is not cut

/** Reads the bounded obstacles. @returns {Promise<Body[]>} */
export async function readBodies(about) {
  const bodies = [];
  for (const obstacle of about.obstacles) {
    const { block, kind, moves } = obstacle;
    const path = moves && has(`${block}-path`) ? await floats(`${block}-path`) : null;
    if (kind === 'plane') continue;
    const [points, normals, triangles] = [
      await floats(`${block}-points`),
      await floats(`${block}-normals`),
      await indices(`${block}-triangles`),
    ];
    bodies.push(new Body(obstacle, points, normals, triangles, path));
  }
  return bodies;
}

export class Body {
  constructor(obstacle, points, normals, triangles, path) {
    this.name = obstacle.name;
    this.points = points; // [m], in its own frame
    this.triangles = triangles;
    this.path = path; // 12 numbers a frame: position, rotation by rows
    this.mesh = new Mesh(new BufferGeometry());
    this.mesh.geometry.setAttribute('position', new BufferAttribute(points, 3));
    this.mesh.geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    this.mesh.geometry.setIndex(new BufferAttribute(triangles, 1));
    this.mesh.matrixAutoUpdate = false;
    this.standing = path === null ? placeOf([...obstacle.position, ...obstacle.rotation], 0) : null;
    this.place(0, 0);
  }

  /** Between a frame and the next one: positions in a line, turns on the shortest way. */
  place(frame, fraction) {
    const here = this.standing ?? placeOf(this.path, 12 * frame);
    if (this.path !== null && fraction > 0) {
      const next = placeOf(this.path, 12 * (frame + 1));
      here.position.lerp(next.position, fraction);
      here.turn.slerp(next.turn, fraction);
    }
    this.mesh.matrix.compose(here.position, here.turn, new Vector3(1, 1, 1));
    this.mesh.matrixWorldNeedsUpdate = true;
  }

  /** Calls back with every point in space, where it stands now [m]. */
  eachPoint(visit) {
    const m = this.mesh.matrix.elements;
    const p = this.points;
    for (let k = 0; k < p.length; k += 3) {
      const [x, y, z] = [p[k], p[k + 1], p[k + 2]];
      visit(m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13], m[2] * x + m[6] * y + m[10] * z + m[14]);
    }
  }

  dress(back) { this.mesh.material = bodyMaterial(back); }
}

function placeOf(numbers, at) {
  const n = numbers.slice(at, at + 12);
  const m = new Matrix4().set(n[3], n[4], n[5], 0, n[6], n[7], n[8], 0, n[9], n[10], n[11], 0, 0, 0, 0, 1);
  return { position: new Vector3(n[0], n[1], n[2]), turn: new Quaternion().setFromRotationMatrix(m) };
}

/** Points and normals of the planes in space [m]. */
function planesOf(about) {
  return about.obstacles.filter((o) => o.kind === 'plane').map((o) => {
    const { position, turn } = placeOf([...o.position, ...o.rotation], 0);
    return {
      point: new Vector3(...o.point).applyQuaternion(turn).add(position),
      normal: new Vector3(...o.normal).applyQuaternion(turn),
    };
  });
}

/** What the scene stands on: the highest floor, or a shadow alone below all; the other planes as patches. */
export class Ground {
  /**
   * @param {object} about the description
   * @param {number} lowest height of cloth and bodies in all frames [m]
   * @param {{centre: Vector3, radius: number}} extent of what is shown
   */
  constructor(about, lowest, extent) {
    const { centre, radius } = extent;
    const planes = planesOf(about);
    const floors = planes.filter((plane) => plane.normal.z > 0.999);
    const height = floors.length > 0 ? Math.max(...floors.map((plane) => plane.point.z)) : lowest - 0.01 * radius;
    this.shadow = new Shadow([centre.x, centre.y, height], SHADE * radius, radius);
    this.texture = dark(this.shadow.side, this.shadow.bytes);
    const half = floors.length > 0 ? PATCH : SHADE;
    const floor = new Mesh(
      new PlaneGeometry(2 * half * radius, 2 * half * radius),
      patchMaterial(this.texture, SHADE / half, floors.length > 0 ? 1 : 0),
    );
    floor.position.set(centre.x, centre.y, height - SUNK * radius);
    this.patches = [floor];
    for (const { point, normal } of planes.filter((plane) => plane.normal.z <= 0.999)) {
      const side = 0.8 * PATCH * radius;
      const patch = new Mesh(new PlaneGeometry(side, side), patchMaterial(null, 1, 0.8));
      patch.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
      const away = normal.dot(new Vector3().subVectors(centre, point));
      patch.position.copy(centre).addScaledVector(normal, -away - SUNK * radius);
      this.patches.push(patch);
    }
  }

  /** The shadow of what is there now. */
  shade(cloth, bodies) {
    this.shadow.clear();
    this.shadow.addQuads(cloth.position, cloth.quads);
    for (const body of bodies) body.eachPoint((x, y, z) => this.shadow.add(x, y, z));
    this.shadow.finish();
    this.texture.needsUpdate = true;
  }
}
