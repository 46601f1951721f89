// Where the scene is seen from: a long lens, three quarters round, slightly above, as in the pictures.
import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const AZIMUTH = (-58 * Math.PI) / 180; // from the x axis
const ELEVATION = (24 * Math.PI) / 180;
const LENS = 20; // vertical opening [degrees]
const MARGIN = 1.08;

export class Eye {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Float32Array} points that the first view has in it [m]
   * @param {() => void} changed called when the view has changed
   */
  constructor(canvas, points, changed) {
    this.points = points;
    this.camera = new PerspectiveCamera(LENS, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', changed);
    this.controls.addEventListener('start', () => { this.untouched = false; });
    this.untouched = true; // the view follows the size of the window until somebody turns it
    this.changed = changed;
  }

  /** @param {number} aspect width over height */
  resize(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    if (this.untouched) this.reset();
  }

  reset() {
    this.untouched = true;
    this.controls.enableDamping = false; // or the swing of the last turn would go on
    this.controls.update();
    const { eye, target, radius } = fit(this.points, this.camera.aspect);
    const distance = eye.distanceTo(target);
    this.radius = radius;
    this.controls.minDistance = 0.05 * distance;
    this.controls.maxDistance = 6 * distance;
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
    this.controls.enableDamping = true;
    this.changed();
  }

  /** Once a picture: moves on what still swings out, and keeps the depths apart. */
  update() {
    this.controls.update();
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance - 6 * this.radius, 0.02 * distance);
    this.camera.far = distance + 12 * this.radius;
    this.camera.updateProjectionMatrix();
  }

  /** Turns by angles [rad] about the target, or comes nearer by a factor. */
  turn(across, up, nearer = 1) {
    this.untouched = false;
    const away = new Vector3().subVectors(this.camera.position, this.controls.target);
    const flat = new Vector3(away.x, away.z, -away.y); // three's spherical coordinates have y up
    const angles = new Spherical().setFromVector3(flat);
    angles.theta += across;
    angles.phi = Math.min(Math.PI - 0.01, Math.max(0.01, angles.phi + up));
    angles.radius = Math.min(this.controls.maxDistance, Math.max(this.controls.minDistance, angles.radius * nearer));
    flat.setFromSpherical(angles);
    this.camera.position.copy(this.controls.target).add(new Vector3(flat.x, -flat.z, flat.y));
    this.changed();
  }
}

/** The eye and the target from which all points are in the picture. */
export function fit(points, aspect) {
  const back = new Vector3(Math.cos(ELEVATION) * Math.cos(AZIMUTH), Math.cos(ELEVATION) * Math.sin(AZIMUTH), Math.sin(ELEVATION));
  const right = new Vector3(0, 0, 1).cross(back).normalize();
  const up = new Vector3().crossVectors(back, right);
  const tangent = Math.tan((LENS * Math.PI) / 360) / MARGIN;
  const target = centreOf(points);
  const point = new Vector3();
  let distance = 0;
  for (let round = 0; round < 4; round += 1) { // centre what is seen, then step back until all is in; settles at once
    const local = [];
    distance = 0;
    for (let k = 0; k < points.length; k += 3) {
      point.fromArray(points, k).sub(target);
      const [x, y, z] = [point.dot(right), point.dot(up), point.dot(back)];
      local.push({ x, y, z });
      distance = Math.max(distance, Math.abs(x) / (tangent * aspect) + z, Math.abs(y) / tangent + z);
    }
    for (const [name, axis] of [['x', right], ['y', up]]) {
      const seen = local.map((at) => (at[name] / (distance - at.z)) * distance);
      target.addScaledVector(axis, (Math.min(...seen) + Math.max(...seen)) / 2);
    }
  }
  distance = Math.max(distance, 1e-6);
  return { eye: target.clone().addScaledVector(back, distance), target, radius: radiusAbout(points, target) };
}

export function centreOf(points) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const point = new Vector3();
  for (let k = 0; k < points.length; k += 3) {
    point.fromArray(points, k);
    low.min(point);
    high.max(point);
  }
  return low.add(high).multiplyScalar(0.5);
}

export function radiusAbout(points, centre) {
  const point = new Vector3();
  let square = 1e-12;
  for (let k = 0; k < points.length; k += 3) square = Math.max(square, point.fromArray(points, k).distanceToSquared(centre));
  return Math.sqrt(square);
}
