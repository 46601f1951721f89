// What the result is: the title line, what went wrong, and the panel with everything else.
import { byId, make } from './dom.js';
import { digits, scaleFor } from './units.js';

const STATUS = { done: 'done', failed: 'failed', interrupted: 'interrupted', running: 'still running, or killed' };

export function showHeading(about) {
  byId('title').textContent = about.title;
  byId('summary').textContent = `${about.model} model · ${about.analysis} · ${STATUS[about.status] ?? about.status}`;
  const trouble = byId('trouble');
  if (about.status === 'failed') trouble.textContent = `The run failed: ${about.message || 'the file does not say why'}`;
  if (about.status === 'interrupted') trouble.textContent = about.message || 'The run was interrupted.';
  trouble.classList.toggle('mild', about.status === 'interrupted');
  trouble.hidden = trouble.textContent === '';
  const { length } = about.warnings;
  byId('info-button').textContent = length === 0 ? 'Info' : `Info · ${length} warning${length > 1 ? 's' : ''}`;
}

export function buildInfo(about) {
  const rows = [
    ['file', about.file],
    ...about.facts,
    ['frames', about.frames === about.framesInFile ? String(about.frames) : `${about.frames} of ${about.framesInFile} in the file`],
    ['positions', `16 bits an axis, to ${quantity(about.quantum / 2, 'm')}`],
    ...about.fields.map((f) => [f.label, `8 bits; largest ${quantity(f.largest, f.unit)}`]),
  ];
  const warnings = make('details', { open: true },
    make('summary', {}, `Warnings of the run (${about.warnings.length})`),
    make('ul', {}, ...about.warnings.map((text) => make('li', {}, text))));
  byId('info').replaceChildren(
    make('h2', {}, 'This result'),
    make('table', {}, make('tbody', {}, ...rows.map(([name, value]) => row(name, value)))),
    ...(about.warnings.length > 0 ? [warnings] : []),
    make('h2', {}, 'What is drawn'),
    make('p', {}, 'The mesh of the run. While it plays, the cloth between two frames is drawn in a line between them; '
      + 'when it stands, it is a frame of the file. '
      + 'Bodies are drawn a little farther back than they are, so that cloth between two nodes is not cut by their edges.'),
    make('h2', {}, 'Keys'),
    make('table', {}, make('tbody', {}, ...[
      ['space', 'play or pause'],
      ['← →', 'one frame back or on (on the cloth: turn)'],
      ['home, end', 'first, last frame'],
      ['↑ ↓ + −', 'on the cloth: turn, zoom'],
      ['C', 'next colour'],
      ['L', 'loop'],
      ['R', 'reset the view'],
      ['esc', 'forget the picked node, close this'],
    ].map(([name, value]) => row(name, value)))),
  );
}

export const row = (name, value) => make('tr', {}, make('th', { scope: 'row' }, name), make('td', {}, value));

function quantity(value, unit) {
  const scale = scaleFor(Math.abs(value), unit);
  return `${digits(value * scale.factor)} ${scale.unit}`;
}
