// window.sundrape: what tests and scripts may ask the page and tell it. docs/viewer.md describes it.
import { byId } from './dom.js';
import { toScreen } from './picking.js';

export function hook(viewer) {
  const { timeline, controls, cloth } = viewer;
  const sync = () => { if (viewer.stale || viewer.dirty) viewer.draw(); };
  const api = {
    about: viewer.about,
    /** From the start of the navigation to the first picture on the screen [ms]. */
    get firstFrame() { return viewer.firstFrame; },
    get time() { return timeline.now; },
    get frame() { return timeline.nearest; },
    get playing() { return timeline.playing; },
    get speed() { return timeline.speed; },
    get colour() { return viewer.field?.name ?? ''; },
    get picked() { return viewer.picked.node; },
    /** Column-major 4 × 4: projection times view of the camera. */
    get camera() {
      viewer.eye.camera.updateMatrixWorld();
      return viewer.eye.camera.projectionMatrix.clone().multiply(viewer.eye.camera.matrixWorldInverse).toArray();
    },
    /** Goes to a time, between frames too. */
    setTime(time) { timeline.set(time); viewer.moved(); sync(); },
    setFrame(frame) { timeline.setFrame(frame); viewer.moved(); sync(); },
    play() { timeline.play(); viewer.moved(); },
    pause() { timeline.pause(); viewer.moved(); sync(); },
    setSpeed(speed) { controls.setSpeed(speed); },
    /** By the field's name; "" is the weave. */
    async setColour(name) { byId('colour').value = name; await viewer.colour(name); sync(); },
    pick(node) { viewer.picked.choose(node); },
    resetView() { viewer.eye.reset(); sync(); },
    /** Positions on the screen now (3 N) [m]; of the field (N), SI. */
    positions() { sync(); return Array.from(cloth.position); },
    values() {
      sync();
      const { field } = viewer;
      return field === null ? null : Array.from(cloth.value, (share) => field.low + share * (field.high - field.low));
    },
    /** What our own work takes for each of so many pictures between the first frame and the last, not counting their drawing [ms]. */
    measure(count) {
      const costs = Array.from({ length: count }, (_, k) => {
        timeline.set(timeline.first + ((k + 0.5) / count) * (timeline.last - timeline.first));
        const began = performance.now();
        viewer.shape();
        return performance.now() - began;
      });
      viewer.moved();
      return costs;
    },
    /** Where a node is in the window [pixels]. */
    project(node) {
      sync();
      const box = byId('canvas').getBoundingClientRect();
      const { x, y } = toScreen(cloth.position, node, viewer.eye.camera, box.width, box.height);
      return { x: x + box.left, y: y + box.top };
    },
  };
  window.sundrape = api;
}
