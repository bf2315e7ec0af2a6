// The look of cloth and mannequin: the colour is looked up per pixel by the value, and light only
// darkens it, so that colours stay true to the bar.
import { BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, GLSL3, LinearFilter,
         RGBAFormat, ShaderMaterial, UnsignedByteType, Vector3 } from "three";
import type { Case, State } from "./case_data";
import { shareOf, type Scale } from "./colour_scale";

const vertexShader = `
in float share;
in float known;
in float touch;
in float hollow;
out float vShare;
out float vKnown;
out float vTouch;
out float vHollow;
out vec3 vNormal;
void main() {
  vShare = share;
  vKnown = known;
  vTouch = touch;
  vHollow = hollow;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform sampler2D table;
uniform vec3 plain;
uniform vec3 key;
uniform float mapped, lit, ambient, opacity, contours, middle, contact;
in float vShare;
in float vKnown;
in float vTouch;
in float vHollow;
in vec3 vNormal;
out vec4 colour;
void main() {
  vec3 c = plain;
  if (mapped > 0.5) {
    float s = clamp(vShare, 0.0, 1.0);
    c = vKnown > 0.999 ? texture(table, vec2((s * 255.0 + 0.5) / 256.0, 0.5)).rgb : vec3(0.5);
    if (contours > 0.5 && vKnown > 0.999) {
      float q = vShare * contours;
      float off = abs(fract(q - 0.5) - 0.5) / max(fwidth(q), 1e-6);
      float line = 1.0 - smoothstep(0.6, 1.3, off);
      if (q < 0.5 || q > contours - 0.5) line = 0.0;
      if (middle < 0.5 && abs(q - 0.5 * contours) < 0.5) line = 0.0;
      float light = dot(c, vec3(0.3, 0.6, 0.1));
      c = mix(c, light > 0.45 ? vec3(0.08) : vec3(0.97), 0.75 * line);
    }
  }
  if (contact > 0.5 && vTouch > 0.999) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 7.0);
    c = mix(c, stripe < 1.6 ? vec3(0.02) : vec3(1.0), stripe < 1.6 ? 0.85 : 0.25);
  }
  if (lit > 0.5) {
    vec3 n = normalize(vNormal);
    if (!gl_FrontFacing) n = -n;
    float f = 0.2 + 0.62 * max(0.0, dot(n, key)) + 0.2 * max(0.0, n.z);
    f -= 0.2 * max(0.0, vHollow);
    f += 0.08 * max(0.0, -vHollow);
    c *= mix(ambient, 1.0, clamp(f, 0.0, 1.0));
    if (!gl_FrontFacing) c *= 0.82;
  }
  colour = vec4(c, opacity);
}`;

/** Greys of the stills (render/scene.cpp). */
export const kMannequin = new Color(176 / 255, 176 / 255, 176 / 255);
export const kUnder = new Color(150 / 255, 166 / 255, 200 / 255);
export const kCloth = new Color(226 / 255, 231 / 255, 238 / 255);

/** `behind`: steps that the surface is pushed back, so that lines on cloth and cloth on skin stay in front. */
export function surfaceMaterial(plain: Color, lit: boolean, behind = 1): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3, vertexShader, fragmentShader, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: behind, polygonOffsetUnits: behind,
    uniforms: {
      table: { value: null }, plain: { value: plain },
      key: { value: new Vector3(-0.38, 0.62, 0.69).normalize() },
      mapped: { value: 0 }, lit: { value: lit ? 1 : 0 }, ambient: { value: 0.5 },
      opacity: { value: 1 }, contours: { value: 0 }, middle: { value: 1 }, contact: { value: 0 },
    },
  });
}

export function setOpacity(material: ShaderMaterial, opacity: number): void {
  material.uniforms.opacity.value = opacity;
  material.transparent = opacity < 0.999;
  material.depthWrite = opacity > 0.5;
}

/** Colours of a scale as a texture of 256 texels; the display's own values, not linear light. */
export function tableTexture(table: Uint8Array): DataTexture {
  const texels = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    texels.set(table.subarray(3 * i, 3 * i + 3), 4 * i);
    texels[4 * i + 3] = 255;
  }
  const texture = new DataTexture(texels, 256, 1, RGBAFormat, UnsignedByteType);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The attributes that a map gives to the corners. */
export class MapAttributes {
  readonly share: BufferAttribute;
  readonly known: BufferAttribute;
  readonly touch: BufferAttribute;
  readonly hollow: BufferAttribute;

  constructor(private readonly data: Case) {
    const n = data.cornerVertex.length;
    this.share = new BufferAttribute(new Float32Array(n), 1);
    this.known = new BufferAttribute(new Float32Array(n), 1);
    this.touch = new BufferAttribute(new Float32Array(n), 1);
    this.hollow = new BufferAttribute(new Float32Array(n), 1);
  }

  addTo(geometry: BufferGeometry): void {
    geometry.setAttribute("share", this.share);
    geometry.setAttribute("known", this.known);
    geometry.setAttribute("touch", this.touch);
    geometry.setAttribute("hollow", this.hollow);
  }

  setState(state: State): void {
    const { cornerVertex } = this.data;
    for (let i = 0; i < cornerVertex.length; ++i) {
      this.touch.array[i] = state.touching ? state.touching[cornerVertex[i]] : 0;
      this.hollow.array[i] = state.hollow[cornerVertex[i]];
    }
    this.touch.needsUpdate = this.hollow.needsUpdate = true;
  }

  setMap(values: Float32Array | null, scale: Scale | null): void {
    const { cornerVertex } = this.data;
    for (let i = 0; i < cornerVertex.length; ++i) {
      const value = values ? values[cornerVertex[i]] : NaN;
      const share = scale ? shareOf(scale, value) : NaN;
      this.known.array[i] = Number.isNaN(share) ? 0 : 1;
      this.share.array[i] = Number.isNaN(share) ? 0 : share;
    }
    this.share.needsUpdate = this.known.needsUpdate = true;
  }
}
