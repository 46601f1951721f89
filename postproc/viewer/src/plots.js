// The diagrams below the cloth: tabs, curves to choose from, all with one cursor.
import { byId, draw, make } from './dom.js';
import { floats } from './data.js';
import { Plot } from './plot.js';

const AXES = ['x', 'y', 'z'];

export class Plots {
  /**
   * @param {object} about the description
   * @param {(x: number) => void} chosen called with a place on the axis that was clicked
   */
  constructor(about, chosen) {
    this.about = about;
    this.chosen = chosen;
    this.plots = [];
    this.now = about.axis.values[0];
    this.hidden = new Set(); // labels of curves that are switched off
  }

  /** Reads the curves and shows the first tab. */
  async read() {
    this.tabs = [];
    const probes = [];
    for (const probe of this.about.probes) {
      const numbers = await floats(probe.block);
      const rows = numbers.length / 4;
      const columns = [0, 1, 2, 3].map((k) => numbers.subarray(k * rows, (k + 1) * rows));
      if (rows > 0) probes.push({ ...probe, columns });
    }
    if (probes.length > 0) this.tabs.push({ name: 'Probes', diagrams: probeDiagrams(probes) });
    const { values } = this.about.axis;
    const energies = this.about.diagrams
      .map((d) => ({ ...d, curves: d.curves.map((c) => ({ ...c, x: values, y: c.values })) }));
    const residual = energies.some((d) => d.logarithmic);
    if (energies.length > 0) this.tabs.push({ name: residual ? 'Energies and residual' : 'Energies', diagrams: energies });
    if (this.tabs.length === 0) {
      byId('plots').hidden = true;
      return;
    }
    this.buttons = this.tabs.map((tab, k) => {
      const button = make('button', { type: 'button', role: 'tab', id: `tab-${k}`, 'aria-controls': 'panels' }, tab.name);
      button.addEventListener('click', () => this.show(k));
      button.addEventListener('keydown', (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        const next = (k + step + this.tabs.length) % this.tabs.length;
        this.show(next);
        this.buttons[next].focus();
      });
      return button;
    });
    byId('tabs').replaceChildren(...this.buttons);
    this.show(0);
    new ResizeObserver(() => this.render()).observe(byId('panels'));
  }

  show(index) {
    this.shown = index;
    this.buttons.forEach((button, k) => {
      button.setAttribute('aria-selected', String(k === index));
      button.tabIndex = k === index ? 0 : -1;
    });
    byId('panels').setAttribute('aria-labelledby', `tab-${index}`);
    const { diagrams } = this.tabs[index];
    const curves = new Map(diagrams.flatMap((d) => d.curves.map((c) => [c.label, c])));
    byId('chips').replaceChildren(...[...curves.values()].map((curve) => this.chip(curve)));
    this.build();
  }

  /** A button that shows what a curve looks like and switches it off and on. */
  chip({ label, colour, dashes }) {
    const line = draw('svg', { viewBox: '0 0 26 8', 'aria-hidden': 'true' },
      draw('line', { x1: 0, x2: 26, y1: 4, y2: 4, stroke: colour, 'stroke-width': 2.5, 'stroke-dasharray': dashes || null }));
    const button = make('button', { type: 'button', class: 'chip', 'aria-pressed': String(!this.hidden.has(label)) }, line, label);
    button.addEventListener('click', () => {
      if (!this.hidden.delete(label)) this.hidden.add(label);
      button.setAttribute('aria-pressed', String(!this.hidden.has(label)));
      this.build();
    });
    return button;
  }

  build() {
    const { diagrams } = this.tabs[this.shown];
    this.plots = diagrams
      .map((d) => new Plot(d, d.curves.filter((c) => !this.hidden.has(c.label)), this.about.axis, this.chosen))
      .filter((plot) => plot.curves.length > 0);
    const none = make('p', {}, 'No curve is switched on.');
    byId('panels').replaceChildren(...(this.plots.length > 0 ? this.plots.map((plot) => plot.element) : [none]));
    this.render();
  }

  render() {
    for (const plot of this.plots) plot.render();
    this.mark(this.now);
  }

  mark(now) {
    this.now = now;
    for (const plot of this.plots) plot.mark(now);
  }
}

function probeDiagrams(probes) {
  const size = probes.reduce((most, { columns }) => columns.slice(1).flatMap((column) => [...column])
    .reduce((largest, value) => Math.max(largest, Math.abs(value)), most), 0);
  return AXES.map((axis, k) => ({
    title: axis,
    unit: 'm',
    size,
    curves: probes.map(({ name, colour, dashes, columns }) => ({ label: name, colour, dashes, x: columns[0], y: columns[k + 1] })),
  }));
}
