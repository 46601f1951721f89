// Materials: the light and the tones of the pictures that the package draws, worked out in the colours of the screen.
import { DataTexture, DoubleSide, FrontSide, LineBasicMaterial, LinearFilter, RedFormat, RGBAFormat, ShaderMaterial } from 'three';

// A key light from the upper left, a warm fill from the right, a weak one from behind; all move with the camera.
const LIGHT = /* glsl */ `
  vec3 lit(vec3 n) {
    const vec3 key = normalize(vec3(-0.7, 1.2, 1.1));
    const vec3 fill = normalize(vec3(1.2, 0.1, 1.0));
    const vec3 rim = normalize(vec3(0.2, 0.9, -1.0));
    return vec3(0.32)
      + 0.73 * (0.80 * max(dot(n, key), 0.0) * vec3(1.0, 0.99, 0.97)
      + 0.42 * max(dot(n, fill), 0.0) * vec3(1.0, 0.96, 0.92)
      + 0.22 * max(dot(n, rim), 0.0));
  }
`;

/** Linen with its weave, or a field's colours. */
export function clothMaterial(colours, hasThreads) {
  return new ShaderMaterial({
    side: DoubleSide,
    polygonOffset: true, // behind its own hem
    polygonOffsetUnits: 4,
    uniforms: {
      colours: { value: colourTexture(colours) },
      coloured: { value: 0 },
      threads: { value: hasThreads ? 1 : 0 },
    },
    vertexShader: /* glsl */ `
      attribute vec2 thread;
      attribute float value;
      varying vec3 vNormal;
      varying vec2 vThread;
      varying float vValue;
      void main() {
        vNormal = normalMatrix * normalize(normal + vec3(0.0, 0.0, 1e-30));
        vThread = thread;
        vValue = value;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }
    `,
    fragmentShader: /* glsl */ `
      uniform sampler2D colours;
      uniform float coloured;
      uniform float threads;
      varying vec3 vNormal;
      varying vec2 vThread;
      varying float vValue;
      ${LIGHT}
      const float LINE = 0.011; // half the width of a marking line, over their spacing
      const float WEAVE = 16.0; // threads between two lines
      float line(float at, float pixel) {
        float away = abs(fract(at + 0.5) - 0.5);
        float width = max(LINE, 0.6 * pixel);
        return min(1.0, LINE / width + 0.25) * (1.0 - smoothstep(width - 0.5 * pixel, width + 0.5 * pixel, away));
      }
      void main() {
        vec3 n = normalize(vNormal);
        if (!gl_FrontFacing) n = -n;
        vec3 light = lit(n);
        vec2 pixel = fwidth(vThread);
        float lines = threads * max(line(vThread.x, pixel.x), line(vThread.y, pixel.y));
        vec2 phase = sin(3.14159265 * WEAVE * vThread);
        float hump = phase.x * phase.y > 0.0 ? abs(phase.x) : abs(phase.y);
        float near = clamp(1.6 - 3.2 * WEAVE * max(pixel.x, pixel.y), 0.0, 1.0);
        float weave = 1.0 - threads * 0.10 * mix(0.36, 1.0 - sqrt(hump), near);
        vec3 linen = gl_FrontFacing ? vec3(0.985, 0.955, 0.895) : vec3(0.86, 0.76, 0.62);
        vec3 cloth = linen * light * weave * (1.0 - 0.24 * lines);
        vec3 field = texture2D(colours, vec2((255.0 * vValue + 0.5) / 256.0, 0.5)).rgb;
        field *= (0.45 + 0.55 * light) * (1.0 - 0.12 * lines) * (gl_FrontFacing ? 1.0 : 0.86);
        gl_FragColor = vec4(mix(cloth, field, coloured), 1.0);
      }
    `,
  });
}

/** Slate bodies. `back`: how much farther [m] they count than they are, so that cloth between two nodes is not cut by their edges. */
export function bodyMaterial(back) {
  return new ShaderMaterial({
    side: DoubleSide,
    uniforms: { back: { value: back } },
    vertexShader: /* glsl */ `
      uniform float back;
      varying vec3 vNormal;
      varying vec3 vPlace;
      void main() {
        vNormal = normalMatrix * normal;
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        vPlace = place.xyz;
        gl_Position = projectionMatrix * place;
        vec4 farther = projectionMatrix * vec4(place.xy, place.z - back, 1.0);
        gl_Position.z = farther.z / farther.w * gl_Position.w;
      }
    `,
    fragmentShader: /* glsl */ `
      varying vec3 vNormal;
      varying vec3 vPlace;
      ${LIGHT}
      void main() {
        vec3 n = normalize(vNormal);
        if (!gl_FrontFacing) n = -n;
        vec3 halfway = normalize(normalize(vec3(-0.7, 1.2, 1.1)) - normalize(vPlace));
        float shine = 0.10 * pow(max(dot(n, halfway), 0.0), 30.0);
        gl_FragColor = vec4(vec3(0.56, 0.61, 0.66) * lit(n) + shine, 1.0);
      }
    `,
  });
}

/**
 * A patch of a plane that fades out, with the shadow on it.
 * @param {DataTexture | null} shadow darkness over the middle part of the patch
 * @param {number} share of the patch's side that the shadow covers
 * @param {number} opacity of the patch; 0 draws the shadow alone
 */
export function patchMaterial(shadow, share, opacity) {
  return new ShaderMaterial({
    side: opacity > 0 && !shadow ? DoubleSide : FrontSide,
    transparent: true,
    depthWrite: false,
    uniforms: { shadow: { value: shadow ?? dark(1, new Uint8Array(1)) }, share: { value: share }, opacity: { value: opacity } },
    vertexShader: /* glsl */ `
      varying vec2 vPlace;
      void main() {
        vPlace = 2.0 * uv - 1.0;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }
    `,
    fragmentShader: /* glsl */ `
      uniform sampler2D shadow;
      uniform float share;
      uniform float opacity;
      varying vec2 vPlace;
      void main() {
        float fade = opacity * smoothstep(0.0, 1.0, (1.0 - length(vPlace)) / 0.7);
        vec2 at = 0.5 + 0.5 * vPlace / share;
        float inside = step(0.0, at.x) * step(at.x, 1.0) * step(0.0, at.y) * step(at.y, 1.0);
        float dark = inside * texture2D(shadow, at).r;
        float alpha = dark + fade * (1.0 - dark);
        float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
        alpha += step(1e-3, alpha) * (grain - 0.5) / 160.0; // or the fading shows as rings of equal bytes
        vec3 colour = mix(vec3(0.87, 0.875, 0.88), vec3(0.20, 0.22, 0.26), dark / max(alpha, 1e-4));
        gl_FragColor = vec4(colour, alpha);
      }
    `,
  });
}

export const hemMaterial = () => new LineBasicMaterial({ color: 0x73614a, toneMapped: false });

/** Darkness, one byte a cell. */
export function dark(side, bytes) {
  const texture = new DataTexture(bytes, side, side, RedFormat);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

/** The 256 colours as bytes r, g, b. @param {string} hexadecimal */
export const colourBytes = (hexadecimal) => Uint8Array.from(hexadecimal.match(/../g), (pair) => parseInt(pair, 16));

function colourTexture(hexadecimal) {
  const rgb = colourBytes(hexadecimal);
  const rgba = new Uint8Array(1024).fill(255);
  for (let k = 0; k < 256; k += 1) rgba.set(rgb.subarray(3 * k, 3 * k + 3), 4 * k);
  const texture = new DataTexture(rgba, 256, 1, RGBAFormat);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
