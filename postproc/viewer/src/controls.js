// The bar below the cloth, and the keys.
import { byId, make } from './dom.js';
import { decimals, digits, scaleFor } from './units.js';

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2];
const ICONS = { play: 'M7 4.5v15l12.5-7.5z', pause: 'M6.5 5h4v14h-4zM13.5 5h4v14h-4z' };
const EVERY = 80; // milliseconds between two looks of the bar while it plays
const WATCHED = 3; // seconds that a motion should last at the speed that it starts with

export class Controls {
  constructor(viewer) {
    this.viewer = viewer;
    const { about, timeline } = viewer;
    this.slider = byId('slider');
    this.slider.max = about.frames - 1;
    this.slider.addEventListener('input', () => {
      timeline.setFrame(Number(this.slider.value));
      viewer.moved();
    });
    byId('play').addEventListener('click', () => this.playOrPause());
    byId('play').disabled = about.frames < 2;
    this.fillSpeeds();
    byId('loop').addEventListener('click', () => this.setLoop(!timeline.loop));
    byId('colour').replaceChildren(
      make('option', { value: '' }, 'weave'),
      ...about.fields.map((field) => make('option', { value: field.name }, field.label)),
    );
    byId('colour').addEventListener('change', () => viewer.colour(byId('colour').value));
    byId('reset').addEventListener('click', () => viewer.eye.reset());
    byId('info-button').addEventListener('click', () => this.openInfo(byId('info').hidden));
    document.addEventListener('keydown', (event) => this.key(event));
  }

  fillSpeeds() {
    const { about, timeline } = this.viewer;
    const select = byId('speed');
    const name = (speed) => (about.axis.physical ? `${speed}× real time` : `${speed}×`);
    select.replaceChildren(...SPEEDS.map((speed) => make('option', { value: speed }, name(speed))));
    const lasts = (timeline.last - timeline.first) / timeline.perSecond;
    const fit = SPEEDS.filter((speed) => speed <= 1 && lasts / speed >= WATCHED);
    this.setSpeed(fit.length > 0 ? fit[fit.length - 1] : SPEEDS[0]);
    select.addEventListener('change', () => this.setSpeed(Number(select.value)));
  }

  setSpeed(speed) {
    this.viewer.timeline.speed = speed;
    byId('speed').value = String(speed);
  }

  setLoop(loop) {
    this.viewer.timeline.loop = loop;
    byId('loop').setAttribute('aria-pressed', String(loop));
  }

  playOrPause() {
    const { timeline } = this.viewer;
    if (timeline.playing) timeline.pause();
    else timeline.play();
    this.viewer.moved();
  }

  openInfo(open) {
    byId('info').hidden = !open;
    byId('info-button').setAttribute('aria-expanded', String(open));
  }

  /** Brings the bar up to date with the timeline; while it plays, a few times a second, as laying text out takes its time. */
  show() {
    const { timeline } = this.viewer;
    const now = performance.now();
    if (timeline.playing && this.state === 'pause' && now - this.shown < EVERY) return;
    this.shown = now;
    const text = this.clock();
    this.slider.value = String(timeline.nearest);
    this.slider.setAttribute('aria-valuetext', text);
    byId('clock').textContent = text;
    const state = timeline.playing ? 'pause' : 'play';
    if (this.state === state) return;
    this.state = state;
    byId('play-icon').setAttribute('d', ICONS[state]);
    byId('play').setAttribute('aria-label', timeline.playing ? 'Pause' : 'Play');
  }

  clock() {
    const { about, timeline } = this.viewer;
    const { axis } = about;
    const frame = timeline.nearest;
    const count = `frame ${frame} of ${about.frames - 1}`;
    if (axis.labels) return `${axis.labelName} ${digits(axis.labels[frame] ?? NaN, 4)} · ${count}`;
    if (axis.unit === '') return count;
    const scale = scaleFor(timeline.last, axis.unit);
    const step = ((timeline.last - timeline.first) / Math.max(1, about.frames - 1)) * scale.factor;
    const places = Math.min(6, Math.max(0, Math.ceil(-Math.log10(step || 1) + 0.3)));
    const name = axis.name === 'time' ? 't' : axis.name;
    return `${name} = ${decimals(timeline.now * scale.factor, places)} ${scale.unit} · ${count}`;
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { target } = event;
    if (target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && target.type === 'number')) return;
    const action = this.actions(target)[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  actions(target) {
    const { viewer } = this;
    const { timeline, eye } = viewer;
    const step = (frames) => () => {
      timeline.pause();
      timeline.setFrame(timeline.nearest + frames);
      viewer.moved();
    };
    const onButton = target instanceof HTMLButtonElement || target.tagName === 'SUMMARY';
    const general = {
      ...(onButton ? {} : { ' ': () => this.playOrPause() }), // on a button, space presses the button
      ArrowLeft: step(-1),
      ArrowRight: step(1),
      Home: step(-Infinity),
      End: step(Infinity),
      c: () => this.nextColour(),
      l: () => this.setLoop(!timeline.loop),
      r: () => eye.reset(),
      Escape: () => {
        viewer.picked.choose(null);
        this.openInfo(false);
      },
    };
    if (target !== byId('canvas')) return general;
    return {
      ...general,
      ArrowLeft: () => eye.turn(-0.1, 0),
      ArrowRight: () => eye.turn(0.1, 0),
      ArrowUp: () => eye.turn(0, -0.1),
      ArrowDown: () => eye.turn(0, 0.1),
      '+': () => eye.turn(0, 0, 0.87),
      '=': () => eye.turn(0, 0, 0.87),
      '-': () => eye.turn(0, 0, 1.15),
    };
  }

  nextColour() {
    const select = byId('colour');
    select.selectedIndex = (select.selectedIndex + 1) % select.options.length;
    this.viewer.colour(select.value);
  }
}
