// Puts the parts together: reads the page's data, draws when something has changed, listens to the user.
import { LineSegments, Mesh, Scene, WebGLRenderer } from 'three';
import { Cloth } from './cloth.js';
import { Controls } from './controls.js';
import { Eye, centreOf, fit, radiusAbout } from './camera.js';
import { floats, has, indices, readAbout, series16, series8 } from './data.js';
import { buildInfo, showHeading } from './info.js';
import { byId } from './dom.js';
import { clothMaterial, hemMaterial } from './look.js';
import { Ground, readBodies } from './obstacles.js';
import { Pace } from './pace.js';
import { Picked } from './picked.js';
import { Plots } from './plots.js';
import { showLegend } from './legend.js';
import { Timeline } from './timeline.js';
import { hook } from './hook.js';
import { shownPoints, lowestOf, meanSide } from './extent.js';

class Viewer {
  constructor(about) {
    this.about = about;
    this.timeline = new Timeline(about.axis.values, about.axis.perSecond);
    this.field = null; // of the description; null is the weave
    this.fieldCodes = new Map(); // by name, read when first shown
    this.stale = true; // the cloth is not that of the timeline
    this.dirty = true; // the picture is not that of the cloth and the camera
    this.pace = new Pace();
  }

  async start() {
    const { about } = this;
    const codes = await series16('positions', about.frames, 3, about.nodes);
    const quads = await indices('quads');
    const threads = has('threads') ? await floats('threads') : null;
    this.cloth = new Cloth(about, codes, quads, threads);
    this.cloth.place(0, 0);
    this.bodies = await readBodies(about);
    this.compose(threads !== null);
    this.resize();
    this.draw();
    byId('waiting').hidden = true;
    this.noteFirstFrame();
    this.plots = new Plots(about, (x) => {
      this.timeline.set(x);
      this.timeline.setFrame(this.timeline.nearest);
      this.moved();
    });
    this.picked = new Picked(this);
    this.controls = new Controls(this);
    await this.plots.read();
    buildInfo(about);
    this.moved();
    new ResizeObserver(() => this.resize()).observe(byId('stage'));
    requestAnimationFrame((now) => {
      this.before = now;
      this.tick(now);
    });
  }

  /** When the first picture was there: the graphics have finished it and the browser asks for the next one. */
  noteFirstFrame() {
    this.renderer.getContext().finish();
    requestAnimationFrame(() => {
      this.firstFrame = performance.now();
      performance.mark('sundrape: first frame');
    });
  }

  compose(hasThreads) {
    const { about, cloth, bodies } = this;
    const canvas = byId('canvas');
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: 'high-performance' });
    this.renderer.setClearColor(0, 0);
    const points = shownPoints(about, cloth, bodies);
    const centre = centreOf(points);
    const radius = radiusAbout(points, centre);
    this.scene = new Scene();
    this.material = clothMaterial(about.colours, hasThreads);
    this.ground = new Ground(about, lowestOf(about, bodies), { centre, radius });
    const back = Math.min(0.5 * meanSide(cloth), 0.03 * radius);
    for (const body of bodies) body.dress(back);
    const things = [
      ...this.ground.patches,
      ...bodies.map((body) => body.mesh),
      new Mesh(cloth.surface, this.material),
      new LineSegments(cloth.hem, hemMaterial()),
    ];
    for (const thing of things) thing.frustumCulled = false; // their extents change with every frame
    this.scene.add(...things);
    this.eye = new Eye(canvas, points, () => { this.dirty = true; });
    this.eye.radius = fit(points, 1).radius;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = byId('stage');
    if (width === 0 || height === 0) return;
    this.size = { width, height };
    this.renderer.setPixelRatio(this.pace.share * Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.eye.resize(width / height);
    if (this.controls) this.draw(); // a canvas that changes its size is blank until it is drawn
  }

  /** The timeline has moved. */
  moved() {
    this.stale = true;
    this.controls.show();
  }

  tick(now) {
    const seconds = Math.min((now - this.before) / 1000, 1);
    this.before = now;
    if (this.pace.note(seconds, this.timeline.playing)) this.resize();
    if (this.timeline.playing) {
      this.timeline.advance(seconds);
      this.moved();
    }
    this.eye.update();
    if (this.stale || this.dirty) this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  draw() {
    if (this.stale) this.shape();
    this.eye.update();
    this.renderer.render(this.scene, this.eye.camera);
    this.picked?.follow();
    this.dirty = false;
  }

  /** Brings everything that depends on the timeline up to date, but for the picture. */
  shape() {
    const { frame, fraction } = this.timeline.place;
    this.cloth.place(frame, fraction);
    this.cloth.turn();
    if (this.field !== null) this.cloth.paint(this.fieldCodes.get(this.field.name), frame, fraction);
    for (const body of this.bodies) body.place(frame, fraction);
    this.ground.shade(this.cloth, this.bodies);
    this.stale = false;
    this.plots?.mark(this.timeline.now);
    this.picked?.tell();
  }

  /** @param {string} name of a field; "" is the weave */
  async colour(name) {
    const field = this.about.fields.find((f) => f.name === name) ?? null;
    if (field !== null && !this.fieldCodes.has(name)) {
      this.fieldCodes.set(name, await series8(`field-${name}`, this.about.frames, this.about.nodes));
    }
    this.field = field;
    this.material.uniforms.coloured.value = field === null ? 0 : 1;
    showLegend(field, this.about.colours);
    this.moved();
  }
}

async function run() {
  const about = readAbout();
  showHeading(about);
  const viewer = new Viewer(about);
  try {
    await viewer.start();
  } catch (trouble) {
    byId('waiting').hidden = false;
    byId('waiting').textContent = `The cloth cannot be shown: ${trouble.message}. `
      + 'The page needs a browser with WebGL 2 and DecompressionStream.';
    throw trouble;
  }
  hook(viewer);
}

run();
