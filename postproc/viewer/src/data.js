// What the page was given: the description and the packed arrays (their twin is sundrape_postproc/coding.py).

/** The description that Python wrote: see `describe` in sundrape_postproc/view.py. */
export const readAbout = () => JSON.parse(document.getElementById('about').textContent);

/** @returns {Promise<Uint8Array>} the bytes of a block, whose text is dropped from the page */
async function bytesOf(name) {
  const element = document.getElementById(name);
  const packed = fromBase64(element.textContent);
  element.remove();
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let k = 0; k < bytes.length; k += 1) bytes[k] = characters.charCodeAt(k);
  return bytes;
}

export const has = (name) => document.getElementById(name) !== null;
export const floats = async (name) => new Float32Array((await bytesOf(name)).buffer);
export const indices = async (name) => new Uint32Array((await bytesOf(name)).buffer);

/**
 * Codes of a series of frames of `rows` rows of `nodes` nodes, whose blocks hold the difference in time of the difference from
 * node to node, sign folded into the lowest bit.
 * @returns {Promise<Uint16Array>} frames × rows × nodes
 */
export async function series16(name, frames, rows, nodes) {
  const bytes = await bytesOf(name);
  const count = frames * rows * nodes;
  const codes = new Uint16Array(count);
  const before = rows * nodes;
  for (let start = 0; start < count; start += nodes) {
    let change = 0;
    for (let k = start; k < start + nodes; k += 1) {
      const folded = bytes[k] | (bytes[count + k] << 8);
      change += (folded >>> 1) ^ -(folded & 1);
      codes[k] = start < before ? change : codes[k - before] + change;
    }
  }
  return codes;
}

/** The same of one row of bytes. @returns {Promise<Uint8Array>} frames × nodes */
export async function series8(name, frames, nodes) {
  const bytes = await bytesOf(name);
  const codes = new Uint8Array(frames * nodes);
  for (let start = 0; start < codes.length; start += nodes) {
    let change = 0;
    for (let k = start; k < start + nodes; k += 1) {
      change += (bytes[k] >>> 1) ^ -(bytes[k] & 1);
      codes[k] = start === 0 ? change : codes[k - nodes] + change;
    }
  }
  return codes;
}
