// The picked node: choosing it, its marker and its card; markers of the probes too.
import { byId, make } from './dom.js';
import { decimals } from './units.js';
import { pick, toScreen } from './picking.js';
import { row } from './info.js';
import { scaleOf } from './legend.js';

const STILL = 5; // pixels that a click may wander

export class Picked {
  constructor(viewer) {
    this.viewer = viewer;
    this.node = null;
    const { about } = viewer;
    const extent = about.quantum * 65535;
    this.unit = extent >= 1 ? { factor: 100, unit: 'cm' } : { factor: 1000, unit: 'mm' };
    this.places = Math.max(0, Math.floor(-Math.log10(about.quantum * this.unit.factor)));
    this.ring = mark('picked', '#c2255c', '');
    this.probes = about.probes.filter((p) => p.node !== null)
      .map((p) => ({ node: p.node, element: mark('probe', p.colour, p.name) }));
    byId('markers').replaceChildren(...this.probes.map((p) => p.element), this.ring);
    this.choose(null);
    this.listen();
  }

  listen() {
    const canvas = byId('canvas');
    let down = null;
    canvas.addEventListener('pointerdown', (event) => { down = event.isPrimary ? [event.clientX, event.clientY] : null; });
    canvas.addEventListener('pointerup', (event) => {
      if (down === null || event.button !== 0) return;
      if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > STILL) return;
      this.choose(this.at(event.clientX, event.clientY, event.pointerType === 'touch'));
    });
    byId('unpick').addEventListener('click', () => this.choose(null));
    byId('node').max = this.viewer.about.nodes - 1;
    byId('node').addEventListener('change', () => {
      const { value } = byId('node');
      const node = value === '' ? null : Math.round(Number(value));
      this.choose(node !== null && node >= 0 && node < this.viewer.about.nodes ? node : null);
    });
  }

  /** The node at a place of the window. */
  at(clientX, clientY, touch = false) {
    const box = byId('canvas').getBoundingClientRect();
    const at = { x: clientX - box.left, y: clientY - box.top, width: box.width, height: box.height, touch };
    return pick(at, this.viewer.eye.camera, this.viewer.cloth, this.viewer.bodies);
  }

  choose(node) {
    this.node = node;
    byId('node').value = node ?? '';
    this.tell();
    this.follow();
  }

  /** Writes the card. */
  tell() {
    byId('picked').hidden = this.node === null;
    if (this.node === null) return;
    const { cloth, about, field, timeline } = this.viewer;
    const here = [...cloth.position.subarray(3 * this.node, 3 * this.node + 3)];
    const first = cloth.at(0, this.node);
    const moved = Math.hypot(...here.map((value, axis) => value - first[axis]));
    const length = (value) => `${decimals(value * this.unit.factor, this.places)} ${this.unit.unit}`;
    const rows = [
      ['Node', String(this.node)],
      ...here.map((value, axis) => ['xyz'[axis], length(value)]),
      ['from first frame', length(moved)],
    ];
    if (field !== null) rows.push([field.label, this.fieldText(field)]);
    const probe = about.probes.find((p) => p.node === this.node);
    if (probe) rows.push(['probe', probe.name]);
    if (timeline.playing && this.rows?.length === rows.length) {
      rows.forEach(([, value], k) => { this.rows[k].lastChild.textContent = value; });
      return;
    }
    this.rows = rows.map(([name, value]) => row(name, value));
    byId('picked-rows').replaceChildren(...this.rows);
  }

  fieldText(field) {
    const share = this.viewer.cloth.value[this.node];
    const value = field.low + share * (field.high - field.low);
    const { factor, unit } = scaleOf(field);
    const sign = share >= 1 && field.cutAbove ? '≥ ' : share <= 0 && field.cutBelow ? '≤ ' : '';
    const step = ((field.high - field.low) / 255) * factor;
    const places = Math.min(8, Math.max(0, Math.ceil(-Math.log10(step))));
    return `${sign}${decimals(value * factor, places)} ${unit}`;
  }

  /** Moves the markers to where their nodes are on the screen. */
  follow() {
    const { cloth, eye, size } = this.viewer;
    const all = [...this.probes, { node: this.node, element: this.ring }];
    for (const { node, element } of all) {
      element.hidden = node === null;
      if (node === null) continue;
      const { x, y, front } = toScreen(cloth.position, node, eye.camera, size.width, size.height);
      element.hidden = !front;
      element.classList.toggle('left', x > size.width - 90); // its name stays in the picture
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }
}

function mark(kind, colour, name) {
  return make('div', { class: `mark ${kind}`, style: `--colour:${colour}` }, ...(name ? [make('span', {}, name)] : []));
}
