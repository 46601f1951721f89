// How far the scene reaches, over all frames.

const REACH = 0.6; // how much of a body beyond the cloth is fitted into the view, over the cloth's largest side
const MANY = 30000; // points are enough to fit a view to

/** Places of the cloth in all frames and the near parts of the bodies [m], x, y, z in a row. */
export function shownPoints(about, cloth, bodies) {
  const { codes, nodes } = cloth;
  const points = [];
  const every = Math.max(1, Math.round((about.frames * nodes) / MANY));
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < about.frames * nodes; k += every) {
    const frame = Math.floor(k / nodes);
    const node = k % nodes;
    for (let axis = 0; axis < 3; axis += 1) {
      const value = about.low[axis] + about.quantum * codes[(3 * frame + axis) * nodes + node];
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
      points.push(value);
    }
  }
  const reach = REACH * Math.max(...high.map((value, axis) => value - low[axis]), 1e-9);
  const near = (value, axis) => Math.min(high[axis] + reach, Math.max(low[axis] - reach, value));
  eachPlace(about, bodies, (body, stride) => {
    let k = 0;
    body.eachPoint((x, y, z) => {
      if (k % stride === 0) points.push(near(x, 0), near(y, 1), near(z, 2));
      k += 1;
    });
  });
  return new Float32Array(points);
}

/** Lowest height of cloth and bodies in all frames [m]. */
export function lowestOf(about, cloth, bodies) {
  let lowest = about.low[2];
  eachPlace(about, bodies, (body) => body.eachPoint((x, y, z) => { lowest = Math.min(lowest, z); }));
  return lowest;
}

/** Mean length of the quads' sides at the first frame [m]. */
export function meanSide(cloth) {
  const { quads, position } = cloth;
  let sum = 0;
  for (let q = 0; q < quads.length; q += 4) {
    const [a, b] = [3 * quads[q], 3 * quads[q + 1]];
    sum += Math.hypot(position[b] - position[a], position[b + 1] - position[a + 1], position[b + 2] - position[a + 2]);
  }
  return sum / (quads.length / 4);
}

/** Bodies where they stand; those that move at some of their places. */
function eachPlace(about, bodies, visit) {
  for (const body of bodies) {
    const stride = Math.max(1, Math.floor(body.points.length / 3 / 1000));
    const stations = body.path === null ? 1 : Math.min(about.frames, 12);
    for (let k = 0; k < stations; k += 1) {
      body.place(Math.round((k * (about.frames - 1)) / Math.max(1, stations - 1)), 0);
      visit(body, stride);
    }
    body.place(0, 0);
  }
}
